#include "twin/mission/read_lookout.h"

#include "twin/mission/reach.h"
#include "twin/mission/read_seconds.h"

namespace slackwater::twin {
namespace {

Triple<double> read_surface_place(const Config& place) {
  return {place.number("north_m", within_reach_m), place.number("east_m", within_reach_m), 0};
}

}  // namespace

PersonSearch read_person_search(const Config& config) {
  PersonSearch search;
  search.person = config.optional_text("person").value_or(search.person);
  search.object = config.text("object");
  search.lookout = config.text("lookout");
  if (const auto place = config.optional_child("last_known"))
    search.last_known_m = read_surface_place(*place);
  search.radius_m = config.number("radius_m", {0, 20e3});
  search.elapsed_s = read_seconds(config, "elapsed", {0, 7200});
  search.diffusivity_m2_s = config.optional_number("diffusivity_m2_s", {0, 100}).value_or(0);
  search.visibility_m = config.number("visibility_m", {1, 100e3});
  return search;
}

MammalDuty read_mammal_duty(const Config& config) {
  MammalDuty duty;
  duty.animals = config.optional_text("animals").value_or(duty.animals);
  duty.animal = config.text("animal");
  duty.watch = config.text("watch");
  duty.count = static_cast<std::size_t>(config.integer("count", 0, 1000));
  duty.half_side_m = config.number("half_side_m", {10, 50e3});
  if (const auto place = config.optional_child("noise")) duty.noise_m = read_surface_place(*place);
  duty.noise.radius_m = config.number("radius_m", {1, 20e3});
  duty.noise.watch_s = read_seconds(config, "clear_for", {0, 86400});
  if (has_seconds(config, "noise_for"))
    duty.noise.wanted_s = read_seconds(config, "noise_for", {0, 86400});
  if (has_seconds(config, "again_after"))
    duty.again_after_s = read_seconds(config, "again_after", {0, 86400});
  if (duty.noise.radius_m > duty.half_side_m)
    config.refuse("radius_m", "is beyond half_side_m, the square that the animals swim in");
  return duty;
}

}  // namespace slackwater::twin
