#include "twin/scenario/lay_out_surface.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/usual_sizes.h"
#include "twin/mission/cable_of_site.h"
#include "twin/mission/work_pattern.h"
#include "twin/scenario/laid_out_task.h"

namespace slackwater::twin {
namespace {

/// What a site states of the surface that an entry of a task names.
class StatedSurface {
 public:
  StatedSurface(const Config& entry, const WorkSite& site, const WorkTurbine& turbine)
      : entry_(entry), site_(site), turbine_(turbine) {}

  [[nodiscard]] PlannedSurface of(SurfaceKind kind) const {
    PlannedSurface stated;
    stated.name = turbine_.id + "/" + name_of(kind);
    const double radius_m = to_micrometre(turbine_.radius_m);
    switch (kind) {
      case SurfaceKind::monopile:
        stated.sizes = MonopileSizes{upright(0, turbine_.foot_m), radius_m, {}};
        break;
      case SurfaceKind::transition_piece: {
        TransitionPieceSizes piece;
        piece.upright =
            upright(turbine_.top_m, std::min(usual::transition_foot_depth_m, turbine_.foot_m));
        piece.radius_m = to_micrometre(turbine_.radius_m + usual::transition_wider_m);
        piece.landing_rad = landing_rad();
        stated.sizes = piece;
        break;
      }
      case SurfaceKind::tower:
        stated.sizes = TowerSizes{
            upright(entry_.has("from") ? 0 : hub_z_m() + usual::tower_below_hub_m, turbine_.top_m),
            radius_m,
            {},
            {}};
        break;
      case SurfaceKind::nacelle:
        stated.sizes = nacelle();
        break;
      case SurfaceKind::blade: {
        BladeSizes blade;
        blade.hub_m = at_axis(hub_z_m());
        if (!(turbine_.rotor_radius_m > 0))
          entry_.refuse("kind", "the site gives no rotor_diameter_m; add it to the site");
        blade.tip_m = to_micrometre(turbine_.rotor_radius_m);
        stated.sizes = blade;
        stated.name = turbine_.id + "/blade " + std::to_string(entry_.integer("blade", 1, 3));
        break;
      }
      case SurfaceKind::anodes: {
        AnodesSizes anodes;
        anodes.upright = upright(5, turbine_.foot_m - 3);
        anodes.radius_m = radius_m;
        anodes.first_bearing_rad = landing_rad();
        stated.sizes = anodes;
        break;
      }
      case SurfaceKind::mooring_line: {
        const MooringLine& line = mooring();
        stated.sizes =
            MooringLineSizes{to_micrometre(line.fairlead_m), to_micrometre(line.anchor_m), {}, {}};
        stated.name = turbine_.id + "/" + line.id;
        break;
      }
      case SurfaceKind::cable: {
        const WorkCable& laid = cable_of_site(entry_, site_, turbine_);
        CableSizes sizes;
        for (const Triple<double>& at_m : laid.route_m)
          sizes.route.push_back({to_micrometre(at_m), {}});
        sizes.burial_m = to_micrometre(laid.burial_m.value_or(usual::burial_m));
        sizes.off_ends_m = usual::off_ends_m;
        stated.sizes = sizes;
        stated.name = "cable " + laid.id;  // the same from whatever turbine
        break;
      }
      case SurfaceKind::bed:
        stated.sizes = BedSizes{at_axis(turbine_.bed_m), radius_m, {}, {}};
        break;
      case SurfaceKind::water:
        stated.sizes = WaterSizes{
            WaterSizes::Disc{to_micrometre(turbine_.north_m), to_micrometre(turbine_.east_m),
                             usual::watch_radius_m, radius_m},
            {}};
        break;
    }
    return stated;
  }

 private:
  [[nodiscard]] Triple<double> at_axis(double z_m) const {
    return to_micrometre(Triple<double>{turbine_.north_m, turbine_.east_m, z_m});
  }
  /// The entry's own levels, which may count from what stands there, or else these.
  [[nodiscard]] Upright upright(double from_m, double to_m) const {
    const auto level_m = [&](const char* key, double usual_m) {
      const auto own = entry_.optional_child(key);
      return at_axis(own ? read_level(*own, turbine_) : usual_m).z;
    };
    const Triple<double> axis_m = at_axis(0);
    return {axis_m.x, axis_m.y, level_m("from", from_m), level_m("to", to_m)};
  }
  [[nodiscard]] double landing_rad() const {
    return to_micrometre(turbine_.landing_rad * 180 / constants::pi) * constants::degree;
  }
  [[nodiscard]] double hub_z_m() const {
    if (turbine_.hub_m < 0) return turbine_.hub_m;
    entry_.refuse("kind",
                  "the site gives turbine " + turbine_.id + " no hub_height_m; add it to the site");
  }
  [[nodiscard]] NacelleSizes nacelle() const {
    const double scale =
        turbine_.rotor_radius_m > 0 ? turbine_.rotor_radius_m / usual::rotor_radius_m : 1;
    NacelleSizes nacelle;
    nacelle.hub_m = at_axis(hub_z_m());
    nacelle.length_m = to_micrometre(scale * usual::nacelle_length_m);
    nacelle.width_m = to_micrometre(scale * usual::nacelle_width_m);
    nacelle.tall_m = to_micrometre(scale * usual::nacelle_height_m);
    nacelle.ahead_m = to_micrometre(scale * usual::nacelle_ahead_m);
    return nacelle;
  }

  [[nodiscard]] const MooringLine& mooring() const {
    const std::string id = entry_.text("mooring");
    const auto found = std::find_if(turbine_.moorings.begin(), turbine_.moorings.end(),
                                    [&](const MooringLine& line) { return line.id == id; });
    if (found == turbine_.moorings.end())
      entry_.refuse("mooring", "found " + id + ", which turbine " + turbine_.id + " does not have");
    return *found;
  }

  const Config& entry_;
  const WorkSite& site_;
  const WorkTurbine& turbine_;
};

}  // namespace

PlannedSurface lay_out_surface(const Config& entry, const WorkSite& site,
                               const WorkTurbine& turbine) {
  const SurfaceKind kind = surface_kind_of(entry.text("kind"), entry, "kind");
  PlannedSurface surface = read_surface(entry, StatedSurface(entry, site, turbine).of(kind));
  entry.expect_all_read();
  return surface;
}

}  // namespace slackwater::twin
