#include "calibration/verify/skill_entry.h"

#include <algorithm>
#include <sstream>

#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::calibration {

std::string_view unit_of(std::string_view variable) {
  if (variable == current_variable || variable == wind_variable) return "m s-1";
  expects(variable == wave_variable, "a variable that is scored has a unit");
  return "m";
}

double rmse_of(const SkillEntry& entry) noexcept {
  return entry.scalar ? entry.scalar->rmse : entry.vector.rmse_m_s;
}

bool holds(const DepthBand& band, double depth_m, double water_depth_m) noexcept {
  const double place = band.above_bed ? std::max(0.0, water_depth_m - depth_m) : depth_m;
  return place >= band.from_m && place <= band.to_m;
}

std::vector<DepthBand> standard_bands() {
  return {{0, whole_column_m, false},  {0, 5, false}, {5, 20, false}, {20, 50, false},
          {50, whole_column_m, false}, {0, 5, true}};
}

std::vector<DepthBand> parse_bands(const std::string& text) {
  std::vector<double> edges;
  std::istringstream stream(text);
  std::string part;
  const auto refuse = [&] {
    return Error(ErrorKind::usage,
                 "found bands '" + text +
                     "', expected ascending depths in metres such as 0,150 or 0,5,20,50");
  };
  while (std::getline(stream, part, ',')) {
    std::size_t used = 0;
    try {
      edges.push_back(std::stod(part, &used));
    } catch (const std::exception&) {
      throw refuse();
    }
    if (used != part.size() || !(edges.back() >= 0 && edges.back() <= whole_column_m))
      throw refuse();
    if (edges.size() > 1 && !(edges.back() > edges[edges.size() - 2])) throw refuse();
  }
  if (edges.size() < 2) throw refuse();
  std::vector<DepthBand> bands;
  for (std::size_t i = 1; i < edges.size(); ++i) bands.push_back({edges[i - 1], edges[i], false});
  return bands;
}

}  // namespace slackwater::calibration
