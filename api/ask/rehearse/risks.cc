#include "api/ask/rehearse/risks.h"

namespace slackwater::api {

std::vector<twin::RiskEntry> risks_of(const StartOutcome& start,
                                      const std::vector<twin::Consequence>& consequences) {
  if (start.flights.empty()) return {};
  std::vector<twin::RiskCauses> flights;
  twin::RiskCauses only_unseen;
  only_unseen.add(twin::RiskCause::unseen);
  for (const twin::Flight& flight : start.flights) {
    twin::RiskCauses& befell = flights.emplace_back();
    for (const twin::VehicleAccount& vehicle : flight.vehicles) befell.add(vehicle.risks());
    // Each vehicle did its part, and still nobody was found or the noise was not made.
    if (!flight.is_done && (befell.none() || befell == only_unseen))
      befell.add(twin::RiskCause::work);
  }
  return twin::risk_register(flights, consequences);
}

}  // namespace slackwater::api
