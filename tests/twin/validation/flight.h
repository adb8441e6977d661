#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "tests/support/shared_data.h"
#include "twin/environment/made_up_field.h"
#include "twin/run/set_up.h"

namespace slackwater::tests {

/// The bundled vehicles in made-up water, from the text of a scenario: a run as users make it,
/// taken step by step.
class Flight {
 public:
  explicit Flight(const std::string& yaml) : Flight(twin::parse_scenario(yaml, "flight")) {}
  explicit Flight(const twin::Scenario& scenario) : Flight(scenario, field_of(scenario)) {}
  /// In other water, or among turbines: `change` may alter what was made ready before anything
  /// moves. In other water; `change` may alter what was made ready before anything moves.
  Flight(const twin::Scenario& scenario, std::shared_ptr<const Field> field,
         const std::function<void(twin::ReadyRun&)>& change = {})
      : Flight(scenario, around(scenario, std::move(field)), change) {}
  Flight(const twin::Scenario& scenario, const twin::Surround& surround,
         const std::function<void(twin::ReadyRun&)>& change = {})
      : ready_(made_ready(scenario, surround, change)),
        run_(ready_.agents, ready_.states, settings_of(scenario)) {}

  void step() { run_.step(); }
  void run(double seconds) {
    for (const double end_s = run_.time_s() + seconds - 1e-9; run_.time_s() < end_s;) run_.step();
  }
  [[nodiscard]] double time_s() const { return run_.time_s(); }
  [[nodiscard]] const twin::Agent& agent(std::size_t i = 0) const { return run_.agents()[i]; }
  [[nodiscard]] const twin::Vehicle& craft(std::size_t i = 0) const { return *agent(i).vehicle; }
  [[nodiscard]] const twin::AgentState& state(std::size_t i = 0) const { return run_.states()[i]; }
  [[nodiscard]] const twin::VehicleState<double>& vehicle(std::size_t i = 0) const {
    return state(i).vehicle;
  }
  [[nodiscard]] const twin::BodyState<double>& body(std::size_t i = 0) const {
    return vehicle(i).body;
  }
  /// Over ground, NED.
  [[nodiscard]] twin::Triple<double> velocity_m_s(std::size_t i = 0) const {
    return twin::rotation_of(body(i).attitude).to_ned(body(i).nu.linear);
  }
  /// What all thrusters push with, in body axes.
  [[nodiscard]] twin::Triple<double> thrust_n(std::size_t i = 0) const {
    twin::Triple<double> sum;
    for (std::size_t k = 0; k < craft(i).mounts; ++k)
      sum = sum + vehicle(i).thrust_n[k] * craft(i).mount[k].direction;
    return sum;
  }

  [[nodiscard]] static std::shared_ptr<const Field> field_of(const twin::Scenario& scenario) {
    const UtcTime from = epoch();
    const auto lasts =
        Duration(static_cast<Duration::rep>(std::ceil(scenario.duration_s * 1000)) + 1000);
    return twin::made_up_field(std::get<twin::MadeUpWater>(scenario.water), scenario.origin, from,
                               from + lasts);
  }
  /// What a scenario needs: this water and the bundled data.
  [[nodiscard]] static twin::Surround around(const twin::Scenario& scenario,
                                             std::shared_ptr<const Field> field) {
    twin::Surround surround;
    surround.field = std::move(field);
    surround.site = scenario.origin;
    surround.data_folder = source_folder() / "data";
    return surround;
  }
  [[nodiscard]] static UtcTime epoch() { return parse_utc("2025-06-02T06:00:00Z"); }

 private:
  static twin::RunSettings settings_of(const twin::Scenario& scenario) {
    twin::RunSettings settings;
    settings.seed = scenario.seed;
    settings.step_s = scenario.step_s;
    return settings;
  }
  static twin::ReadyRun made_ready(const twin::Scenario& scenario, const twin::Surround& surround,
                                   const std::function<void(twin::ReadyRun&)>& change) {
    twin::ReadyRun ready = twin::set_up(scenario, surround);
    if (change) change(ready);
    return ready;
  }
  twin::ReadyRun ready_;   ///< keeps the environment
  mutable twin::Run run_;  ///< looking at its states brings them up to date
};

}  // namespace slackwater::tests
