#include "twin/environment/sea_of_run.h"

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "fields/wave/sea_sampling.h"
#include "tests/twin/run/sea_for_tests.h"
#include "twin/agent/conduct.h"

namespace slackwater::tests::sea_of_run_test {
namespace {

/// For as long as asked, with one ROV that has a limit on the waves.
std::string one_rov(const std::string& duration = "1h", const std::string& waves = "{from: calm}") {
  return "name: test\nseed: 7\nstart: 2025-06-02T06:00:00Z\nduration: " + duration +
         "\nstep_s: 0.05\nwater: {made_up: {depth_m: 40}}\nwaves: " + waves +
         "\nvehicles:\n  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, "
         "depth_m: 6}, conduct: {limits: [{significant_wave_height_m: 1.5, if_missing: "
         "not_checked}]}}\n";
}

const std::vector<SeaState> doubling{{1, 6, 250}, {2, 6, 250}, {2, 6, 250}};

twin::ReadyRun ready_in(const std::vector<SeaState>& hourly, const std::string& duration = "1h") {
  const twin::Scenario scenario = with_forecast_waves(one_rov(duration));
  return twin::set_up(scenario, in_forecast_sea(scenario, hourly));
}

double height_m(const SeaRealisation& sea, double t_s) {
  return sea.significant_height_m() * sea.course().at(t_s);
}

/// Of the energy period, which is 0.86 (Pierson-Moskowitz) to 0.9 of it (JONSWAP).
double peak_period_s(const SeaRealisation& sea) {
  double period_m2_s = 0;
  for (const WaveComponent& wave : sea.waves())
    period_m2_s +=
        0.5 * wave.amplitude_m * wave.amplitude_m * 2 * constants::pi / wave.intrinsic_rad_s;
  return period_m2_s / sea.variance_m2() / 0.88;
}

TEST(SeaOfRun, OfAConstantForecastIsTheSeaThatIsStatedSo) {
  const twin::ReadyRun stated = ready_of(one_rov(
      "1h", "{partitions: [{significant_height_m: 1.2, peak_period_s: 6, from_deg: 250}]}"));
  const twin::ReadyRun forecast = ready_in({{1.2, 6, 250}, {1.2, 6, 250}});
  const SeaRealisation& a = *forecast.environment->sea;
  const SeaRealisation& b = *stated.environment->sea;
  EXPECT_TRUE(a.course().is_constant());
  EXPECT_TRUE(b.course().is_constant());
  ASSERT_EQ(a.waves().size(), b.waves().size());
  // Heights and directions of the forecast are means of four columns: their rounding.
  for (std::size_t i = 0; i < a.waves().size(); ++i) {
    EXPECT_NEAR(a.waves()[i].amplitude_m, b.waves()[i].amplitude_m, 1e-12);
    EXPECT_NEAR(std::abs(a.waves()[i].wavenumber_rad_m - b.waves()[i].wavenumber_rad_m), 0, 1e-12);
    EXPECT_EQ(a.waves()[i].phase_rad, b.waves()[i].phase_rad);
  }
}

TEST(SeaOfRun, OfARegularWaveIsThatWaveForEverySeed) {
  const std::string waves = "{regular: {height_m: 0.4, period_s: 5, from_deg: 250}}";
  const twin::ReadyRun ready = ready_of(one_rov("1h", waves));
  const SeaRealisation& sea = *ready.environment->sea;
  ASSERT_EQ(sea.waves().size(), 1U);
  EXPECT_EQ(sea.waves()[0].amplitude_m, 0.2);
  EXPECT_NEAR(sea.waves()[0].intrinsic_rad_s, 2 * constants::pi / 5, 1e-15);
  std::string other = one_rov("1h", waves);
  other.replace(other.find("seed: 7"), 7, "seed: 8");
  EXPECT_EQ(ready_of(other).environment->sea->waves()[0].phase_rad, sea.waves()[0].phase_rad);
  // What limits, and who leads the weather, go by: the sea of its energy.
  const SeaSample state = ready.agents[0].water->sea({}, 1000);
  EXPECT_NEAR(state.sea.significant_height_m, std::sqrt(2.0) * 0.4, 1e-12);
  EXPECT_NEAR(state.sea.significant_height_m, sea.significant_height_m(), 1e-12);
  EXPECT_EQ(state.sea.peak_period_s, 5);
  EXPECT_EQ(state.sea.from_direction_deg, 250);
  EXPECT_EQ(ready.environment->sea_peak_period_s, 5);
}

TEST(SeaOfRun, ARegularWaveThatBreaksInTheWaterOfAForecastIsRefused) {
  twin::Scenario scenario = with_forecast_waves(one_rov());
  scenario.waves = {};
  scenario.waves.from_forecast = false;
  scenario.waves.regular = RegularWave{4, 4, 250};
  try {
    (void)twin::set_up(scenario, in_forecast_sea(scenario, {{1, 6, 250}, {1, 6, 250}}));
    ADD_FAILURE() << "it is not refused";
  } catch (const Error& problem) {
    EXPECT_EQ(problem.message().rfind("waves: a regular wave: found H 4 m with T 4 s", 0), 0U)
        << problem.message();
  }
}

TEST(SeaOfRun, ItsHeightIsTheForecastsAtEveryTime) {
  const twin::ReadyRun ready = ready_in({{1, 6, 250}, {2.2, 7, 260}, {0.4, 5, 200}}, "2h");
  const SeaRealisation& sea = *ready.environment->sea;
  const twin::EnvironmentSampler& water = *ready.agents[0].water;
  for (double t_s = 0; t_s <= 7200; t_s += 97)
    EXPECT_NEAR(height_m(sea, t_s), water.sea({}, t_s).sea.significant_height_m, 1e-9) << t_s;
  EXPECT_NEAR(height_m(sea, 7200), 0.4, 1e-9);
  EXPECT_NEAR(sea.significant_height_m(), 2.2, 1e-9) << "of the largest";
  EXPECT_NEAR(peak_period_s(sea), 6, 0.5) << "of the start";
}

/// The whole chain: what vehicles are moved by has four times the variance when the forecast has
/// twice the height.
TEST(SeaOfRun, TheVarianceOfTheSurfaceFollowsAForecastThatDoubles) {
  const twin::ReadyRun ready = ready_in(doubling, "2h");
  const auto variance_m2 = [&](double t_s) {
    Rng rng(5, "tests/sea_of_run");
    constexpr int count = 10000;
    double sum_m2 = 0;
    for (int i = 0; i < count; ++i) {
      const twin::Triple<double> at{rng.uniform(-2e4, 2e4), rng.uniform(-2e4, 2e4), 20};
      const double up_m = ready.agents[0].water->water(at, 0.3, t_s).motion.elevation_m;
      sum_m2 += up_m * up_m;
    }
    return sum_m2 / count;
  };
  const double error = 4 * std::sqrt(2.0 / 10000);  // four standard errors
  EXPECT_NEAR(16 * variance_m2(0), 1, error);
  EXPECT_NEAR(16 * variance_m2(1800), 2.25, 2.25 * error);
  EXPECT_NEAR(16 * variance_m2(5400), 4, 4 * error);
}

TEST(SeaOfRun, ACalmStartGrowsIntoTheLargestSea) {
  const twin::ReadyRun ready = ready_in({{0, 0, 0}, {1.6, 7, 90}, {1, 6, 90}}, "2h");
  const SeaRealisation& sea = *ready.environment->sea;
  EXPECT_EQ(height_m(sea, 0), 0);
  EXPECT_NEAR(height_m(sea, 1800), 0.8, 1e-9);
  EXPECT_NEAR(height_m(sea, 3600), 1.6, 1e-9);
  EXPECT_NEAR(peak_period_s(sea), 7, 0.6);
  EXPECT_EQ(sample_waves(sea, {3, 4, 0, 0}).motion.elevation_m, 0);
  EXPECT_EQ(sample_waves(sea, {3, 4, 0, 0}).motion.status, SampleStatus::ok);
  EXPECT_TRUE(ready_in({{0, 0, 0}, {0, 0, 0}}).environment->sea == nullptr);
}

/// Waves of 2 s cannot be 3 m high: those that are so high are others.
TEST(SeaOfRun, APeriodTooShortForWhatComesIsNotKept) {
  const twin::ReadyRun ready = ready_in({{0.2, 2, 250}, {3, 9, 250}});
  EXPECT_NEAR(peak_period_s(*ready.environment->sea), 9, 0.8);
  EXPECT_NEAR(height_m(*ready.environment->sea, 0), 0.2, 1e-9);
}

TEST(SeaOfRun, WhereNobodyKnowsTheWavesTheyStayAndThatIsSaid) {
  const double unknown = std::nan("");
  const SeaState nobody_knows{unknown, unknown, unknown};
  const twin::ReadyRun ready = ready_in({{1, 6, 250}, {2, 6, 250}, nobody_knows}, "2h");
  EXPECT_NEAR(height_m(*ready.environment->sea, 7000), 2, 1e-9);
  ASSERT_EQ(ready.warnings.size(), 1U);
  EXPECT_NE(ready.warnings[0].find("no waves there (missing) at 70 min"), std::string::npos)
      << ready.warnings[0];
  const twin::ReadyRun calm = ready_in({nobody_knows, nobody_knows});
  EXPECT_TRUE(calm.environment->sea == nullptr);
  ASSERT_EQ(calm.warnings.size(), 1U);
  EXPECT_NE(calm.warnings[0].find("the sea is calm"), std::string::npos) << calm.warnings[0];
}

TEST(SeaOfRun, ALimitLooksAtTheHeightThatWindowsHasForThatMemberToTheBit) {
  constexpr std::size_t members = 5;
  const twin::Scenario scenario = with_forecast_waves(one_rov("2h"), true);
  const twin::Surround surround = in_forecast_sea(scenario, doubling, members);
  const twin::WaveFutures futures(surround.field->snapshot(), members);
  double most_from_central_m = 0;
  for (std::size_t m = 0; m < members; ++m) {
    twin::Scenario flown = scenario;
    flown.member = m;
    const twin::ReadyRun ready = twin::set_up(flown, surround);
    twin::Environment central = *ready.environment;
    central.waves = nullptr;
    const twin::EnvironmentSampler forecast(central);
    const twin::Limit& limit = ready.agents[0].conduct->plan.limits[0];
    const SeaRealisation& sea = *ready.environment->sea;
    for (double t_s = 0; t_s <= 7200; t_s += 75) {
      const double central_m = forecast.sea({0, 0, 6}, t_s).sea.significant_height_m;
      const UtcTime time = sea_start() + std::chrono::seconds(static_cast<int>(t_s));
      const double looked_at_m = twin::value_of(limit, ready.agents[0], t_s, ready.states[0]);
      EXPECT_EQ(looked_at_m, futures.height_m(m, central_m, time));
      most_from_central_m = std::max(most_from_central_m, std::abs(looked_at_m - central_m));
      if (m == 0) {
        EXPECT_EQ(looked_at_m, central_m);
      }
      // And so high are its waves: to the bend of the error between two nodes, ten minutes apart.
      EXPECT_NEAR(height_m(sea, t_s), looked_at_m, std::fmod(t_s, 600) == 0 ? 1e-9 : 0.01)
          << "member " << m << " at " << t_s;
    }
  }
  EXPECT_GT(most_from_central_m, 0.3) << "they do err";
}

TEST(SeaOfRun, AStatedSeaHasNoErrorAndNoCourse) {
  twin::Scenario scenario = twin::parse_scenario(
      one_rov("1h", "{partitions: [{significant_height_m: 1.2, peak_period_s: 6, from_deg: 250}]}"),
      "test.yaml");
  const twin::Surround surround = in_forecast_sea(scenario, doubling, 3);
  const twin::ReadyRun central = twin::set_up(scenario, surround);
  scenario.member = 2;
  const twin::ReadyRun other = twin::set_up(scenario, surround);
  for (const twin::ReadyRun* ready : {&central, &other}) {
    EXPECT_TRUE(ready->environment->sea->course().is_constant());
    EXPECT_EQ(ready->agents[0].water->sea({}, 1800).sea.significant_height_m, 1.2);
  }
}

/// An ROV on a tether stepped coarsely, two more in full, a craft on the surface: all that meets
/// waves, while they grow from nothing.
std::string fleet_in_growing_waves() {
  std::string yaml =
      "name: test\nseed: 7\nstart: 2025-06-02T06:00:00Z\nduration: 1h\nstep_s: 0.05\nlog_every_s: "
      "0.5\nwater: {made_up: {depth_m: 40}}\nwaves: {from: calm, components: 16}\nvehicles:\n";
  for (int i = 0; i < 3; ++i)
    yaml += "  - {name: rov" + std::to_string(i) +
            ", model: bluerov2_heavy, start: {north_m: " + std::to_string(5 * i) +
            ", east_m: 0, depth_m: 3}" +
            (i == 0 ? ", detail: coarse, tether: {top: {north_m: 0, east_m: 15, depth_m: 1}, "
                      "length_m: 40}}\n"
                    : "}\n");
  return yaml + "  - {name: usv, model: wamv16, start: {north_m: -50, east_m: 0, depth_m: 0}}\n";
}

TEST(SeaOfRun, GivesTheSameBitsOnAnyThreadsInBlocksAndFromACheckpoint) {
  const twin::Scenario scenario = with_forecast_waves(fleet_in_growing_waves(), true);
  twin::Scenario member = scenario;
  member.member = 1;
  // As steep as it gets, so that the height changes from look to look.
  const twin::ReadyRun ready =
      twin::set_up(member, in_forecast_sea(member, {{0, 0, 0}, {8, 12, 250}}, 2));
  ASSERT_FALSE(ready.environment->sea->course().is_constant());
  constexpr int before = 30, after = 60;
  twin::RunSettings settings = settings_of(0.05);
  settings.is_batch = false;
  twin::Run plain(ready.agents, ready.states, settings);
  twin::RunLog skipped, expected;
  step_and_log(plain, before, skipped);
  const twin::Run::Checkpoint checkpoint = plain.checkpoint();
  step_and_log(plain, after, expected);
  for (const KernelPath path : supported_kernel_paths()) {
    for (const std::size_t threads : {1U, 3U}) {
      twin::RunSettings others = settings_of(0.05);
      others.path = path;
      others.threads = threads;
      twin::Run run(ready.agents, ready.states, others);
      twin::RunLog got, again;
      step_and_log(run, before, skipped);
      step_and_log(run, after, got);
      expect_same_bits(got, expected, std::string(name_of(path)));
      run.restore(checkpoint);
      step_and_log(run, after, again);
      expect_same_bits(again, expected, "from a checkpoint");
    }
  }
  // The waves are there.
  const std::vector<double> up_m = expected.column(3, "z");
  EXPECT_NE(up_m.front(), up_m.back());
}

}  // namespace
}  // namespace slackwater::tests::sea_of_run_test
