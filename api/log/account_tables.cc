#include "api/log/account_tables.h"

#include <array>
#include <cmath>

#include "api/log/manoeuvre_tables.h"
#include "api/log/table_rows.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryTable;
using twin::CleaningOutcome;
using twin::InspectionOutcome;
using twin::RunAccount;
using twin::Spent;
using twin::VehicleAccount;

template <auto Member>
AccountColumn kept(const char* name, const char* units, const char* meaning) {
  return {name, units, meaning,
          [](const VehicleAccount& a) { return static_cast<double>(a.*Member); },
          [](VehicleAccount& a, double value) {
            a.*Member = static_cast<std::remove_reference_t<decltype(a.*Member)>>(value);
          }};
}

template <bool twin::Makeup::*Member>
AccountColumn yes_or_no(const char* name, const char* meaning) {
  return {name, "1", meaning, [](const VehicleAccount& a) { return a.makeup.*Member ? 1.0 : 0.0; },
          [](VehicleAccount& a, double value) { a.makeup.*Member = value > 0.5; }};
}

template <Spent VehicleAccount::*Of, double Spent::*Member>
AccountColumn spent(const char* name, const char* units, const char* meaning) {
  return {name, units, meaning, [](const VehicleAccount& a) { return a.*Of.*Member; },
          [](VehicleAccount& a, double value) { a.*Of.*Member = value; }};
}

/// What the rows of the log tell as well; for those who read the table alone.
template <typename Get>
AccountColumn told_by_rows(const char* name, const char* units, const char* meaning, Get get) {
  return {name, units, meaning, get, nullptr};
}

double or_none(bool is_there, double value) { return is_there ? value : constants::nan; }

TrajectoryTable fate_table(const RunAccount& account) {
  TableRows rows("fate", {},
                 {{"model", "of the catalogue", {}},
                  {"halt", "why it was stepped no further; none: it was not", {}},
                  {"stopped_by", "what its mission was not done for; - nothing", {}},
                  {"events", "what befell it, causes first; - for a normal run", {}}});
  TrajectoryTable table = rows.take();
  for (const AccountColumn& column : account_columns()) {
    std::vector<double> values;
    for (const VehicleAccount& vehicle : account.vehicles) values.push_back(column.get(vehicle));
    table.columns.push_back({column.name, column.units, column.meaning, std::move(values)});
  }
  const auto or_no_word = [](const std::string& text) { return text.empty() ? no_word : text; };
  for (const VehicleAccount& vehicle : account.vehicles) {
    table.texts[0].values.push_back(or_no_word(vehicle.model));
    table.texts[1].values.emplace_back(name_of(vehicle.halt));
    table.texts[2].values.push_back(or_no_word(vehicle.stopped_by));
    table.texts[3].values.push_back(or_no_word(vehicle.fate_text(account.start)));
  }
  return table;
}

TableRows befell_rows() {
  return {"befell",
          {{"vehicle", "1", "which of the trajectories, from 0", {}},
           {"time", "s", "since the start of the run; none: after the one before it", {}}},
          {{"what", "what befell it", {}}, {"text", "the same for people", {}}}};
}

TableRows mission_rows() {
  return {
      "mission",
      {{"vehicle", "1", "which of the trajectories, from 0", {}},
       {"time", "s", "since the start of the run", {}},
       {"value", "1", "of a limit: its variable's, SI; of one found: how far, m; else none", {}}},
      {{"kind", "what happened", {}},
       {"cause", "why it left its task", {}},
       {"text", "the same for people", {}}}};
}

TableRows approach_rows() {
  return {"approach",
          {{"vehicle", "1", "index of the trajectory whose approach it is", {}},
           {"distance", "m", "the least in the run", {}},
           {"time", "s", "when, since the start of the run", {}},
           {"mmsi", "1", "of a vessel, else 0", {}}},
          {{"kind", "what was approached: vehicle, structure, vessel or tether", {}},
           {"to", "its name; of a tether that of whom it holds", {}}}};
}

TableRows clearance_rows() {
  std::vector<TrajectoryTable::Column> columns{
      {"vehicle", "1", "index of the trajectory, of one that keeps clear", {}},
      {"changed", "s", "time for which it was made to do otherwise", {}}};
  for (std::size_t c = 0; c < twin::alarm_causes; ++c) {
    const auto cause = static_cast<twin::AlarmCause>(c);
    columns.push_back({column_of(cause), "1", std::string("alarms: ") + words_of(cause), {}});
  }
  return {"clearance", std::move(columns), {}};
}

TableRows cleaning_rows() {
  return {"cleaning",
          {{"vehicle", "1", "which of the trajectories, from 0", {}},
           {"upper_depth", "m", "of the band, below mean sea level", {}},
           {"lower_depth", "m", "of the band", {}},
           {"area", "m2", "with growth to take off", {}},
           {"cleaned_area", "m2", "of it that is clean", {}},
           {"growth_removed", "m3", "from the band", {}},
           {"growth_left", "m3", "on the band", {}}},
          {}};
}

TableRows cleaned_rows() {
  return {"cleaned",
          {{"vehicle", "1", "which of the trajectories, from 0", {}},
           {"area", "m2", "with growth to take off", {}},
           {"cleaned_area", "m2", "of it that is clean", {}},
           {"growth_removed", "m3", "in all", {}},
           {"growth_left", "m3", "in all", {}},
           {"growth_density", "kg m-3", "0: nobody says", {}},
           {"done_at", "1", "share of the area that makes it done", {}},
           {"tool_time", "s", "for which its tool worked", {}},
           {"passes_needed", "1", "over a place", {}}},
          {}};
}

TableRows inspected_rows() {
  return {"inspected",
          {{"vehicle", "1", "which of the trajectories, from 0", {}},
           {"looks", "1", "that its instruments took", {}},
           {"rays", "1", "that were cast for them", {}},
           {"worked", "s", "for which it inspected", {}},
           {"detection_rate", "1", "of the made-up defects, found; none: there were none", {}},
           {"false_alarms_per_100_m2", "1", "of the area that was read", {}},
           {"size_error_rms", "m", "of measured less true size", {}},
           {"size_error_relative_rms", "1", "each by the true size", {}}},
          {{"left", "what it lacks of its plan; - nothing", {}}}};
}

TableRows surface_rows() {
  return {"inspected_surface",
          {{"vehicle", "1", "which of the trajectories, from 0", {}},
           {"area", "m2", "of the surface", {}},
           {"seen_area", "m2", "however well", {}},
           {"covered_area", "m2", "as well as asked", {}},
           {"least_detail", "m", "of what was seen: the best; none: nothing was", {}},
           {"median_detail", "m", "by area; none: less than half was seen", {}}},
          {{"surface", "its name", {}}, {"instrument", "that looked at it", {}}}};
}

TableRows defect_rows() {
  return {"defect_kind",
          {{"vehicle", "1", "which of the trajectories, from 0", {}},
           {"kind", "1", "as in the table of findings", {}},
           {"planted", "1", "made-up defects", {}},
           {"found", "1", "of them, by at least one instrument", {}},
           {"false_alarms", "1", "that were reported", {}}},
          {}};
}

void add_cleaning(double i, const CleaningOutcome& c, TableRows& cleaned, TableRows& bands) {
  cleaned.add({i, c.area_m2, c.cleaned_m2, c.removed_m3, c.left_m3, c.density_kg_m3, c.done_at,
               c.worked_s, static_cast<double>(c.passes_needed)});
  for (const CleaningOutcome::Band& band : c.bands)
    bands.add({i, band.top_m, band.bottom_m, band.area_m2, band.cleaned_m2, band.removed_m3,
               band.left_m3});
}

void add_inspection(double i, const InspectionOutcome& out, TableRows& inspected,
                    TableRows& surfaces, TableRows& kinds) {
  const auto finite = [](double value) { return or_none(std::isfinite(value), value); };
  for (const InspectionOutcome::Part& part : out.parts)
    surfaces.add({i, part.area_m2, part.seen_m2, part.covered_m2, finite(part.least_detail_m),
                  finite(part.median_detail_m)},
                 {part.surface, part.instrument});
  const auto or_nan = [](const std::optional<double>& v) { return v.value_or(constants::nan); };
  inspected.add({i, static_cast<double>(out.looks), static_cast<double>(out.rays), out.worked_s,
                 or_nan(out.score.detection_rate), or_nan(out.score.false_alarms_per_100_m2),
                 or_nan(out.score.size_error_rms_m), or_nan(out.score.size_error_relative_rms)},
                {out.left.empty() ? no_word : out.left});
  for (std::size_t k = 0; k < out.score.kinds.size(); ++k) {
    const twin::DetectionScore::OfKind& of = out.score.kinds[k];
    if (of.planted + of.false_alarms > 0)
      kinds.add({i, static_cast<double>(k), static_cast<double>(of.planted),
                 static_cast<double>(of.found), static_cast<double>(of.false_alarms)});
  }
}

}  // namespace

std::span<const AccountColumn> account_columns() {
  using A = VehicleAccount;
  using M = twin::Makeup;
  static const std::vector<AccountColumn> columns{
      told_by_rows("sailed", "m", "over ground, until it halted",
                   [](const A& a) { return a.track.sailed_m; }),
      {"electrical_energy", "J", "drawn in all",
       [](const A& a) { return or_none(a.makeup.is_electric, a.in_all.drawn_j); },
       [](A& a, double value) { a.in_all.drawn_j = value; }},
      {"fuel_burnt", "kg", "in all",
       [](const A& a) { return or_none(a.makeup.burns_fuel, a.in_all.fuel_kg); },
       [](A& a, double value) { a.in_all.fuel_kg = value; }},
      told_by_rows("rms_across_track", "m", "root mean square over the times of the log",
                   [](const A& a) { return a.track.rms_across_m; }),
      told_by_rows("rms_depth_error", "m", "off the depth or height of its way, likewise",
                   [](const A& a) { return or_none(!a.makeup.floats, a.track.rms_depth_error_m); }),
      told_by_rows("largest_depth_error", "m", "the largest of them",
                   [](const A& a) {
                     return or_none(!a.makeup.floats, twin::magnitude_of(a.track.depth_error_m));
                   }),
      kept<&A::largest_roll_rad>("largest_roll", "rad", "of its size, over all steps"),
      kept<&A::largest_pitch_rad>("largest_pitch", "rad", "of its size, over all steps"),
      {"halted", "s", "when it was stepped no further, since the start; none: it was not",
       [](const A& a) { return or_none(a.halt != twin::Halt::none, a.halted_at_s); },
       [](A& a, double value) { a.halted_at_s = value; }},
      kept<&A::is_done>("done", "1", "1: its mission, or without one that it did not halt"),
      kept<&A::broke_reserve>("reserve_broken", "1", "1: home with less than its reserve"),
      kept<&A::ended_s>("ended", "s", "its mission, since the start; else the end of the run"),
      kept<&A::held_s>("held", "s", "waiting in all"),
      kept<&A::tasks>("tasks", "1", "that it has"),
      kept<&A::tasks_done>("tasks_done", "1", "of them"),
      kept<&A::waypoints>("waypoints", "1", "that it took"),
      {"found", "s", "when it found whom it searches for; none: it did not",
       [](const A& a) { return a.found_s.value_or(constants::nan); },
       [](A& a, double value) { a.found_s = value; }},
      spent<&A::in_all, &Spent::charge>("charge", "1", "of its battery, at the end of the run"),
      spent<&A::on_mission, &Spent::drawn_j>("mission_energy", "J",
                                             "electrical, until its mission ended"),
      spent<&A::on_mission, &Spent::fuel_kg>("mission_fuel", "kg", "likewise"),
      spent<&A::on_mission, &Spent::charge>("mission_charge", "1",
                                            "of its battery, when its mission ended"),
      kept<&A::least_charge>("least_charge", "1", "of its battery, on its mission"),
      kept<&A::worst_share>("worst_share", "1", "of any limit at its task; above 1: exceeded"),
      kept<&A::thrust_used>("thrust_used", "1", "at most, of what its thrusters can"),
      kept<&A::line_used>("tether_used", "1", "at most, of what its tether bears"),
      yes_or_no<&M::has_battery>("has_battery", "1: yes"),
      yes_or_no<&M::is_electric>("is_electric", "1: something on board draws from a bus"),
      yes_or_no<&M::burns_fuel>("burns_fuel", "1: yes"),
      yes_or_no<&M::floats>("floats", "1: it has no depth to keep"),
      yes_or_no<&M::flies>("flies", "1: yes"),
      yes_or_no<&M::by_sensors>("by_sensors", "0: its autopilot is told the truth"),
      yes_or_no<&M::has_conduct>("conducts_itself", "1: it has a mission"),
      yes_or_no<&M::searches>("searches", "1: for somebody")};
  return columns;
}

std::vector<TrajectoryTable> account_tables(const RunAccount& account) {
  TableRows befell = befell_rows(), mission = mission_rows(), approach = approach_rows(),
            clearance = clearance_rows(), cleaned = cleaned_rows(), bands = cleaning_rows(),
            inspected = inspected_rows(), surfaces = surface_rows(), kinds = defect_rows();
  for (std::size_t v = 0; v < account.vehicles.size(); ++v) {
    const VehicleAccount& vehicle = account.vehicles[v];
    const auto i = static_cast<double>(v);
    for (const twin::FateEvent& event : vehicle.fate)
      befell.add({i, event.at_s.value_or(constants::nan)},
                 {name_of(event.what), words_of(event.what)});
    for (const twin::MissionEvent& event : vehicle.mission)
      mission.add({i, event.t_s, event.value.value_or(constants::nan)},
                  {name_of(event.kind), name_of(event.cause), event.text});
    for (const ApproachKind& kind : approach_kinds())
      if (const std::optional<twin::Approach>& near = vehicle.closest.*kind.of)
        approach.add({i, near->distance_m, near->t_s, static_cast<double>(near->mmsi)},
                     {kind.name, near->to});
    if (vehicle.clearance) {
      std::vector<double> row{i, vehicle.clearance->changed_s};
      row.insert(row.end(), vehicle.clearance->alarms_from.begin(),
                 vehicle.clearance->alarms_from.end());
      clearance.add(row);
    }
    if (vehicle.cleaning) add_cleaning(i, *vehicle.cleaning, cleaned, bands);
    if (vehicle.inspection) add_inspection(i, *vehicle.inspection, inspected, surfaces, kinds);
  }
  std::vector<TrajectoryTable> tables{fate_table(account)};
  for (TableRows* rows :
       {&befell, &mission, &approach, &clearance, &cleaned, &bands, &inspected, &surfaces, &kinds})
    tables.push_back(rows->take());
  for (TrajectoryTable& table : manoeuvre_tables(account)) tables.push_back(std::move(table));
  return tables;
}

const char* words_of(twin::AlarmCause cause) noexcept {
  switch (cause) {
    case twin::AlarmCause::no_warning:
      return "vessel without warning";
    case twin::AlarmCause::crowded:
      return "too much around";
    default:
      return twin::name_of(cause);
  }
}

std::string column_of(twin::AlarmCause cause) {
  return std::string("from_") + twin::name_of(cause);
}

std::span<const ApproachKind> approach_kinds() noexcept {
  using twin::Closest;
  static constexpr std::array kinds{
      ApproachKind{"vehicle", &Closest::vehicle}, ApproachKind{"structure", &Closest::structure},
      ApproachKind{"vessel", &Closest::vessel}, ApproachKind{"tether", &Closest::tether}};
  return kinds;
}

}  // namespace slackwater::api
