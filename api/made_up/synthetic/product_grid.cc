#include "api/made_up/synthetic/product_grid.h"

#include <algorithm>

#include "fields/base/check.h"

namespace slackwater::api {
namespace {

std::vector<double> centred_axis(double centre_deg, double step_deg, std::size_t size) {
  const std::size_t middle = size / 2;
  std::vector<double> axis;
  axis.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    axis.push_back(centre_deg + (static_cast<double>(i) - static_cast<double>(middle)) * step_deg);
  }
  return axis;
}

}  // namespace

const std::vector<double>& synthetic_levels_m() {
  static const std::vector<double> levels{0, 3, 5, 10, 15, 20, 25, 30, 40, 50, 60, 75};
  return levels;
}

ProductAxes::ProductAxes(const SyntheticOcean& ocean, const SyntheticGrid& grid)
    : latitude_deg(centred_axis(ocean.settings().site.latitude_deg(), 1.0 / 74, grid.rows)),
      longitude_deg(centred_axis(ocean.settings().site.longitude_deg(), 1.0 / 33, grid.columns)) {
  expects(grid.rows > 1 && grid.columns > 1, "a synthetic product has at least 2 x 2 cells");
}

std::vector<UtcTime> hourly_instants(UtcDay first, UtcDay last) {
  expects(first <= last, "the first day is not after the last");
  const auto days = static_cast<int>((last - first).count()) + 1;
  return hourly_instants(UtcTime(first), 24 * days - 1);
}

std::vector<UtcTime> hourly_instants(UtcTime start, int hours) {
  std::vector<UtcTime> instants;
  for (int hour = 0; hour <= hours; ++hour) instants.push_back(start + std::chrono::hours{hour});
  return instants;
}

std::filesystem::path product_path(const std::filesystem::path& folder, const std::string& dataset,
                                   UtcDay first, UtcDay last, const std::string& extension) {
  std::filesystem::create_directories(folder);
  const std::string until = first == last ? "" : "_" + format_day(last);
  return folder / (dataset + "_" + format_day(first) + until + extension);
}

std::filesystem::path forecast_path(const std::filesystem::path& folder, const std::string& dataset,
                                    UtcTime issued, const std::string& extension) {
  std::filesystem::create_directories(folder);
  std::string stamp = format_utc(issued);
  std::erase_if(stamp, [](char c) { return c == '-' || c == ':'; });
  return folder / (dataset + "_fc" + stamp + extension);
}

}  // namespace slackwater::api
