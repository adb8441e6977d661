#include "twin/agent/line_on_deck.h"

#include "tests/support/error_of.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/hung_line.h"
#include "twin/tether/lay_tether.h"
#include "twin/tether/node_load.h"

namespace slackwater::tests::line_on_deck_test {
namespace {

using twin::length_of;
using twin::Triple;

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// A current to the south, the same at all depths and times, and a sea from the west.
std::string uniform_head(double south_m_s, double wave_height_m = 0) {
  return "name: test\nseed: 7\nduration: 30min\nstep_s: 0.05\nlog_every_s: 1\nwater: {made_up: "
         "{depth_m: 60, current: [{depth_m: 0, east_m_s: 0, north_m_s: " +
         number(-south_m_s) + "}]}}\n" +
         (wave_height_m > 0 ? "waves: {components: 32, partitions: [{significant_height_m: " +
                                  number(wave_height_m) + ", peak_period_s: 6, from_deg: 270}]}\n"
                            : "") +
         "vehicles:\n";
}

std::string wamv(const std::string& more = "tasks: [{do: hold}]") {
  return "  - {name: tender, model: wamv16, start: {north_m: 0, east_m: 0, depth_m: 0}, " + more +
         "}\n";
}

/// An ROV on a line from the tender's deck, or from where `line` says.
std::string rov(const Triple<double>& start_m, double length_m, const std::string& tasks,
                const std::string& line = "", const std::string& detail = "full",
                const std::string& conduct = "{}") {
  return "  - {name: rov, model: bluerov2_heavy, start: {north_m: " + number(start_m.x) +
         ", east_m: " + number(start_m.y) + ", depth_m: " + number(start_m.z) +
         "}, conduct: " + conduct + ", detail: " + detail + ", tether: {" + line +
         "length_m: " + number(length_m) + "}" +
         (line.empty() ? ", carrier: {name: tender, forward_m: 1.5, up_m: 1}" : "") + ", tasks: [" +
         tasks + "]}\n";
}

twin::Run run_of(twin::ReadyRun ready, std::size_t threads = 1, bool is_batch = true) {
  twin::RunSettings settings = settings_of(0.05);
  settings.threads = threads;
  settings.is_batch = is_batch;
  return {std::move(ready.agents), std::move(ready.states), settings};
}

TEST(LineOnDeck, ACarrierThatStandsStillIsAFixedTopToTheBit) {
  for (const char* detail : {"full", "coarse"}) {
    // Whatever becomes of her.
    const std::string goes_on = "{behaviour: {do: carry_on}}";
    const std::string hold = "{do: route, waypoints: [{north_m: 12, east_m: 6, depth_m: 15}]}";
    twin::ReadyRun carried =
        ready_of(head(0.05) + wamv() + rov({8, 3, 10}, 30, hold, "", detail, goes_on));
    // She is stepped no more.
    carried.states[0].halt = twin::Halt::no_data;
    const Triple<double> top_m = twin::deck_place(carried.agents[1], carried.states[0]);
    twin::ReadyRun fixed =
        ready_of(head(0.05) + wamv() +
                 rov({8, 3, 10}, 30, hold,
                     "top: {north_m: " + number(top_m.x) + ", east_m: " + number(top_m.y) +
                         ", height_m: " + number(-top_m.z) + "}, ",
                     detail, goes_on));
    fixed.states[0].halt = twin::Halt::no_data;
    twin::Run a = run_of(std::move(carried)), b = run_of(std::move(fixed));
    twin::RunLog by_deck, by_place;
    step_and_log(a, 600, by_deck);
    step_and_log(b, 600, by_place);
    expect_same_bits(by_deck, by_place, detail);
    EXPECT_GT(by_deck.column(1, "tether_tension").back(), 0.5);
  }
}

/// Galileo: towed through still water at V, a line pulls as one that is held in a current of -V
/// and has come to rest there (`settled`, another way of reckoning).
TEST(LineOnDeck, UnderWayALineHangsAsInTheCurrentThatHerWayMakes) {
  for (const char* detail : {"full", "coarse"}) {
    twin::Run run = run_of(ready_of(
        uniform_head(0) +
        wamv("speed_m_s: 0.4, tasks: [{do: route, waypoints: [{north_m: 900, east_m: 0, depth_m: "
             "0}]}]") +
        rov({0, 4, 20}, 28,
            "{do: route, waypoints: [{north_m: 900, east_m: 4, depth_m: 20}], "
            "speed_m_s: 0.4}",
            "", detail)));
    while (run.time_s() < 240) run.step();
    double pulled_n = 0, settled_n = 0;
    for (int look = 0; look < 5; ++look) {
      for (int i = 0; i < 100; ++i) run.step();
      const twin::AgentState& state = run.states()[1];
      const twin::Tether& tether = *run.agents()[1].tether;
      const auto nodes = twin::hung_line(run.agents()[1], state);
      const Triple<double> way_m_s = run.seen(0).velocity_m_s;
      ASSERT_NEAR(way_m_s.x, 0.4, 0.03);
      ASSERT_LT(length_of(way_m_s - run.seen(1).velocity_m_s), 0.03);
      // As long as its tension makes it, from where she has come to and not from where she was.
      const double segment_m = 28.0 / twin::tether_segments;
      EXPECT_NEAR(length_of(nodes[1] - nodes[0]),
                  segment_m * (1 + state.tether.tension_n[0] / tether.axial_stiffness_n), 0.003)
          << detail;
      const twin::SteadyWater past = [&](double) { return -1.0 * way_m_s; };
      const twin::TetherState<double> rest =
          twin::settled(tether, state.tether, nodes.front(), nodes.back(), past);
      pulled_n += state.tether_n / 5;
      settled_n += rest.tension_n.back() / 5;
      for (std::size_t i = 0; i < twin::tether_inner_nodes; ++i)
        EXPECT_LT(length_of(rest.node_m[i] - state.tether.node_m[i]), 0.35) << i;
    }
    EXPECT_GT(settled_n, 1);
    EXPECT_NEAR(pulled_n, settled_n, 0.05 * settled_n) << detail;
  }
}

/// Between barriers, at the smallest step of the vehicle and at the largest of its line, the top
/// is where her velocity takes it.
TEST(LineOnDeck, BetweenBarriersTheTopGoesOnAsTheDeckDid) {
  twin::Run run = run_of(ready_of(uniform_head(0, 1) + wamv() + rov({0, 4, 20}, 40, "{do: hold}")));
  while (run.time_s() < 20) run.step();
  double most_m = 0, moved_m = 0;
  for (int i = 0; i < 400; ++i) {
    const twin::LineTop before = run.states()[1].top;
    run.step();
    const twin::LineTop& after = run.states()[1].top;
    EXPECT_EQ(after.since_s, run.time_s());
    most_m = std::max(most_m, length_of(after.place_m - before.at(run.time_s())));
    moved_m = std::max(moved_m, length_of(after.place_m - before.place_m));
  }
  // What acceleration adds in a step: 0.05^2/2 of some m/s2.
  EXPECT_GT(moved_m, 0.01);
  EXPECT_LT(most_m, 0.003);
}

TEST(LineOnDeck, ADeckThatHeavesSpreadsTheTensionTheMoreTheHigherTheSea) {
  const auto spread_n = [](double wave_height_m, bool is_fixed) {
    const std::string line = is_fixed ? "top: {north_m: 1.5, east_m: 0, height_m: 1}, " : "";
    twin::Run run = run_of(ready_of(uniform_head(0.2, wave_height_m) + wamv() +
                                    rov({6, 0, 24}, 26.5, "{do: hold}", line)));
    while (run.time_s() < 60) run.step();
    double sum = 0, squares = 0;
    constexpr int steps = 2400;
    for (int i = 0; i < steps; ++i) {
      run.step();
      const double tension_n = run.states()[1].tether_n;
      sum += tension_n / steps;
      squares += tension_n * tension_n / steps;
    }
    EXPECT_EQ(run.states()[1].tether.whole, 1);
    return std::sqrt(squares - sum * sum);
  };
  const double low = spread_n(0.1, false), middle = spread_n(0.3, false),
               high = spread_n(0.9, false);
  EXPECT_LT(1.2 * low, middle);
  EXPECT_LT(1.2 * middle, high);
  EXPECT_LT(1.2 * spread_n(0.9, true), high);
}

/// Adrift, she comes to the speed at which her drag takes what the line pulls with: the numbers of
/// her file, by hand.
TEST(LineOnDeck, ACarrierAdriftIsTowedByHerLine) {
  twin::Run run =
      run_of(ready_of(uniform_head(0) + wamv("state_of_charge: 0, tasks: [{do: hold}]") +
                      rov({24, 0, 6}, 24,
                          "{do: route, waypoints: [{north_m: 400, east_m: 0, depth_m: 6}], "
                          "speed_m_s: 1}")));
  while (run.time_s() < 120) run.step();
  double pull_n = 0, speed_m_s = 0;
  constexpr int steps = 1200;
  const double start_m = run.seen(0).position_m.x;
  for (int i = 0; i < steps; ++i) {
    run.step();
    const twin::AgentState& tender = run.states()[0];
    EXPECT_EQ(tender.borne.force_n.x, run.states()[1].top.pull_n.x);
    pull_n += tender.borne.force_n.x / steps;
    speed_m_s += run.seen(0).velocity_m_s.x / steps;
  }
  EXPECT_GT(run.seen(0).position_m.x, start_m + 5);
  EXPECT_EQ(run.states()[1].tether.whole, 1);
  EXPECT_NEAR(pull_n, 51.3 * speed_m_s + 72.4 * speed_m_s * speed_m_s, 0.1 * pull_n);
}

/// Neither the end at the vehicle nor that at the deck pulls for nothing: at rest in still water
/// they bear the line's weight between them, and pull against each other along it.
TEST(LineOnDeck, AtRestBothEndsTogetherBearTheWeightOfTheLine) {
  twin::ReadyRun ready = ready_of(uniform_head(0) + wamv() + rov({10, 0, 12}, 22, "{do: hold}"));
  twin::Run run = run_of(std::move(ready));
  while (run.time_s() < 300) run.step();
  const twin::Tether& tether = *run.agents()[1].tether;
  const twin::AgentState& state = run.states()[1];
  const auto nodes = twin::hung_line(run.agents()[1], state);
  const Triple<double> top_n = state.top.pull_n;
  const Triple<double> along = twin::direction_of(nodes[twin::tether_nodes - 2] - nodes.back());
  const Triple<double> vehicle_n = state.tether_n * along;
  const double water_kg_m =
      tether.water_density_kg_m3 * constants::pi / 4 * tether.diameter_m * tether.diameter_m;
  EXPECT_NEAR(top_n.x + vehicle_n.x, 0, 0.05 * std::abs(top_n.x) + 0.02);
  // One metre of it hangs in air.
  EXPECT_NEAR(top_n.z + vehicle_n.z,
              constants::gravity_m_s2 * ((tether.mass_per_m_kg - water_kg_m) * 22 + water_kg_m),
              0.3);
}

TEST(LineOnDeck, IsRefusedWhereItCannotHang) {
  const auto message = [](const std::string& yaml) {
    return error_of([&] { return ready_of(yaml); });
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  const std::string hold = "{do: hold}";
  const std::string vehicle = rov({8, 3, 10}, 30, hold);
  EXPECT_EQ(message(calm_head(0.05) + wamv() + vehicle), "no error");
  std::string both = vehicle;
  both.replace(both.find("length_m"), 8, "top: {north_m: 0, east_m: 0, depth_m: 0}, length_m");
  EXPECT_TRUE(has(message(calm_head(0.05) + wamv() + both), "from whose deck the line hangs"));
  std::string neither = vehicle;
  const std::string carrier = ", carrier: {name: tender, forward_m: 1.5, up_m: 1}";
  neither.erase(neither.find(carrier), carrier.size());
  EXPECT_TRUE(has(message(calm_head(0.05) + wamv() + neither), "or a carrier"));
  EXPECT_TRUE(has(message(calm_head(0.05) + wamv() + rov({8, 3, 50}, 30, hold)), "it would part"));
  EXPECT_TRUE(has(message(calm_head(0.05) +
                          "  - {name: tender, model: lrauv_tethys, start: {north_m: 0, east_m: 0, "
                          "depth_m: 5}, tasks: [{do: hold}]}\n" +
                          vehicle),
                  "a craft that floats"));
  std::string waits = vehicle;
  waits.replace(waits.find("tasks: ["), 8, "tasks: [{do: aboard, until: stand_by}, ");
  EXPECT_TRUE(has(message(calm_head(0.05) + wamv() + waits), "which does so 0 times"));
  EXPECT_TRUE(has(message(calm_head(0.05) + wamv("tasks: [{do: stand_by}]") + waits),
                  "stands by needs a conduct"));
  EXPECT_EQ(message(calm_head(0.05) + wamv("conduct: {}, tasks: [{do: stand_by}]") + waits),
            "no error");
  std::string alone = waits;
  alone.erase(alone.find(carrier), carrier.size());
  alone.replace(alone.find("tether: {"), 9, "tether: {top: {north_m: 0, east_m: 0, depth_m: 0}, ");
  EXPECT_TRUE(
      has(message(calm_head(0.05) + wamv() + alone), "found until: stand_by without a carrier"));
  std::string far = waits;
  far.replace(far.find("depth_m: 10"), 11, "depth_m: 50");
  EXPECT_TRUE(has(message(calm_head(0.05) + wamv("conduct: {}, tasks: [{do: stand_by}]") + far),
                  "it would part"));
}

}  // namespace
}  // namespace slackwater::tests::line_on_deck_test
