#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "api/door/edr/read/bbox.h"
#include "api/door/edr/read/datetime.h"
#include "api/door/edr/read/distance.h"
#include "api/door/edr/read/resolution.h"
#include "api/door/edr/read/vertical.h"
#include "api/door/edr/read/wkt.h"
#include "tests/fuzz/fuzz_case.h"

namespace {

using namespace slackwater;
using namespace slackwater::api::edr;

/// Offsets reach beyond the years that the form can write.
bool can_be_written(const TimeRange& range) {
  const TimeRange years{parse_utc("0000-01-01T00:00:00Z"), parse_utc("9999-12-31T23:59:59.999Z")};
  return years.contains(range.from.value_or(*years.from)) &&
         years.contains(range.to.value_or(*years.to));
}

void check_datetime(std::string_view text) {
  fuzz::accepts([&] {
    const TimeRange range = parse_datetime(text);
    fuzz::claim(!range.from || !range.to || *range.from <= *range.to, "an interval runs backwards");
    if (!can_be_written(range)) return;
    fuzz::claim(parse_datetime(format_datetime(range)) == range,
                "a datetime changes when it is written and read");
  });
}

void check_vertical(std::string_view text) {
  fuzz::accepts([&] {
    const VerticalQuery query = parse_vertical(text);
    if (const auto* range = std::get_if<LevelRange>(&query)) {
      fuzz::claim(range->low <= range->high, "a range of levels runs backwards");
      fuzz::claim(std::abs(range->low) <= max_vertical_m && std::abs(range->high) <= max_vertical_m,
                  "a level out of range");
      return;
    }
    const Levels& levels = std::get<Levels>(query);
    fuzz::claim(!levels.empty() && levels.size() <= max_levels, "none, or too many levels");
    fuzz::claim(std::is_sorted(levels.begin(), levels.end(), std::less_equal<>()),
                "levels ascend, none twice");
    fuzz::claim(std::all_of(levels.begin(), levels.end(),
                            [](double z) { return std::abs(z) <= max_vertical_m; }),
                "a level out of range");
  });
}

void check_others(std::string_view text) {
  fuzz::accepts([&] {
    const BoundingBox box = parse_bbox(text);
    fuzz::claim(box.box.west_deg <= box.box.east_deg && box.box.south_deg <= box.box.north_deg,
                "a box inside out");
  });
  fuzz::accepts([&] {
    const double metres = parse_distance_m("within", text, "within-units", "km");
    fuzz::claim(metres > 0 && std::isfinite(metres), "a distance that is none");
  });
  fuzz::accepts([&] { (void)parse_distance_m("within", "1", "within-units", text); });
  fuzz::accepts([&] {
    const auto count = parse_resolution("resolution-x", text);
    fuzz::claim(!count || (*count > 0 && *count <= max_resolution), "a resolution out of range");
  });
}

}  // namespace

/// The short parameters of EDR queries: times, levels, boxes, distances.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  check_datetime(text);
  check_vertical(text);
  check_others(text);
  return 0;
}
