#include "ingest/grib/regular_grid.h"

#include <cmath>
#include <string>

#include "fields/base/error.h"
#include "ingest/cf/axis_order.h"

namespace slackwater::ingest::grib {
namespace {

constexpr long most_points = 8L << 20U;

/// GRIB 2 counts micro-degrees; rounding to them gives equal axes from equal headers.
double to_microdegree(double degrees) { return std::round(degrees * 1e6) / 1e6; }

[[noreturn]] void refuse(const Message& message, const std::string& what) {
  throw Error(ErrorKind::invalid_input, message.name() + ": " + what);
}

void expect_regular(const Message& message) {
  const std::string type = message.text_if_any("gridType").value_or("unknown");
  if (type == "regular_ll") return;
  refuse(
      message,
      "found gridType '" + type +
          "'; expected a regular latitude-longitude grid (regular_ll): regrid it, e.g. with `cdo "
          "remapbil,r1440x721 in.grib out.grib`, or ask for a 'grid' when downloading");
}

std::vector<double> latitudes_of(const Message& message, std::size_t nj) {
  const double first = message.real("latitudeOfFirstGridPointInDegrees");
  const double last = message.real("latitudeOfLastGridPointInDegrees");
  if (!(std::abs(first) <= 90.0) || !(std::abs(last) <= 90.0)) {
    refuse(message, "latitudes run from " + std::to_string(first) + " to " + std::to_string(last) +
                        "; expected them within -90 and 90");
  }
  const bool northwards = message.integer("jScansPositively") != 0;
  if (nj > 1 && (northwards ? last <= first : last >= first)) {
    refuse(message, "scans " + std::string(northwards ? "northwards" : "southwards") +
                        " but its latitudes run from " + std::to_string(first) + " to " +
                        std::to_string(last) + "; the file is damaged");
  }
  std::vector<double> latitudes(nj, to_microdegree(first));
  for (std::size_t j = 1; j < nj; ++j) {
    latitudes[j] = to_microdegree(first + (last - first) * static_cast<double>(j) /
                                              static_cast<double>(nj - 1));
  }
  return latitudes;
}

/// Longitudes in scan order, running on across Greenwich and the antimeridian.
std::vector<double> longitudes_of(const Message& message, std::size_t ni) {
  const double first = message.real("longitudeOfFirstGridPointInDegrees");
  const double last = message.real("longitudeOfLastGridPointInDegrees");
  if (!(std::abs(first) <= 360.0) || !(std::abs(last) <= 360.0)) {
    refuse(message, "longitudes run from " + std::to_string(first) + " to " + std::to_string(last) +
                        "; expected degrees");
  }
  std::vector<double> longitudes(ni, to_microdegree(first));
  if (ni == 1) return longitudes;
  const bool westwards = message.integer("iScansNegatively") != 0;
  double width = std::fmod(westwards ? first - last : last - first, 360.0);
  if (width <= 0.0) width += 360.0;
  const double step = (westwards ? -width : width) / static_cast<double>(ni - 1);
  for (std::size_t i = 1; i < ni; ++i)
    longitudes[i] = to_microdegree(first + step * static_cast<double>(i));
  return longitudes;
}

}  // namespace

RegularGrid regular_grid_of(const Message& message, const std::optional<BoundingBox>& cut) {
  expect_regular(message);
  const long ni = message.integer_if_any("Ni").value_or(0);
  const long nj = message.integer_if_any("Nj").value_or(0);
  if (ni < 1 || nj < 1 || ni > most_points || nj > most_points || ni * nj > most_points) {
    refuse(message, "found " + std::to_string(ni) + " x " + std::to_string(nj) +
                        " points; expected 1 to " + std::to_string(most_points) +
                        ": request an area or a coarser grid");
  }
  RegularGrid grid;
  grid.ni = static_cast<std::size_t>(ni);
  grid.nj = static_cast<std::size_t>(nj);
  grid.columns_first = message.integer("jPointsAreConsecutive") != 0;
  grid.alternating = message.integer_if_any("alternativeRowScanning").value_or(0) != 0;
  with_context(message.name(), [&] {
    AxisOrder rows = latitude_axis(latitudes_of(message, grid.nj), cut);
    grid.latitude_deg = std::move(rows.values);
    grid.source_row = std::move(rows.source);
    AxisOrder columns = longitude_axis(longitudes_of(message, grid.ni), cut);
    grid.longitude_deg = std::move(columns.values);
    grid.source_column = std::move(columns.source);
  });
  return grid;
}

}  // namespace slackwater::ingest::grib
