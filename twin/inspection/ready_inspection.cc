#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/numbers/statistics.h"
#include "fields/base/text.h"
#include "twin/curve/named_file.h"
#include "twin/inspection/defect/defect_plan.h"
#include "twin/inspection/inspection.h"
#include "twin/inspection/surface/make_surface.h"

namespace slackwater::twin {
namespace {

constexpr double widest_rad = 1.2;           // half a fan's angle that is reckoned with
constexpr double rough_patch_m = 2;          // of surfaces whose distance is looked up
constexpr double most_patches_per_ray = 50;  // of one surface: what a whole mission can look at

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorKind::invalid_input, "inspection: " + what);
}

bool inspects(const InspectionLine& line, SurfaceKind kind) {
  return std::find(line.kinds.begin(), line.kinds.end(), kind) != line.kinds.end();
}

double distance_m(const Surface& surface, const Triple<double>& at_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Patch& patch : surface.patches)
    nearest_m = std::min(nearest_m, length_of(at_m - patch.centre_m));
  return nearest_m;
}

/// Places of the way, no more than some metres apart, but for long legs.
std::vector<Triple<double>> places_of(std::span<const Waypoint> way) {
  constexpr double apart_m = 5;
  constexpr double most_of_leg = 40;
  std::vector<Triple<double>> places_m;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Triple<double>& to_m = way[i].position_m;
    const Triple<double>& from_m = i > 0 ? way[i - 1].position_m : to_m;
    const double parts =
        std::clamp(std::ceil(length_of(to_m - from_m) / apart_m), 1.0, most_of_leg);
    for (double part = 1; part <= parts; ++part)
      places_m.push_back(from_m + part / parts * (to_m - from_m));
  }
  return places_m;
}

/// From where the work goes by the surface within the instrument's reach: the median.
double working_range_m(const Instrument& instrument, const Surface& surface,
                       std::span<const Triple<double>> places_m, double slack_m) {
  std::vector<double> ranges_m;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Triple<double>& place_m : places_m) {
    const double range_m = distance_m(surface, place_m);
    nearest_m = std::min(nearest_m, range_m);
    if (range_m <= instrument.most_range_m + slack_m) ranges_m.push_back(range_m);
  }
  if (ranges_m.empty())
    refuse(
        formatted("its work stays {:.1f} m off {}, and the {} reaches {:g} m; go nearer, or take "
                  "an instrument that sees farther",
                  nearest_m, surface.name, instrument.name, instrument.most_range_m));
  return std::clamp(upper_median(std::move(ranges_m)), instrument.least_range_m,
                    instrument.most_range_m);
}

/// What one look holds at a range.
double footprint_area_m2(const Instrument& instrument, double range_m) {
  if (const auto* const frame = std::get_if<FrameFootprint>(&instrument.footprint))
    return 4 * range_m * range_m * std::tan(0.5 * frame->horizontal_rad) *
           std::tan(0.5 * frame->vertical_rad);
  if (const auto* const fan = std::get_if<FanFootprint>(&instrument.footprint))
    return 2 * range_m * std::tan(std::min(0.5 * fan->across_rad, widest_rad)) *
           step_between_looks_m(instrument, range_m);
  if (const auto* const spot = std::get_if<SpotFootprint>(&instrument.footprint))
    return constants::pi * spot->speaks_for_m * spot->speaks_for_m;
  return constants::pi * instrument.most_range_m * instrument.most_range_m;
}

/// As long a side as lets a look at that range spend its rays on the patches of its footprint.
double patch_for(const Instrument& instrument, double range_m, const Surface& surface,
                 std::size_t rays) {
  const double held_m2 = std::min(footprint_area_m2(instrument, range_m), surface.area_m2());
  return std::sqrt(held_m2 / static_cast<double>(rays));
}

/// Whether something looks at it all round, at once and from afar: it hardly looks twice.
bool is_looked_round(const Inspection& ready, std::size_t surface) {
  return std::any_of(ready.pairs.begin(), ready.pairs.end(), [&](const InspectedPair& pair) {
    return pair.surface == surface &&
           std::holds_alternative<RoundFootprint>(ready.instruments[pair.line].footprint);
  });
}

/// Until one look has a ray for each patch: those beyond its rays would stay unseen, whatever is in
/// reach.
void coarsen(const PlannedSurface& planned, std::size_t rays, double patch_m, Surface& surface) {
  constexpr double coarser = 1.1;
  constexpr int most_tries = 40;
  for (int i = 0; i < most_tries && surface.patches.size() > rays; ++i)
    surface = make_surface(planned, patch_m *= coarser);
}

}  // namespace

std::shared_ptr<const Inspection> ready_inspection(const std::string& inspector,
                                                   const InspectionPlan& plan,
                                                   std::span<const Waypoint> way,
                                                   const std::filesystem::path& data_folder,
                                                   std::size_t rays_per_look) {
  auto ready = std::make_shared<Inspection>();
  ready->inspector = inspector;
  ready->plan = plan;
  ready->rays_per_look = plan.rays_per_look.value_or(rays_per_look);
  for (const InspectionLine& line : plan.lines)
    ready->instruments.push_back(read_named_instrument(line.instrument, data_folder));
  const std::vector<Triple<double>> places_m = places_of(way);
  std::vector<TriangleMesh> meshes;
  for (std::size_t s = 0; s < plan.surfaces.size(); ++s) {
    const PlannedSurface& planned = plan.surfaces[s];
    const Surface rough = make_surface(planned, rough_patch_m);
    double patch_m = std::numeric_limits<double>::infinity();
    for (std::size_t l = 0; l < plan.lines.size(); ++l) {
      if (!inspects(plan.lines[l], rough.kind)) continue;
      const Instrument& instrument = ready->instruments[l];
      const double range_m = working_range_m(instrument, rough, places_m, rough_patch_m);
      ready->pairs.push_back({l, s, range_m});
      patch_m = std::min(patch_m, patch_for(instrument, range_m, rough, ready->rays_per_look));
    }
    if (!std::isfinite(patch_m)) patch_m = rough_patch_m;  // it only stands in the way
    // No finer than all looks of a mission together can see.
    const double most = most_patches_per_ray * static_cast<double>(ready->rays_per_look);
    patch_m = std::max(patch_m, std::sqrt(rough.area_m2() / most));
    ready->surfaces.push_back(make_surface(planned, plan.patch_m.value_or(patch_m)));
    if (!plan.patch_m && is_looked_round(*ready, s))
      coarsen(planned, ready->rays_per_look, patch_m, ready->surfaces.back());
    meshes.push_back(ready->surfaces.back().mesh);
    ready->indices.push_back(view_index(ready->surfaces.back()));
  }
  ready->facts = read_defect_facts(
      open_named(plan.defect_facts, "inspection: defect_facts", data_folder / "defects"));
  ready->methods = read_detection_methods(plan.detection, data_folder);
  (void)plant(plan.defects, ready->surfaces, ready->facts, 0);  // refused here, or never
  ready->caster = std::make_unique<const RayCaster>(meshes);
  return ready;
}

}  // namespace slackwater::twin
