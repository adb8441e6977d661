#include "api/rehearse/mission_events.h"

#include "twin/rehearse/outcome.h"

namespace slackwater::api {

using ingest::TrajectoryTable;

TrajectoryTable mission_table(std::span<const twin::Agent> agents,
                              std::span<const VehicleSummary> vehicles) {
  TrajectoryTable table;
  table.name = "mission";
  TrajectoryTable::Column vehicle{"vehicle", "1", "which of the trajectories, from 0", {}};
  TrajectoryTable::Column time{"time", "s", "since the start of the run", {}};
  TrajectoryTable::TextColumn kind{"kind", "what happened", {}};
  TrajectoryTable::TextColumn cause{"cause", "why it left its task", {}};
  TrajectoryTable::TextColumn text{"text", "the same for people", {}};
  for (std::size_t i = 0; i < vehicles.size(); ++i)
    for (const twin::ConductEvent& event : vehicles[i].mission_events) {
      vehicle.values.push_back(static_cast<double>(i));
      time.values.push_back(event.t_s);
      kind.values.emplace_back(twin::name_of(event.kind));
      cause.values.emplace_back(twin::name_of(event.cause));
      text.values.push_back(twin::text_of(event, agents[i]));
    }
  table.columns = {std::move(vehicle), std::move(time)};
  table.texts = {std::move(kind), std::move(cause), std::move(text)};
  return table;
}

std::vector<MissionEvent> mission_events_in(const ingest::TrajectoryFile& log) {
  std::vector<MissionEvent> events;
  const TrajectoryTable* table = log.find_table("mission");
  if (table == nullptr) return events;
  const auto *vehicle = table->column("vehicle"), *time = table->column("time");
  const auto *kind = table->text("kind"), *cause = table->text("cause"),
             *text = table->text("text");
  if (vehicle == nullptr || time == nullptr || kind == nullptr || cause == nullptr ||
      text == nullptr)
    return events;
  for (std::size_t i = 0; i < table->rows(); ++i)
    events.push_back(
        {static_cast<std::size_t>((*vehicle)[i]), (*time)[i], (*kind)[i], (*cause)[i], (*text)[i]});
  return events;
}

}  // namespace slackwater::api
