#include "api/log/score.h"

#include <algorithm>
#include <cmath>

#include "api/log/account_log.h"
#include "fields/base/error.h"

namespace slackwater::api {

Scorecard scorecard_of(const ingest::TrajectoryFile& log) {
  if (log.find("x") == nullptr || log.find("y") == nullptr || log.find("z") == nullptr ||
      log.t_s.empty())
    throw Error(ErrorKind::invalid_input,
                "the log holds no x, y and z over time; give one that `slackwater simulate` or "
                "`rehearse --log` wrote");
  const std::optional<twin::Scenario> scenario = scenario_of(log);
  const twin::Scenario* const plan = scenario ? &*scenario : nullptr;
  Scorecard card;
  card.run = log.attribute("title");
  card.seed = log.attribute("seed");
  card.account = account_in(log, plan);
  card.detectors = detections_in(log);
  card.people = people_score_of(log, card.account, plan);
  return card;
}

double scored_time_s(const twin::VehicleAccount& vehicle) {
  const auto end = twin::mission_end_of(vehicle.mission, vehicle.at_work.until_s);
  return (end ? end->t_s : vehicle.at_work.until_s) - vehicle.at_work.from_s;
}

bool is_scored_done(const twin::VehicleAccount& vehicle, double ran_s) {
  const auto end = twin::mission_end_of(vehicle.mission, ran_s);
  return end && end->is_done;
}

std::optional<double> energy_per_metre_j(const twin::VehicleAccount& vehicle) {
  const twin::TrackAccount& at_work = vehicle.at_work;
  if (!(at_work.drawn_j > 0 && at_work.sailed_m > 1)) return std::nullopt;
  return at_work.drawn_j / at_work.sailed_m;
}

Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  spread.runs = values.size();
  for (const double value : values) spread.mean += value / static_cast<double>(values.size());
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  if (values.size() > 1)
    spread.deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return spread;
}

}  // namespace slackwater::api
