#include "tests/fuzz/granule_oracle.h"

#include <algorithm>
#include <cmath>

#include "ingest/cf/granule_file.h"
#include "tests/fuzz/fuzz_case.h"

namespace slackwater::fuzz {
namespace {

/// Values read back from one granule; a small input rarely makes more, and the oracle must stay
/// quick.
constexpr std::size_t most_read_back = std::size_t{1} << 20;

void claim_sound_axes(const Grid& grid) {
  expect_canonical(grid);
  claim(grid.latitude_deg.front() >= -90 && grid.latitude_deg.back() <= 90,
        "a latitude beyond a pole");
  claim(grid.longitude_deg.back() - grid.longitude_deg.front() <= 360.0 + 1e-3,
        "longitudes go round more than once");
  for (const double level : grid.levels_m)
    claim(std::isfinite(level), "a level that is not finite");
  const UtcTime earliest = parse_utc("1400-01-01T00:00:00Z");
  const UtcTime latest = parse_utc("2700-01-01T00:00:00Z");
  for (const TimeCell& cell : grid.time) {
    claim(cell.start <= cell.end, "an interval that ends before it starts");
    claim(cell.start >= earliest && cell.end <= latest,
          "a time outside the years that are admitted");
  }
}

void claim_sound_values(const ingest::GranuleFile& file, const GranuleVariable& variable) {
  const Grid& grid = file.granule().grid;
  const std::size_t slab = std::max<std::size_t>(1, grid.levels() * grid.rows() * grid.columns());
  const std::size_t times = std::min(grid.times(), most_read_back / slab);
  if (times == 0) return;
  const GriddedField field =
      file.read(variable.standard_name, 0, times, 0, grid.rows(), 0, grid.columns());
  claim(field.values.size() == times * slab, "a field of another size than was asked for");
  claim(field.status.empty() || field.status.size() == field.values.size(),
        "a status for some values only");
  claim(variable.has_status == !field.status.empty(),
        "a status that was announced and is not there");
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    claim(!std::isinf(field.values[i]), "an infinite value");
    if (!field.status.empty()) {
      claim(has_value(field.status[i]) == !std::isnan(field.values[i]),
            "a value and its status disagree");
    }
  }
}

}  // namespace

const ingest::ProductCatalogue& products() {
  static const ingest::ProductCatalogue catalogue =
      ingest::ProductCatalogue::load(SLACKWATER_PRODUCTS);
  return catalogue;
}

void claim_sound(const ingest::Ingested& ingested, bool names_are_ours) {
  claim(!ingested.granules.empty(), "accepted without any granule");
  for (const ingest::DecodedGranule& decoded : ingested.granules) {
    const Granule& granule = decoded.granule;
    claim_sound_axes(granule.grid);
    claim(!granule.variables.empty(), "a granule without variables");
    claim(granule.status != DataStatus::forecast || granule.reference_time.has_value(),
          "a forecast that does not say when it was issued");
    const ingest::GranuleFile file = ingest::GranuleFile::open(decoded.content_file);
    claim(file.granule().grid == granule.grid, "the axes do not survive the content file");
    claim(file.granule().variables.size() == granule.variables.size(),
          "a variable is lost in the content file");
    for (const GranuleVariable& variable : granule.variables) {
      if (names_are_ours) {
        const ingest::Quantity* quantity =
            products().vocabulary().by_standard_name(variable.standard_name);
        claim(quantity != nullptr && quantity->standard_name == variable.standard_name,
              "a quantity that is not ours");
        claim(quantity->unit == variable.unit, "a unit that is not canonical");
      }
      claim_sound_values(file, variable);
    }
  }
}

}  // namespace slackwater::fuzz
