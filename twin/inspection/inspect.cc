#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "twin/inspection/inspection.h"
#include "twin/inspection/instrument/clarity.h"
#include "twin/inspection/instrument/pointing.h"

namespace slackwater::twin {
namespace {

/// What looks go through, reused from one to the next.
struct Scratch {
  ViewScratch view;
  std::vector<SeenPatch> seen;
};
Scratch& scratch() {
  thread_local Scratch mine;
  return mine;
}

BestLook taken(const SeenPatch& seen, const Triple<double>& off_m, double t_s) {
  const LookQuality& q = seen.quality;
  BestLook look;
  look.detail_m = static_cast<float>(q.detail_m);
  look.range_m = static_cast<float>(q.range_m);
  look.incidence_cosine = static_cast<float>(q.incidence_cosine);
  look.ground_sampling_m = static_cast<float>(q.ground_sampling_m);
  look.blur_m = static_cast<float>(q.blur_m);
  look.contrast = static_cast<float>(q.contrast);
  look.light = static_cast<float>(q.light);
  look.t_s = static_cast<float>(t_s);
  look.off_north_m = static_cast<float>(off_m.x);
  look.off_east_m = static_cast<float>(off_m.y);
  look.off_down_m = static_cast<float>(off_m.z);
  return look;
}

/// A look that is as good as asked goes before one that is not; among those the one with the least
/// detail does.
void keep(const InspectionLine& line, const BestLook& look, BestLook& best) {
  const double least_cosine = std::cos(line.most_incidence_rad) - 1e-6;
  const bool is_square = look.incidence_cosine >= least_cosine;
  const bool was_square = best.is_seen() && best.incidence_cosine >= least_cosine;
  const std::uint32_t looks = best.looks + 1;
  if (!best.is_seen() || (is_square && !was_square) ||
      (is_square == was_square && look.detail_m < best.detail_m))
    best = look;
  best.looks = looks;
}

struct NearestPlace {
  Triple<double> place_m;
  std::size_t surface = 0;
  std::uint32_t patch = no_patch;
  double range_m = std::numeric_limits<double>::infinity();
};

/// The centre of the nearest patch of those that a line inspects.
NearestPlace nearest_place(const Inspection& inspection, std::size_t l,
                           const Triple<double>& from_m) {
  NearestPlace nearest;
  for (const InspectedPair& pair : inspection.pairs) {
    if (pair.line != l) continue;
    const Surface& surface = inspection.surfaces[pair.surface];
    const ViewIndex& index = inspection.indices[pair.surface];
    for (const ViewIndex::Block& block : index.blocks) {
      if (length_of(block.centre_m - from_m) - block.radius_m >= nearest.range_m) continue;
      for (std::uint32_t i = block.first; i < block.end; ++i) {
        const Triple<double>& centre_m = surface.patches[index.patches[i]].centre_m;
        if (const double range_m = length_of(centre_m - from_m); range_m < nearest.range_m)
          nearest = {centre_m, pair.surface, index.patches[i], range_m};
      }
    }
  }
  return nearest;
}

/// What an instrument that is turned to the surface is turned to.
AimedAt aimed_at(const Inspection& inspection, const Instrument& instrument,
                 const NearestPlace& nearest) {
  AimedAt target{nearest.place_m, {}};
  if (instrument.aim == Aim::surface && nearest.patch != no_patch)
    target.bend = bend_at(inspection.surfaces[nearest.surface], inspection.indices[nearest.surface],
                          nearest.patch);
  return target;
}

/// It has moved by half its footprint since its last look, or turned as much, or long enough.
bool is_due(const Instrument& instrument, const InspectionState::Line& line,
            const Carriage& carriage, double t_s) {
  if (!line.has_looked) return true;
  if (const auto* const spot = std::get_if<SpotFootprint>(&instrument.footprint))
    return t_s - line.looked_s >= spot->dwell_s;
  const double step_m = step_between_looks_m(instrument, line.range_m);
  if (length_of(carriage.position_m - line.place_m) >= step_m) return true;
  if (instrument.aim == Aim::surface) return false;
  const double turned = length_of(carriage.attitude.to_ned({1, 0, 0}) - line.ahead);
  return turned * line.range_m >= step_m;
}

/// Whether it can look: a probe stands on one place while its vehicle has hardly moved, which is
/// what an arm and a pilot's hand make up for, an estimate.
bool is_steady(const Instrument& instrument, const InspectionState::Line& line,
               const Carriage& carriage) {
  constexpr double made_up_for_m = 0.3;
  return !std::holds_alternative<SpotFootprint>(instrument.footprint) ||
         (line.has_looked && length_of(carriage.position_m - line.place_m) <= made_up_for_m);
}

/// In which a look is taken.
Clarity clarity_about(const Inspection& inspection, const Sight& sight, const Pose& now) {
  const bool is_wet = now.position_m.z > 0;
  const Clarity& own = is_wet ? inspection.plan.water : inspection.plan.air;
  const auto& visibility_m = is_wet ? sight.water_visibility_m : sight.air_visibility_m;
  if (!visibility_m) return own;
  return seen_through(own, *visibility_m, is_wet ? Medium::water : Medium::air);
}

/// The instrument as it is set now: its own, or a zoomed copy.
const Instrument& as_set(const Instrument& instrument, const CameraPointing& camera) {
  if (camera.zoom == 1 || !is_pointed(instrument)) return instrument;
  thread_local Instrument zoomed;
  zoomed = instrument;
  zoom_in(camera.zoom, zoomed);
  return zoomed;
}

struct Meanwhile {
  double from_s = 0;
  double to_s = 0;
};

/// One look of a line at each of its surfaces.
void take(const Inspection& inspection, std::size_t l, const Instrument& instrument,
          const Clarity& clarity, const Pose& before, const Pose& now, const Meanwhile& meanwhile,
          const Triple<double>& off_m, InspectionState& state) {
  InspectionState::Line& line = state.lines[l];
  Scratch& mine = scratch();
  for (std::size_t i = 0; i < inspection.pairs.size(); ++i) {
    if (inspection.pairs[i].line != l) continue;
    const std::size_t s = inspection.pairs[i].surface;
    const ViewedSurface viewed{inspection.surfaces[s], inspection.indices[s], *inspection.caster,
                               static_cast<std::uint32_t>(s)};
    view(instrument, before, now, viewed, clarity, {inspection.rays_per_look, line.looks},
         mine.view, mine.seen);
    state.rays += mine.view.rays;
    for (const SeenPatch& seen : mine.seen)
      keep(inspection.plan.lines[l],
           taken(seen, off_m, meanwhile.from_s + seen.share * (meanwhile.to_s - meanwhile.from_s)),
           state.best[i][seen.patch]);
  }
  ++line.looks;
}

}  // namespace

InspectionState begin_inspection(const Inspection& inspection, std::uint64_t seed) {
  InspectionState state;
  state.seed = seed;
  state.lines.resize(inspection.plan.lines.size());
  for (const InspectedPair& pair : inspection.pairs)
    state.best.emplace_back(inspection.surfaces[pair.surface].patches.size());
  return state;
}

void inspect(const Inspection& inspection, bool is_at_work, const Carriage& carriage,
             const Triple<double>& known_m, double t_s, double dt_s, InspectionState& state,
             const Sight& sight) {
  if (!is_at_work) {
    // What it passed meanwhile was not looked at: no fan sweeps over it.
    for (InspectionState::Line& line : state.lines) line.has_looked = false;
    return;
  }
  state.worked_s += dt_s;
  for (std::size_t l = 0; l < state.lines.size(); ++l) {
    const Instrument& instrument = as_set(inspection.instruments[l], sight.camera);
    InspectionState::Line& line = state.lines[l];
    if (!is_due(instrument, line, carriage, t_s)) continue;
    const NearestPlace nearest = nearest_place(inspection, l, carriage.position_m);
    Pose now = pose_of(instrument, carriage, aimed_at(inspection, instrument, nearest));
    if (is_pointed(instrument) && sight.camera != CameraPointing())
      now = pointed(now, carriage, sight.camera);
    if (is_steady(instrument, line, carriage))
      take(inspection, l, instrument, clarity_about(inspection, sight, now),
           line.has_looked ? line.pose : now, now, {line.has_looked ? line.looked_s : t_s, t_s},
           known_m - carriage.position_m, state);
    line.pose = now;
    line.place_m = carriage.position_m;
    line.ahead = carriage.attitude.to_ned({1, 0, 0});
    line.range_m = nearest.range_m;
    line.looked_s = t_s;
    line.has_looked = true;
  }
}

}  // namespace slackwater::twin
