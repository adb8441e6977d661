#pragma once
#include <string>

#include "fields/base/text.h"
#include "tests/twin/mission/mission_for_tests.h"
#include "tests/twin/rehearse/eye_task.h"
#include "tests/twin/rehearse/water_of_members.h"
#include "twin/rehearse/adapt_intensity.h"

namespace slackwater::tests {

/// Twelve rings round a pile from 5 to 27 m of depth, by an ROV that films it: two metres of it at
/// a time, in clear water.
inline std::string pile_survey_task() {
  return eye_task("survey", 0.4, 1.2, R"(    inspection:
      surfaces: [{kind: monopile, from: {depth_m: 4}, to: {depth_m: 28}}]
      looks:
        - {instrument: rov_camera, kinds: [monopile], detail_mm: 50, incidence_deg: 60, done_at: 0}
      water: {visibility_m: 15}
    work:
      - {pattern: rings, stand_off_m: 3, from: {depth_m: 5}, to: {depth_m: 27}, spacing_m: 2}
)");
}

/// @param charge  with which it begins
inline twin::MissionThinned pile_survey(std::uint64_t seed, double charge) {
  return [seed, charge](const twin::Intensity& thinned_by) {
    twin::MissionParts parts = small_farm_parts();
    parts.thinned_by = thinned_by;
    parts.task = [](const std::string&) {
      return Config::parse(pile_survey_task(), "survey.yaml");
    };
    const std::string yaml = formatted(
        "name: survey\nseed: {}\nduration: 1h\nstep_s: 0.05\nlog_every_s: 10\nwater: {{made_up: "
        "{{depth_m: 35, current: [{{depth_m: 0, east_m_s: 0.4, north_m_s: 0}}], wind: {{speed_m_s: "
        "3, from_deg: 270}}}}}}\nwaves: {{from: calm}}\ntasks: [survey]\nturbines: [A01]\nagents: "
        "{{eye: {{state_of_charge: {:g}}}}}\n",
        seed, charge);
    twin::Scenario scenario =
        twin::expand_mission(Config::parse(yaml, "mission.yaml"), parts).scenario;
    return scenario;
  };
}

/// The charge that it takes from the start to home, at a density in a steady current.
inline double charge_taken(const twin::Intensity& thinned_by, double current_m_s) {
  constexpr double full = 0.95;
  const twin::Scenario mission = pile_survey(1, full)(thinned_by);
  const UtcTime start = parse_utc("2025-06-02T00:00:00Z");
  twin::Surround surround = surround_of(mission);
  surround.field = twin::made_up_field({start, start + std::chrono::hours(2)}, {0, 40},
                                       std::vector<Horizontal>(4, Horizontal(current_m_s, 0)),
                                       {0, 0}, surround.site, 40);
  const twin::FlightCase once{start, 0};
  return full - twin::fly(mission, surround, {&once, 1}, {}).front().vehicles[0].on_mission.charge;
}

/// The same in water of which there is a forecast with members.
inline twin::MissionThinned in_a_forecast(const twin::MissionThinned& mission) {
  return [mission](const twin::Intensity& thinned_by) {
    twin::Scenario scenario = mission(thinned_by);
    scenario.water = twin::ForecastWater{};
    return scenario;
  };
}

}  // namespace slackwater::tests
