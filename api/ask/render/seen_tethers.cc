#include "api/ask/render/seen_tethers.h"

#include <algorithm>

#include "fields/base/error.h"
#include "twin/agent/aboard.h"
#include "twin/agent/line_on_deck.h"

namespace slackwater::api {
namespace {

/// Where the line of a vehicle hangs from; nothing where its carrier is not there, or the vehicle
/// is beside her.
std::optional<twin::Triple<double>> top_of(
    const twin::Agent& agent, const twin::Carriage& vehicle,
    std::span<const std::optional<twin::Carriage>> vehicles) {
  if (!agent.carrier) return agent.tether_top_m;
  const std::optional<twin::Carriage>& carrier = vehicles[*agent.carrier];
  if (!carrier) return std::nullopt;
  const twin::Triple<double> deck_m = carrier->position_m + carrier->attitude.to_ned(agent.deck_m);
  const bool is_beside = agent.conduct && length_of(twin::boarding_place(agent, deck_m) -
                                                    vehicle.position_m) <= twin::boarding_reach_m;
  return is_beside ? std::nullopt : std::optional(deck_m);
}

}  // namespace

std::vector<twin::SeenTether> seen_tethers(const twin::ReadyRun& run,
                                           const twin::Scenario& scenario,
                                           std::span<const std::optional<twin::Carriage>> vehicles,
                                           double t_s) {
  std::vector<twin::SeenTether> tethers;
  const std::size_t laid_out = std::min(run.agents.size(), scenario.vehicles.size());
  for (std::size_t i = 0; i < laid_out; ++i) {
    const twin::Agent& agent = run.agents[i];
    if (!agent.tether || !vehicles[i]) continue;
    const auto top_m = top_of(agent, *vehicles[i], vehicles);
    if (!top_m) continue;
    const twin::Triple<double> end_m =
        vehicles[i]->position_m + vehicles[i]->attitude.to_ned(agent.tether->attachment_m);
    twin::SeenTether tether{agent.name + "/tether", agent.tether->diameter_m, {*top_m}};
    try {
      const double length_m = scenario.vehicles[i].tether->length_m;
      const auto hung = twin::hung_out(agent, *top_m, end_m, length_m, t_s);
      tether.at_m.insert(tether.at_m.end(), hung.node_m.begin(), hung.node_m.end());
    } catch (const Error&) {
      continue;  // it does not reach
    }
    tether.at_m.push_back(end_m);
    tethers.push_back(std::move(tether));
  }
  return tethers;
}

}  // namespace slackwater::api
