// The published closed-loop experiment flown again: 26 dates, four transects of 304 s, a BlueROV2
// in the measured profile (the reference), in a Gauss-Markov current fitted to it and in the
// mixed-layer profile that we fit to it. Before any time: the water is that of the files, the
// random one has the moments that it was given, and no run depends on the others.
//
// Not stated by the publication and chosen here (calibration/docs/published_evaluation.md): 0.5 m/s
// over ground due east, one sinusoid in 150 s, our autopilot without knowledge of the current, 15 W
// of hotel load; cross-track is the distance from the line in the plane, control effort the root
// mean square of the thrust of the eight thrusters together.
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <string>

#include "fields/base/numbers/random.h"
#include "tests/bench/bench_report.h"
#include "tests/published/fit_profile.h"
#include "tests/published/published_profiles.h"
#include "tests/support/own_autopilot.h"
#include "tests/support/shared_data.h"
#include "twin/control/patterns.h"
#include "twin/environment/made_up_field.h"
#include "twin/run/set_up.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr double duration_s = 304;
constexpr double step_s = 0.05;
constexpr double speed_m_s = 0.5;
constexpr double period_s = 150;
constexpr double target_s = 60;
constexpr double deepest_m = 150;

const UtcTime start = parse_utc("2025-06-02T00:00:00Z");
const GeoPoint box = GeoPoint::from_degrees(46.8, -6.125);

struct Transect {
  const char* name;
  double shallow_m;
  double deep_m;
};
constexpr std::array transects{Transect{"level", 25, 25}, Transect{"sweep_a", 10, 40},
                               Transect{"sweep_b", 45, 75}, Transect{"sweep_c", 80, 110}};
constexpr std::array model_names{"reference", "Gauss-Markov", "ours"};
constexpr std::size_t models = model_names.size();
constexpr std::size_t metrics = 3;  ///< energy, cross-track, control effort

using Levels = std::vector<calibration::ProfileLevel>;

// --- the three waters ---------------------------------------------------------------------------

std::shared_ptr<const Field> constant_in_time(const std::vector<double>& depths_m,
                                              const std::vector<Horizontal>& profile) {
  std::vector<Horizontal> current = profile;
  current.insert(current.end(), profile.begin(), profile.end());
  return twin::made_up_field({start, start + std::chrono::hours(1)}, depths_m, current, {}, box,
                             4000);
}

std::shared_ptr<const Field> measured(const Levels& levels) {
  std::vector<double> depths_m;
  std::vector<Horizontal> profile;
  for (const auto& level : levels) {
    depths_m.push_back(level.depth_m);
    profile.push_back(level.current_m_s);
  }
  return constant_in_time(depths_m, profile);
}

std::shared_ptr<const Field> fitted(const Levels& levels) {
  const auto fit = calibration::fit_profile(levels, Angle::from_degrees(46.8));
  std::vector<double> depths_m;
  std::vector<Horizontal> profile;
  for (int depth = 0; depth <= deepest_m; ++depth) {
    depths_m.push_back(depth);
    profile.push_back(to_horizontal(fit.profile.at_depth(depth)));
  }
  return constant_in_time(depths_m, profile);
}

/// Mean and standard deviation of each component over the levels.
struct Moments {
  Horizontal mean;
  Horizontal deviation;
};
Moments moments_of(const std::vector<Horizontal>& values) {
  Moments m;
  const auto n = static_cast<double>(values.size());
  for (const Horizontal& v : values) m.mean += v / n;
  double east = 0, north = 0;
  for (const Horizontal& v : values) {
    east += std::pow(v.real() - m.mean.real(), 2) / n;
    north += std::pow(v.imag() - m.mean.imag(), 2) / n;
  }
  m.deviation = {std::sqrt(east), std::sqrt(north)};
  return m;
}
Moments moments_of(const Levels& levels) {
  std::vector<Horizontal> values;
  for (const auto& level : levels) values.push_back(level.current_m_s);
  return moments_of(values);
}

/// dx = -(x - mean)/tau dt + noise, each component by itself, one value a second, stationary from
/// the start.
std::vector<Horizontal> gauss_markov(const Moments& m, std::size_t stamps, Rng& rng) {
  constexpr double tau_s = 60;
  const double kept = std::exp(-1 / tau_s), fresh = std::sqrt(1 - kept * kept);
  std::vector<Horizontal> out;
  Horizontal x{rng.normal(), rng.normal()};
  for (std::size_t i = 0; i < stamps; ++i) {
    out.push_back(m.mean +
                  Horizontal(m.deviation.real() * x.real(), m.deviation.imag() * x.imag()));
    x = kept * x + fresh * Horizontal(rng.normal(), rng.normal());
  }
  return out;
}

std::shared_ptr<const Field> wandering(const Levels& levels, Rng& rng) {
  std::vector<UtcTime> times;
  for (int s = 0; s <= static_cast<int>(duration_s) + 1; ++s)
    times.push_back(start + std::chrono::seconds(s));
  const std::vector<Horizontal> current = gauss_markov(moments_of(levels), times.size(), rng);
  return twin::made_up_field(times, {0}, current, {}, box, 4000);
}

// --- the runs -----------------------------------------------------------------------------------

twin::ScenarioVehicle entry_of(const Transect& transect, const std::string& name) {
  const double length_m = speed_m_s * duration_s + 20;
  twin::ScenarioVehicle entry;
  entry.name = name;
  entry.follower = twin::FollowerChoice::no_feed_forward;
  entry.heading_rad = 0.5 * constants::pi;
  entry.start_m = {0, 0, 0.5 * (transect.shallow_m + transect.deep_m)};
  twin::ScenarioTask task;
  task.waypoints = twin::depth_sweep(entry.start_m, entry.heading_rad, length_m, transect.shallow_m,
                                     transect.deep_m, speed_m_s * period_s, 2, speed_m_s);
  // A waypoint's speed is along its leg: 0.5 m/s east whatever the slope.
  twin::Triple<double> from = entry.start_m;
  for (twin::Waypoint& to : task.waypoints) {
    const twin::Triple<double> leg = to.position_m - from;
    to.speed_m_s = speed_m_s * std::sqrt(dot(leg, leg)) / std::hypot(leg.x, leg.y);
    from = to.position_m;
  }
  entry.tasks.push_back(task);
  return entry;
}

/// What one run came to, in the order of the metrics.
using Outcome = std::array<double, metrics>;

/// Runs that may be made together: date by date, within it transect by transect, within it model by
/// model.
class Fleet {
 public:
  explicit Fleet(const std::vector<tests::PublishedProfile>& profiles) {
    const auto data = tests::source_folder() / "data";
    vehicle_ = std::make_shared<const twin::Vehicle>(
        twin::read_vehicle(data / "vehicles" / "bluerov2_heavy.yaml", data));
    for (const tests::PublishedProfile& profile : profiles) {
      const auto replayed = live(measured(profile.levels));
      const auto modelled = live(fitted(profile.levels));
      for (const Transect& transect : transects) {
        const std::string name = profile.date + "/" + transect.name;
        Rng rng(1, "bench/gauss_markov/" + name);
        const auto random = live(wandering(profile.levels, rng));
        for (const auto& water : {replayed, random, modelled}) add(water, entry_of(transect, name));
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return agents_.size(); }
  [[nodiscard]] const std::vector<std::size_t>& halted() const { return halted_; }

  /// Makes the runs `from` to `to`.
  [[nodiscard]] std::vector<Outcome> flown(std::size_t from, std::size_t to, std::size_t threads) {
    const auto part = [&](const auto& all) {
      using List = std::decay_t<decltype(all)>;
      return List(all.begin() + static_cast<std::ptrdiff_t>(from),
                  all.begin() + static_cast<std::ptrdiff_t>(to));
    };
    twin::RunSettings settings;
    settings.seed = 1;
    settings.step_s = step_s;
    settings.threads = threads;
    twin::Run run(part(agents_), part(states_), settings);
    const auto steps = static_cast<int>(std::lround(duration_s / step_s));
    std::vector<Outcome> sums(to - from);
    run.at_barrier([&](const twin::StepTime&) {
      for (std::size_t i = 0; i < sums.size(); ++i) {
        const twin::AgentState& state = run.states()[i];
        sums[i][1] += std::pow(state.vehicle.body.position_m.x, 2);
        for (const double thrust : state.vehicle.thrust_n) sums[i][2] += thrust * thrust;
      }
    });
    for (int i = 0; i < steps; ++i) run.step();
    halted_.clear();
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const twin::AgentState& state = run.states()[i];
      if (state.halt != twin::Halt::none) halted_.push_back(from + i);
      sums[i] = {state.vehicle.battery.delivered_j / 3600, std::sqrt(sums[i][1] / steps),
                 std::sqrt(sums[i][2] / steps)};
    }
    return sums;
  }

 private:
  using Water = std::shared_ptr<const twin::EnvironmentSampler>;
  Water live(std::shared_ptr<const Field> field) {
    auto environment = std::make_shared<twin::Environment>();
    environment->field = std::move(field);
    environment->origin = box;
    environment->epoch = start;
    environments_.push_back(environment);
    return std::make_shared<const twin::EnvironmentSampler>(*environment);
  }
  void add(const Water& water, const twin::ScenarioVehicle& entry) {
    agents_.push_back(twin::make_agent(vehicle_, water, entry, step_s));
    // A sinusoid of 15 m in 150 s sinks and climbs at 0.63 m/s; the usual bound is 0.5.
    tests::change_autopilot(agents_.back(), [](twin::AutopilotSettings& own) {
      own.most_climb_m_s = 1;
      own.most_descent_m_s = 1;
    });
    states_.push_back(twin::first_state(agents_.back(), entry, 1));
  }
  std::shared_ptr<const twin::Vehicle> vehicle_;
  std::vector<std::shared_ptr<const twin::Environment>> environments_;
  std::vector<twin::Agent> agents_;
  std::vector<twin::AgentState> states_;
  std::vector<std::size_t> halted_;
};

// --- the table ----------------------------------------------------------------------------------

double geometric_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += std::log(v);
  return std::exp(sum / static_cast<double>(values.size()));
}

struct DateRow {
  std::array<double, transects.size()> ratio{};
  double pooled_ratio = 0;
  double ref_wh = 0;
  double gm_percent = 0;
  double ekman_percent = 0;
};

DateRow row_of(const std::vector<Outcome>& outcomes, std::size_t date) {
  DateRow row;
  std::vector<double> pooled, reference, gm, ekman;
  for (std::size_t t = 0; t < transects.size(); ++t) {
    const Outcome* const run = &outcomes[(date * transects.size() + t) * models];
    std::vector<double> ratios;
    for (std::size_t k = 0; k < metrics; ++k) {
      // Two runs that agree to 1e-9 are alike, not infinitely better.
      const double least = 1e-9 * run[0][k];
      ratios.push_back(std::max(std::abs(run[1][k] - run[0][k]), least) /
                       std::max(std::abs(run[2][k] - run[0][k]), least));
    }
    row.ratio[t] = geometric_mean(ratios);
    pooled.push_back(row.ratio[t]);
    reference.push_back(run[0][0]);
    gm.push_back(100 * (run[1][0] / run[0][0] - 1));
    ekman.push_back(100 * (run[2][0] / run[0][0] - 1));
  }
  row.pooled_ratio = geometric_mean(pooled);
  row.ref_wh = median_of(reference);
  row.gm_percent = median_of(gm);
  row.ekman_percent = median_of(ekman);
  return row;
}

void print_aggregates(const char* whose, const std::vector<DateRow>& rows) {
  std::vector<double> pooled, gm, ekman, wh;
  int closer = 0, favours = 0;
  for (const DateRow& row : rows) {
    pooled.push_back(row.pooled_ratio);
    gm.push_back(row.gm_percent);
    ekman.push_back(row.ekman_percent);
    wh.push_back(row.ref_wh);
    closer += std::abs(row.ekman_percent) < std::abs(row.gm_percent) ? 1 : 0;
    favours += row.pooled_ratio > 1 ? 1 : 0;
  }
  std::printf(
      "%-26s pooled ratio: geometric mean %.2f, median %.2f, above 1 on %d of %zu; closer on "
      "energy on %d; median reference %.2f Wh; energy bias, median: GM %+.1f %%, Ekman "
      "%+.1f %%\n",
      whose, geometric_mean(pooled), median_of(pooled), favours, rows.size(), closer, median_of(wh),
      median_of(gm), median_of(ekman));
}

/// Columns of published_closed_loop.csv.
std::vector<DateRow> published_rows(const std::filesystem::path& file) {
  std::vector<DateRow> rows;
  for (const auto& cells : tests::csv_rows(file)) {
    DateRow row;
    for (std::size_t t = 0; t < transects.size(); ++t)
      row.ratio[t] = std::stod(cells.at(3 + 2 * t));
    row.pooled_ratio = std::stod(cells.at(11));
    row.ref_wh = std::stod(cells.at(12));
    row.gm_percent = std::stod(cells.at(13));
    row.ekman_percent = std::stod(cells.at(14));
    rows.push_back(row);
  }
  return rows;
}

void print_table(const std::vector<tests::PublishedProfile>& profiles,
                 const std::vector<Outcome>& outcomes, const std::filesystem::path& published) {
  std::printf("%-10s %8s %8s %8s %8s | %8s %7s %7s %7s\n", "date", "level", "sweep_a", "sweep_b",
              "sweep_c", "pooled", "ref Wh", "GM %", "ours %");
  std::vector<DateRow> rows;
  for (std::size_t d = 0; d < profiles.size(); ++d) {
    rows.push_back(row_of(outcomes, d));
    const DateRow& row = rows.back();
    std::printf("%-10s %8.2f %8.2f %8.2f %8.2f | %8.2f %7.3f %+7.2f %+7.2f\n",
                profiles[d].date.c_str(), row.ratio[0], row.ratio[1], row.ratio[2], row.ratio[3],
                row.pooled_ratio, row.ref_wh, row.gm_percent, row.ekman_percent);
  }
  for (std::size_t m = 0; m < models; ++m) {
    std::array<std::vector<double>, metrics> all;
    for (std::size_t i = m; i < outcomes.size(); i += models)
      for (std::size_t k = 0; k < metrics; ++k) all[k].push_back(outcomes[i][k]);
    std::printf("%-14s medians: %.3f Wh, %.4f m cross-track, %.2f N\n", model_names[m],
                median_of(all[0]), median_of(all[1]), median_of(all[2]));
  }
  std::printf("reference energy by transect, medians:");
  for (std::size_t t = 0; t < transects.size(); ++t) {
    std::vector<double> wh;
    for (std::size_t d = 0; d < profiles.size(); ++d)
      wh.push_back(outcomes[(d * transects.size() + t) * models][0]);
    std::printf(" %s %.2f Wh", transects[t].name, median_of(wh));
  }
  std::printf("\n");
  print_aggregates("ours, these dates:", rows);
  print_aggregates("published, these dates:", published_rows(published));
  std::printf(
      "published, 40 dates:       pooled ratio 1.48; closer on energy on 20 of 40; energy "
      "bias GM +0.9 %%, Ekman -4.8 %%; 6 min a run\n");
}

// --- the answers --------------------------------------------------------------------------------

bool replays_the_file(const Levels& levels) {
  const auto field = measured(levels);
  double worst = 0;
  for (const auto& level : levels) {
    const CurrentSample sample = field->current(
        {box.longitude_deg(), box.latitude_deg(), level.depth_m, start + std::chrono::seconds(77)});
    worst = std::max(
        worst, has_value(sample.status) ? std::abs(sample.velocity_m_s - level.current_m_s) : 1e9);
  }
  return worst < 1e-6;  // a field keeps 32 bits
}

/// Over three days of it: 4320 times tau, moments within some 4 standard errors of sqrt(2 tau/T).
bool wanders_as_told(const Levels& levels) {
  Rng rng(2, "bench/gauss_markov_check");
  const Moments told = moments_of(levels);
  const Moments found = moments_of(gauss_markov(told, 3 * 86400, rng));
  const auto near = [](double a, double b, double scale) { return std::abs(a - b) < 0.09 * scale; };
  return near(found.mean.real(), told.mean.real(), told.deviation.real()) &&
         near(found.mean.imag(), told.mean.imag(), told.deviation.imag()) &&
         near(found.deviation.real(), told.deviation.real(), told.deviation.real()) &&
         near(found.deviation.imag(), told.deviation.imag(), told.deviation.imag());
}

void bench_published(BenchReport& report) {
  const auto shared = tests::shared_folder();
  if (!shared || !std::filesystem::exists(*shared / "data" / "brest" / "profiles")) {
    report.skipped("published runs", "no real data: set SLACKWATER_SHARED to their folder");
    return;
  }
  const auto folder = *shared / "data" / "brest";
  auto profiles = tests::published_profiles(folder / "profiles", deepest_m);
  if (report.options().check_only) profiles.resize(1);
  bool waters = true;
  for (const auto& profile : profiles) waters = waters && replays_the_file(profile.levels);
  report.answer("waters", waters && wanders_as_told(profiles.front().levels),
                "the measured profiles replayed and a Gauss-Markov current with their moments");
  const auto begin = std::chrono::steady_clock::now();
  Fleet fleet(profiles);
  const auto ready = std::chrono::steady_clock::now();
  const std::vector<Outcome> outcomes = fleet.flown(0, fleet.size(), 2);
  const auto end = std::chrono::steady_clock::now();
  const bool all_went_on = fleet.halted().empty();
  double farthest_m = 0;
  for (const Outcome& outcome : outcomes) farthest_m = std::max(farthest_m, outcome[1]);
  // A run of the middle by itself, on one thread: the same bits.
  const std::size_t middle = fleet.size() / 2;
  const bool same = fleet.flown(middle, middle + 1, 1).front() == outcomes[middle];
  char text[200];
  std::snprintf(text, sizeof text, "%zu runs, %s, at most %.2f m off the line (rms), alone %s",
                fleet.size(), all_went_on ? "none halted" : "SOME HALTED", farthest_m,
                same ? "the same bits" : "OTHER BITS");
  const bool right = all_went_on && same && farthest_m < 2;
  report.answer("runs", right, text);
  if (!right || report.options().check_only) return;
  if (!report.options().json) print_table(profiles, outcomes, folder / "published_closed_loop.csv");
  const auto seconds = [](auto from, auto to) {
    return std::chrono::duration<double>(to - from).count();
  };
  report.figure({"312 published runs on 2 threads",
                 "s",
                 {seconds(begin, end)},
                 target_s,
                 "published: 6 min a run"});
  report.figure({"  of which fits and set-up", "s", {seconds(begin, ready)}, std::nullopt, ""});
}

}  // namespace

int main(int argc, char** argv) {
  BenchReport report(bench_options(argc, argv));
  try {
    bench_published(report);
  } catch (const std::exception& problem) {
    report.answer("published runs", false, problem.what());
  }
  return report.exit_code();
}
