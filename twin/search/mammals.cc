#include "twin/search/mammals.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "twin/curve/named_file.h"

namespace slackwater::twin {

MammalKind read_mammal(const std::string& name, const std::filesystem::path& data_folder) {
  const Config c = open_named(name, "mammals: animal", data_folder / "mammals");
  MammalKind kind;
  kind.name = c.text("name");
  (void)c.text("source");
  (void)c.text("status");
  kind.surfaces_every_s = c.number("surfaces_every_s", {1, 86400});
  kind.calls_every_s = c.number("calls_every_s", {0.1, 1e6});
  kind.speed_m_s = c.number("speed_m_s", {0, 15});
  kind.turns_every_s = c.number("turns_every_s", {1, 1e6});
  c.expect_all_read();
  return kind;
}

MammalsState begin_swim(const Mammals& mammals, Rng rng) {
  MammalsState state;
  state.animals.resize(mammals.count);
  for (Mammal& animal : state.animals) {
    const double side_m = mammals.half_side_m;
    animal.position_m.x = mammals.north_m + rng.uniform(-side_m, side_m);
    animal.position_m.y = mammals.east_m + rng.uniform(-side_m, side_m);
    animal.course_rad = rng.uniform(0, 2 * constants::pi);
  }
  state.rng = rng;
  return state;
}

void swim(const Mammals& mammals, double dt_s, MammalsState& state) noexcept {
  const MammalKind& kind = mammals.kind;
  const auto happens = [&](double every_s) {
    return state.rng.uniform() < -std::expm1(-dt_s / every_s);
  };
  const auto within = [&](double at_m, double middle_m) {
    return middle_m + std::remainder(at_m - middle_m, 2 * mammals.half_side_m);
  };
  for (Mammal& animal : state.animals) {
    animal.position_m.x = within(
        animal.position_m.x + kind.speed_m_s * dt_s * std::cos(animal.course_rad), mammals.north_m);
    animal.position_m.y = within(
        animal.position_m.y + kind.speed_m_s * dt_s * std::sin(animal.course_rad), mammals.east_m);
    const double course_rad = state.rng.uniform(0, 2 * constants::pi);
    if (happens(kind.turns_every_s)) animal.course_rad = course_rad;
    animal.surfaced = happens(kind.surfaces_every_s) ? 1 : 0;
    animal.called = happens(kind.calls_every_s) ? 1 : 0;
  }
}

std::size_t count_within(const MammalsState& state, const Triple<double>& place_m,
                         double radius_m) noexcept {
  return static_cast<std::size_t>(
      std::count_if(state.animals.begin(), state.animals.end(), [&](const Mammal& animal) {
        return std::hypot(animal.position_m.x - place_m.x, animal.position_m.y - place_m.y) <=
               radius_m;
      }));
}

}  // namespace slackwater::twin
