#pragma once
#include <limits>
#include <string>
#include <vector>

#include "tests/twin/scenario/random_surface.h"
#include "twin/scenario/scenario.h"

namespace slackwater::tests {

/// Scenarios of a seed, with all that a reader takes, in numbers as a reader makes them: angles are
/// degrees times pi/180, and so on.
class RandomScenario : private RandomSurface {
 public:
  explicit RandomScenario(std::uint64_t seed) : RandomSurface(seed) {}

  twin::Scenario make() {
    twin::Scenario s;
    s.name = name();
    s.seed = count(0, 2147483647);
    if (chance(0.5)) s.start = parse_utc("2025-03-10T06:00:00Z") + Duration(count(0, 1000000000));
    s.step_s = pick<double>({0.05, 0.1, 0.25});
    s.duration_s = number(1, 30 * 86400.0);
    s.log_every_s = s.step_s * static_cast<double>(count(1, 50));
    s.logs_sensors = chance(0.5);
    s.home_after_s = number(0, 86400);
    const bool is_made_up = chance(0.5);
    if (is_made_up)
      s.water = made_up_water();
    else
      s.water = forecast_water();
    s.has_origin = is_made_up || chance(0.5);
    if (s.has_origin) s.origin = GeoPoint::from_degrees(number(-90, 90), number(-180, 180));
    if (!is_made_up) s.member = count(0, 100000);
    s.waves = waves(is_made_up);
    s.gusts = pick<twin::GustModel>({twin::GustModel::none, twin::GustModel::dryden});
    s.has_wakes = chance(0.5);
    for (std::size_t i = count(0, 3); i > 0; --i) s.structures.push_back(structure());
    for (std::size_t i = count(1, 3); i > 0; --i) {
      s.vehicles.push_back(vehicle(std::to_string(i)));
      s.vehicles.back().logs_sensors = s.logs_sensors;
    }
    if (chance(0.4)) s.traffic = traffic();
    if (chance(0.5))
      s.clearance = {number(0, 1000), number(0, 1000), number(0, 100), number(0, 5000),
                     number(0, 500)};
    return s;
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  double down() { return chance(0.3) ? -number(0, 500) : number(0, 12000); }
  twin::Triple<double> place() { return {number(-50e3, 50e3), number(-50e3, 50e3), down()}; }
  twin::Triple<double> on_plan() { return {number(-50e3, 50e3), number(-50e3, 50e3), 0}; }
  twin::Triple<double> on_board() {
    return {number(-200, 200), number(-200, 200), number(-200, 200)};
  }

  twin::MadeUpWater made_up_water() {
    twin::MadeUpWater water;
    water.depth_m = number(10, 12000);
    for (std::size_t i = 0, levels = count(0, 3); i < levels; ++i)
      water.current.push_back(
          {3.0 * static_cast<double>(i) + number(0, 2), number(-10, 10), number(-10, 10)});
    water.wind_speed_m_s = number(0, 75);
    water.wind_from_deg = number(-360, 360);
    return water;
  }
  twin::ForecastWater forecast_water() {
    twin::ForecastWater water;
    (chance(0.5) ? water.site : water.file) = name();
    if (chance(0.5)) water.day = parse_day("2025-03-10") + std::chrono::days(count(0, 1000));
    water.accept_means = chance(0.5);
    return water;
  }
  twin::ScenarioWaves waves(bool is_made_up) {
    twin::ScenarioWaves waves;
    waves.components = count(8, 1024);
    waves.from_forecast = !is_made_up && chance(0.5);
    if (waves.from_forecast) {
      waves.have_height_errors = chance(0.5);
      return waves;
    }
    if (chance(0.3)) {
      waves.components = 200;
      waves.regular = RegularWave{number(0.001, 0.5), number(5, 20), number(-360, 360)};
      return waves;
    }
    for (std::size_t i = count(0, 3); i > 0; --i) {
      WavePartition& p = waves.made_up.partitions.emplace_back();
      p.significant_height_m = number(0.1, 0.5);
      p.peak_period_s = number(5, 20);
      p.from_direction_deg = number(-360, 360);
      if (chance(0.5)) p.gamma = number(1, 10);
      p.spreading_s = number(0, 1000);
    }
    return waves;
  }
  twin::ScenarioStructure structure() {
    twin::ScenarioStructure s;
    s.name = name();
    s.centre_m = on_plan();
    if (chance(0.5)) {
      s.diameter_m = number(0.1, 100);
      s.turns_current = chance(0.5);
    } else {
      s.kind = twin::ScenarioStructure::Kind::box;
      s.size_m = {number(0.1, 500), number(0.1, 500), 0};
    }
    s.top_m = -number(-100, 500);
    s.bottom_m = number(101, 12000);
    s.size_m.z = s.bottom_m - s.top_m;
    return s;
  }

  void put_speed(double& speed_m_s, double& over_ground) {
    if (!chance(0.5)) return;
    speed_m_s = number(0.01, 60);
    over_ground = chance(0.5) ? 1 : 0;
  }
  twin::ScenarioTask task(const twin::ScenarioVehicle& vehicle, bool follows) {
    using Kind = twin::ScenarioTask::Kind;
    twin::ScenarioTask task;
    task.phase = static_cast<twin::Phase>(count(0, twin::phase_count - 1));
    task.kind =
        follows ? Kind::follow_track
                : static_cast<Kind>(pick<std::size_t>({count(0, vehicle.conduct ? 4 : 2),
                                                       static_cast<std::size_t>(Kind::actuators),
                                                       static_cast<std::size_t>(Kind::manoeuvre)}));
    switch (task.kind) {
      case Kind::route:
        for (std::size_t i = count(1, 4); i > 0; --i) {
          twin::Waypoint& at = task.waypoints.emplace_back();
          at.position_m = place();
          put_speed(at.speed_m_s, at.over_ground);
        }
        task.drifts = vehicle.conduct && vehicle.conduct->search && chance(0.5);
        break;
      case Kind::hold:
        task.hold_s = chance(0.5) ? number(0, 86400) : infinite;
        break;
      case Kind::follow_track:
        task.follow.emplace();
        task.follow->mmsi = static_cast<std::uint32_t>(count(1, 999999999));
        task.follow->within_m = number(0.1, 10e3);
        if (chance(0.5)) task.follow->log = {name(), start(), {task.follow->mmsi}, 50e3, false};
        break;
      case Kind::aboard:
        task.until_stand_by = vehicle.carrier && chance(0.5);
        task.hold_s = number(0, 86400);
        task.charger_w = pick<double>({0, infinite, number(0.1, 1e6)});
        break;
      case Kind::stand_by:
        task.hold_s = infinite;
        break;
      case Kind::actuators:
        task.hold_s = number(100, 86400);
        task.table = table();
        break;
      case Kind::manoeuvre:
        task.manoeuvre = manoeuvre();
        task.hold_s = twin::longest_s(*task.manoeuvre);
        break;
    }
    return task;
  }
  twin::ActuatorTable table() {
    twin::ActuatorTable table;
    table.keeps_depth = chance(0.5);
    table.keeps_heading = chance(0.5);
    table.keeps_speed = chance(0.5);
    if (table.keeps_speed && chance(0.5)) table.speed_m_s = number(0.01, 60);
    for (std::size_t i = 0, rows = count(1, 4); i < rows; ++i) {
      twin::ActuatorRow& row = table.rows.emplace_back();
      row.at_s = static_cast<double>(i) + number(0, 0.9);
      row.setting.emplace_back("left_share", number(-1, 1));
      for (const char* const key :
           {"left_1_rad_s", "rpm_rpm", "bow_n", "rudder_deg", "moving_mass_m", "volume_m3"})
        if (chance(0.3)) row.setting.emplace_back(key, number(-1e3, 1e3));
    }
    return table;
  }
  twin::ManoeuvreTask manoeuvre() {
    using Kind = twin::ManoeuvreKind;
    twin::ManoeuvreTask m;
    m.kind = static_cast<Kind>(count(0, 4));
    if (chance(0.5)) m.speed_m_s = number(0.01, 60);
    if (m.kind == Kind::steps) {
      m.lasts_s = number(100, 86400);
      for (std::size_t i = 0, steps = count(1, 4); i < steps; ++i) {
        twin::KeptStep& step = m.steps.emplace_back();
        step.at_s = static_cast<double>(i) + number(0, 0.9);
        step.heading_rad = angle();
        if (chance(0.5)) step.speed_m_s = number(0, 60);
        if (chance(0.5)) step.depth_m = number(0, 12000);
      }
      return m;
    }
    m.approach_s = number(5, 600);
    m.helms_are_shares = chance(0.5);
    const auto helm = [&](double least) {
      return m.helms_are_shares ? number(least, 1) : angle(90 * least, 90);
    };
    if (m.kind == Kind::spiral) {
      for (std::size_t i = count(2, 9); i > 0; --i) m.helms.push_back(helm(-1));
      m.each_s = number(1, 600);
      return m;
    }
    m.to_port = chance(0.5);
    if (m.helms_are_shares || chance(0.5)) m.helms = {helm(0.01)};
    m.lasts_s = number(1, 600);
    if (m.kind == Kind::pull_out) m.turn_s = number(1, 600);
    if (m.kind == Kind::turning_circle) m.heading_change_rad = angle(90, 7200);
    if (m.kind == Kind::zig_zag) {
      m.heading_change_rad = angle(1, 90);
      m.executes = count(2, 100);
    }
    return m;
  }
  std::optional<UtcTime> start() {
    if (chance(0.5)) return std::nullopt;
    return parse_utc("2025-03-10T06:00:00Z") + Duration(count(0, 1000000000));
  }
  twin::ScenarioVehicle vehicle(const std::string& number_text) {
    twin::ScenarioVehicle v;
    v.name = name() + number_text;
    v.model = name();
    v.starts_on_track = chance(0.2);
    if (!v.starts_on_track) {
      v.start_m = place();
      v.heading_rad = angle();
    }
    v.state_of_charge = number(0, 1);
    if (chance(0.5)) v.held_voltage_v = number(1, 1000);
    if (chance(0.5)) v.depth_bound_m = number(0.01, 1000);
    if (chance(0.5)) v.step_s = number(1e-4, 1);
    v.detail = pick<twin::StepDetail>({twin::StepDetail::full, twin::StepDetail::coarse});
    v.follower = static_cast<twin::FollowerChoice>(count(0, 3));
    if (chance(0.5)) {
      v.speed_m_s = number(0.01, 60);
      v.is_speed_over_ground = chance(0.5);
    }
    if (chance(0.6)) v.conduct = conduct();
    if (v.conduct && chance(0.5)) v.carrier = {name(), on_board()};
    if (chance(0.5)) {
      v.tether = twin::ScenarioVehicle::TetherStart{};
      if (!v.carrier) v.tether->top_m = place();
      v.tether->length_m = number(0.1, 10000);
    }
    v.keeps_clear = chance(0.5);
    v.navigates_by_sensors = chance(0.5);
    for (std::size_t i = 0, tasks = count(1, 4); i < tasks; ++i)
      v.tasks.push_back(task(v, i == 0 && v.starts_on_track));
    return v;
  }

  twin::HeightTable height_table(Range range) {
    twin::HeightTable table;
    const bool has_periods = chance(0.7);
    if (has_periods) table.peak_period_s = {number(1, 10), number(11, 20), number(21, 30)};
    if (!has_periods || chance(0.5)) {
      table.off_bow_rad = {angle(0, 60), angle(61, 120), angle(121, 180)};
      if (chance(0.5)) table.heading_rad = angle();
    }
    for (std::size_t i = std::max<std::size_t>(1, table.peak_period_s.size()) *
                         std::max<std::size_t>(1, table.off_bow_rad.size());
         i > 0; --i)
      table.at_most_m.push_back(number(range.low, range.high));
    return table;
  }
  twin::Limit limit(twin::LimitVariable variable) {
    const twin::LimitWord& word = twin::word_of(variable);
    twin::Limit limit;
    limit.variable = variable;
    limit.is_least = chance(0.3);
    limit.bound = number(word.range.low, word.range.high);
    if (chance(0.3)) limit.down_m = chance(0.5) ? -number(0, 500) : number(0, 12000);
    if (variable == twin::LimitVariable::significant_wave_height && !limit.is_least &&
        chance(0.7)) {
      limit.waves.emplace();
      if (chance(0.7)) {
        limit.waves->off_bow_rad = Range{angle(0, 90), angle(91, 180)};
        if (chance(0.5)) limit.waves->heading_rad = angle();
      }
      if (!limit.waves->off_bow_rad || chance(0.5))
        limit.waves->peak_period_s = Range{number(1, 10), number(11, 30)};
    }
    if (variable == twin::LimitVariable::significant_wave_height && !limit.is_least &&
        !limit.waves) {
      limit.table = height_table(word.range);
      limit.bound = limit.table->least_m();
    }
    if (chance(0.5)) limit.phases.bits = static_cast<std::uint8_t>(count(1, 31));
    limit.may_be_missing = chance(0.5);
    if (chance(0.5)) limit.source = name();
    if (chance(0.5)) limit.status = name();
    return limit;
  }
  twin::BehaviourTree behaviour(int levels) {
    using Tree = twin::BehaviourTree;
    const auto& leaves = twin::conduct_leaves();
    const auto condition = [&] { return count(0, leaves.conditions.size() - 1); };
    const std::size_t kind = levels > 0 ? count(0, 9) : count(0, 1);
    std::vector<Tree> children;
    if (kind > 1)
      for (std::size_t i = count(1, 3); i > 0; --i) children.push_back(behaviour(levels - 1));
    const auto made = [&]() -> Tree {
      switch (kind) {
        case 0: {
          const std::size_t action = count(0, leaves.actions.size() - 1);
          return Tree::action(action, leaves.actions[action]);
        }
        case 1: {
          const std::size_t which = condition();
          return Tree::condition(which, leaves.conditions[which]);
        }
        case 2:
          return Tree::sequence(children);
        case 3:
          return Tree::fallback(children);
        case 4:
          return Tree::reactive_sequence(children);
        case 5:
          return Tree::reactive_fallback(children);
        case 6:
          return Tree::parallel(chance(0.5) ? twin::SuccessOn::all : twin::SuccessOn::one,
                                children);
        case 7:
          return Tree::guard(condition(), children.front());
        case 8:
          return Tree::retry(count(1, 1000), children.front());
        default:
          return Tree::timeout(number(0.001, 86400), children.front());
      }
    };
    const Tree tree = made();
    return chance(0.3) ? tree.named(name()) : tree;
  }
  twin::Conduct conduct() {
    twin::Conduct c;
    c.autonomy = static_cast<twin::Autonomy>(count(0, 2));
    c.tick_s = number(0.01, 60);
    if (chance(0.5)) c.home_m = place();
    c.clear_m = number(0, 500);
    c.reserve = {number(0, 0.95), number(1, 10)};
    c.holding = {number(0, 86400), number(0, 1000)};
    if (c.autonomy != twin::Autonomy::automatic && chance(0.7))
      c.pilot = {number(0, 50), number(0.1, 600), number(0.1, 10)};
    if (c.autonomy == twin::Autonomy::shared && chance(0.7)) {
      c.envelope.most_speed_m_s = chance(0.5) ? number(0.01, 60) : 0;
      c.envelope.stand_off_m = number(0, 1000);
      if (chance(0.5)) c.envelope.fence_m = number(1, 50e3);
    }
    if (chance(0.5)) c.deck_point_m = on_board();
    for (const twin::LimitWord& word : twin::limit_words()) {
      if (chance(0.3)) c.limits.push_back(limit(word.variable));
      if (word.may_be_assumed && chance(0.5))
        c.assumed.push_back({word.variable, number(word.range.low, word.range.high)});
    }
    for (std::size_t i = count(0, 2); i > 0; --i) {
      twin::Fault& fault = c.faults.emplace_back();
      fault.kind = static_cast<twin::FaultKind>(count(0, 3));
      fault.from_s = number(0, 86400);
      fault.to_s = chance(0.5) ? infinite : fault.from_s + number(0.001, 86400);
      if (fault.kind == twin::FaultKind::lost_thruster) fault.thruster = count(0, 15);
    }
    if (chance(0.4)) c.search = search();
    if (chance(0.4)) c.mammals = mammals();
    if (chance(0.4)) c.cleaning = cleaning();
    if (chance(0.3)) c.inspection = inspection();
    if (chance(0.5)) c.behaviour = behaviour(4);
    return c;
  }
  twin::PersonSearch search() {
    twin::PersonSearch search;
    search.person = name();
    search.object = name();
    search.lookout = name();
    if (chance(0.5)) search.last_known_m = on_plan();
    search.radius_m = number(0, 20e3);
    search.elapsed_s = number(0, 7200);
    search.diffusivity_m2_s = number(0, 100);
    search.visibility_m = number(1, 100e3);
    return search;
  }
  twin::MammalDuty mammals() {
    twin::MammalDuty duty;
    duty.animals = name();
    duty.animal = name();
    duty.watch = name();
    duty.count = count(0, 1000);
    duty.half_side_m = number(20e3, 50e3);
    if (chance(0.5)) duty.noise_m = on_plan();
    duty.noise = {number(1, 20e3), number(0, 86400), number(0, 86400)};
    if (chance(0.5)) duty.noise_by = name();
    if (chance(0.5)) duty.again_after_s = number(0, 86400);
    return duty;
  }
  twin::CleaningPlan cleaning() {
    twin::CleaningPlan plan;
    const double from_deg = number(-360, 360), to_deg = from_deg + number(1, 359);
    plan.from_rad = from_deg * degree;
    plan.arc_rad = (to_deg - from_deg) * degree;
    plan.top_m = -number(0, 20);
    plan.bottom_m = number(1, 12000);
    plan.cell_m = number(0.001, 0.05);
    plan.band_m = number(0.1, 1000);
    plan.clean_below_mm = number(0, 500);
    plan.done_at = number(0, 1);
    plan.growth.source = name();
    plan.growth.status = name();
    plan.growth.top_m = -number(0, 20);
    if (chance(0.5)) plan.growth.density_kg_m3 = number(900, 3000);
    double above_m = 0;
    for (std::size_t i = count(0, 2); i > 0; --i)
      plan.growth.layers.push_back({above_m += number(1, 50), number(0, 1000)});
    plan.growth.layers.push_back({chance(0.5) ? infinite : above_m + 1, number(0, 1000)});
    plan.tool.swath_m = number(0.05, 5);
    plan.tool.reach_m = number(0.1, 10);
    (chance(0.5) ? plan.tool.removal_mm_m2_s : plan.tool.rate_m2_s) = number(1, 1000) / 3600;
    plan.tool.source = name();
    plan.tool.status = name();
    return plan;
  }
  twin::Clarity clarity() { return {number(0.01, 50), number(0, 1), number(0, 50)}; }
  twin::InspectionPlan inspection() {
    twin::InspectionPlan plan;
    for (std::size_t i = count(1, 3); i > 0; --i) plan.surfaces.push_back(surface());
    for (std::size_t i = count(1, 3); i > 0; --i) {
      twin::InspectionLine& line = plan.lines.emplace_back();
      line.instrument = name() + std::to_string(i);
      line.kinds = {plan.surfaces.front().kind()};
      if (const auto other = plan.surfaces.back().kind(); other != line.kinds.front())
        line.kinds.push_back(other);
      line.detail_m = 1e-3 * number(0.001, 1e6);
      line.most_incidence_rad = degree * number(1, 90);
      line.looks = static_cast<std::uint32_t>(count(1, 1000));
      line.seen_at = number(0, 1);
    }
    if (chance(0.5)) plan.water = clarity();
    if (chance(0.5)) plan.air = clarity();
    for (std::size_t i = count(0, 3); i > 0; --i) plan.defects.entries.push_back(defects());
    plan.defect_facts = name();
    for (std::size_t i = count(1, 3); i > 0; --i) plan.detection.push_back(name());
    if (chance(0.5)) plan.patch_m = number(0.005, 100);
    if (chance(0.5)) plan.rays_per_look = count(1, 2000);
    return plan;
  }
  twin::PlannedDefects defects() {
    twin::PlannedDefects entry;
    entry.kind =
        pick<twin::DefectKind>({twin::all_defect_kinds().begin(), twin::all_defect_kinds().end()});
    if (chance(0.5)) entry.surface = name();
    if (!entry.surface.empty() && chance(0.5)) {
      entry.place.emplace();
      entry.place->is_by_bearing = chance(0.5);
      if (entry.place->is_by_bearing) {
        entry.place->bearing_rad = angle();
        entry.place->z_m = down();
      } else {
        entry.place->along_m = number(-1e5, 1e5);
        entry.place->down_m = number(-1e5, 1e5);
      }
    } else {
      entry.count = count(0, 100000);
    }
    if (chance(0.5)) entry.size_m = Range{number(0.001, 0.01), number(0.02, 0.1)};
    if (chance(0.5)) entry.severity = Range{number(0.0001, 0.0002), number(0.0003, 0.0005)};
    return entry;
  }
  twin::ScenarioTraffic traffic() {
    twin::ScenarioTraffic traffic;
    for (std::size_t i = count(0, 2); i > 0; --i) {
      twin::AisLog& log = traffic.logs.emplace_back();
      log.file = name();
      log.starts = start();
      for (std::size_t m = count(0, 3); m > 0; --m)
        log.mmsi.push_back(static_cast<std::uint32_t>(count(1, 999999999)));
      log.reach_m = 1000 * number(0.1, 50);
    }
    for (std::size_t i = count(1, 2); i > 0; --i) {
      twin::MadeUpVessel& vessel = traffic.vessels.emplace_back();
      vessel.mmsi = static_cast<std::uint32_t>(10 * count(1, 9999999) + i);
      if (chance(0.5)) vessel.name = pick<std::string>({"a: b", "#1", "\"", "FERRY"});
      vessel.begins_s = number(-86400, 86400);
      for (std::size_t p = count(1, 4); p > 0; --p) vessel.places_m.push_back(on_plan());
      if (vessel.places_m.size() > 1) vessel.speed_m_s = number(0.05, 50);
    }
    traffic.alarm.distance_m = number(1, 20e3);
    traffic.alarm.time_s = 60 * number(0.1, 120);
    return traffic;
  }
};

}  // namespace slackwater::tests
