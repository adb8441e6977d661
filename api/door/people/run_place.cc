#include "api/door/people/run_place.h"

#include "api/door/people/ground.h"
#include "api/door/people/told.h"

namespace slackwater::people {

RunPlace run_place(const api::ScenarioWater& water, std::span<const twin::Agent> agents,
                   UtcTime start, GeoPoint origin) {
  const twin::Agent& any = agents.front();
  return {water, *any.water, any.vessels.get(), start, origin};
}

RunPlace run_place(const api::RunInHand& hand) {
  return run_place(hand.water, hand.run.agents(), hand.start, hand.origin);
}

nlohmann::json place_facts(const RunPlace& place, std::span<const Horizontal> vehicles_m) {
  const twin::Environment& environment = place.sampler.environment();
  return {
      {"water", water_json(place.water)},       {"turbines", turbines_json(environment.turbines)},
      {"sea", sea_json(environment.sea.get())}, {"bed", bed_json(place, vehicles_m)},
      {"cables", cables_json(place)},           {"moorings", moorings_json(place.water.lines)}};
}

std::vector<Horizontal> places_of(std::span<const twin::AgentState> states) {
  std::vector<Horizontal> places;
  for (const twin::AgentState& state : states)
    places.emplace_back(state.vehicle.body.position_m.y, state.vehicle.body.position_m.x);
  return places;
}

}  // namespace slackwater::people
