#include "twin/inspection/resurvey_way.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <variant>

#include "fields/base/numbers/statistics.h"
#include "twin/inspection/inspection_outcome.h"

namespace slackwater::twin {
namespace {

constexpr double enough_left = 0.25;   // of a cell, for a stand
constexpr double cell_of_steps = 1.3;  // two thirds of a footprint, of which a step is a half
constexpr double nearest_share = 0.5;  // of the distance that the work had
constexpr double probe_cell_m = 2;
constexpr double deepest_dip_m = 0.3;  // of what swims, below the surface at least
constexpr double lowest_flight_m = 2;

struct Cell {
  Triple<double> centre_m;  ///< sum, by area
  Triple<double> normal;    ///< sum, by area
  double left_m2 = 0;
  double area_m2 = 0;
};

/// How far off to look from.
double range_of(const InspectedPair& pair, const Inspection& inspection,
                std::span<const BestLook> best, ResurveyWay& way) {
  const InspectionLine& line = inspection.plan.lines[pair.line];
  const Instrument& instrument = inspection.instruments[pair.line];
  std::vector<double> details, blurs;
  for (const BestLook& look : best) {
    if (!look.is_seen() || look.detail_m <= line.detail_m) continue;
    details.push_back(look.detail_m);
    blurs.push_back(look.blur_m > look.ground_sampling_m ? 1 : 0);
  }
  double nearer = 1;
  if (!details.empty()) {
    if (upper_median(std::move(blurs)) > 0.5) way.asks_slower = true;
    nearer = std::clamp(line.detail_m / upper_median(std::move(details)), nearest_share, 1.0);
  }
  return std::clamp(pair.range_m * nearer, instrument.least_range_m,
                    0.95 * instrument.most_range_m);
}

using Cells = std::map<std::pair<long, long>, Cell>;

Cells cells_left(const Inspection& inspection, const InspectedPair& pair,
                 std::span<const BestLook> best, double cell_m, ResurveyWay& way) {
  const Surface& surface = inspection.surfaces[pair.surface];
  const InspectionLine& line = inspection.plan.lines[pair.line];
  Cells cells;
  for (std::size_t p = 0; p < surface.patches.size(); ++p) {
    const Patch& patch = surface.patches[p];
    Cell& cell = cells[{std::lround(std::floor(patch.along_m / cell_m)),
                        std::lround(std::floor(patch.down_m / cell_m))}];
    cell.area_m2 += patch.area_m2;
    if (is_covered(line, best[p])) continue;
    cell.left_m2 += patch.area_m2;
    cell.centre_m = cell.centre_m + patch.area_m2 * patch.centre_m;
    cell.normal = cell.normal + patch.area_m2 * patch.normal;
    way.left_m2 += patch.area_m2;
    if (best[p].is_seen()) way.poorly_m2 += patch.area_m2;
  }
  return cells;
}

bool is_free(const Triple<double>& at_m, std::span<const Structure> structures, bool is_in_water,
             double clear_m) {
  if (is_in_water ? at_m.z < deepest_dip_m : at_m.z > -lowest_flight_m) return false;
  return std::all_of(structures.begin(), structures.end(), [&](const Structure& structure) {
    return signed_distance_m(structure, at_m) >= clear_m;
  });
}

}  // namespace

ResurveyWay resurvey_way(const Inspection& inspection, const InspectionState& state,
                         std::span<const Structure> structures, bool is_in_water, double clear_m) {
  ResurveyWay way;
  std::vector<ResurveyWay::Stand> back;
  for (std::size_t i = 0; i < inspection.pairs.size(); ++i) {
    const InspectedPair& pair = inspection.pairs[i];
    const Instrument& instrument = inspection.instruments[pair.line];
    const double range_m = range_of(pair, inspection, state.best[i], way);
    const auto* const spot = std::get_if<SpotFootprint>(&instrument.footprint);
    const double cell_m =
        spot != nullptr ? probe_cell_m : cell_of_steps * step_between_looks_m(instrument, range_m);
    const Cells cells = cells_left(inspection, pair, state.best[i], cell_m, way);
    std::map<long, std::vector<ResurveyWay::Stand>> columns;
    for (const auto& [place, cell] : cells) {
      if (cell.left_m2 < enough_left * cell.area_m2 || !(length_of(cell.normal) > 0)) continue;
      const Triple<double> at_m =
          (1 / cell.left_m2) * cell.centre_m + (range_m / length_of(cell.normal)) * cell.normal;
      if (is_free(at_m, structures, is_in_water, clear_m))
        columns[place.first].push_back({at_m, spot != nullptr ? 2 * spot->dwell_s : 0});
    }
    std::size_t n = 0;
    for (auto& [column, stands] : columns) {
      const bool is_out = n % 2 == 0;
      if ((n / 2) % 2 == 1) std::reverse(stands.begin(), stands.end());
      auto& end = is_out ? way.stands : back;
      end.insert(end.end(), stands.begin(), stands.end());
      ++n;
    }
    way.stands.insert(way.stands.end(), back.rbegin(), back.rend());
    back.clear();
  }
  return way;
}

}  // namespace slackwater::twin
