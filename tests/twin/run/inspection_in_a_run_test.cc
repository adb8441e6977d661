// Vehicles that inspect in a run: what the water does to it, the same bits however they are
// stepped, and what differs between two that carry the same.
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/inspection/inspection_outcome.h"

namespace slackwater::tests::inspection_in_a_run_test {
namespace {

/// An ROV that films the south side of a pile of 6 m on its way along it, 2.5 m off.
std::string rov_that_films(const std::string& more = "", const std::string& name = "rov",
                           double depth_m = 10) {
  return formatted(
             "  - {{name: {}, model: bluerov2_heavy, speed_m_s: 0.4, start: {{north_m: -5.5, "
             "east_m: -5, depth_m: {:g}, heading_deg: 90}}, conduct: {{clear_m: 1, inspection: "
             "{{surfaces: [{{kind: monopile, name: pile, north_m: 0, east_m: 0, radius_m: 3, "
             "from: {{depth_m: 4}}, to: {{depth_m: 16}}}}], looks: [{{instrument: rov_camera, "
             "kinds: [monopile], detail_mm: 40, incidence_deg: 70, done_at: 0}}], water: "
             "{{visibility_m: 10}}, rays_per_look: 300{}}}}}, ",
             name, depth_m, more) +
         formatted(
             "tasks: [{{do: route, phase: work, waypoints: [{{north_m: -5.5, east_m: 5, depth_m: "
             "{:g}}}]}}]}}\n",
             depth_m);
}

std::string water_of(double east_m_s) {
  return formatted(
      "name: test\nseed: 7\nduration: 30min\nstep_s: 0.05\nlog_every_s: 1\nwater: {{made_up: "
      "{{depth_m: 40, current: [{{depth_m: 0, east_m_s: {}, north_m_s: 0}}]}}}}\nwaves: {{from: "
      "calm}}\nstructures:\n  - {{name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: "
      "6, top_height_m: 20, bottom_depth_m: 40}}\nvehicles:\n",
      east_m_s);
}

constexpr const char* defects =
    ", defects: [{kind: corrosion, count: 300, severity_m: 0.006, size_m: 0.4}], detection: "
    "[rgb_corrosion]";

std::unique_ptr<twin::Run> run_of(const std::string& yaml, std::size_t threads = 1,
                                  bool is_batch = true) {
  return begun(ready_of(yaml), 0.05, threads, is_batch);
}

twin::InspectionOutcome outcome_of(twin::Run& run, std::size_t i = 0) {
  return twin::inspection_outcome(*run.agents()[i].inspection, run.states()[i].inspection);
}

TEST(InspectionInARun, CoversTheBandThatItPasses) {
  const auto run = run_of(water_of(0) + rov_that_films());
  while (run->time_s() < 300 && !run->all_ended()) run->step();
  ASSERT_TRUE(run->all_ended());
  const twin::InspectionOutcome out = outcome_of(*run);
  // A picture is 2.5 tan(19.4 deg) high either way at the nearest place, more where the face falls
  // back; of the face it passes the south side, some 5.6 of 18.8 m, at most the half that faces it.
  const double band_m = 2 * 2.5 * std::tan(19.4 * constants::pi / 180);
  const double share = out.share(), low = band_m * 3 / (12 * 18.85),
               high = 2 * band_m * 9.4 / 12 / 18.85;
  EXPECT_GT(share, low);
  EXPECT_LT(share, high);
  EXPECT_GT(out.looks, 5U);
  EXPECT_GT(out.parts[0].seen_m2, out.parts[0].covered_m2);
}

/// As a resurvey of one place is laid out: brought there, it stays, and goes home.
TEST(InspectionInARun, OfWorkThatOnlyStaysSomewhereIsOfThatPlace) {
  std::string yaml = water_of(0) + rov_that_films();
  const std::string tasks = "tasks: [{do: route, phase: work, ";
  const std::size_t at = yaml.find(tasks);
  ASSERT_NE(at, std::string::npos);
  yaml.replace(at, tasks.size(), "tasks: [{do: route, phase: transit, ");
  const std::string end = "}]}]}\n";
  ASSERT_TRUE(yaml.ends_with(end));
  const auto brought = [&](const std::string& then) {
    return yaml.substr(0, yaml.size() - end.size()) + "}]}, " + then + "]}\n";
  };
  const auto run = run_of(brought("{do: hold, phase: work, duration_s: 20}"));
  while (run->time_s() < 300 && !run->all_ended()) run->step();
  const twin::InspectionOutcome out = outcome_of(*run);
  EXPECT_GE(out.looks, 1U) << "it looks from where it was brought";
  EXPECT_GT(out.parts[0].seen_m2, 1);
  // Too far off, it is told how far that is.
  std::string far = brought("{do: hold, phase: work, duration_s: 20}");
  far.replace(far.find("north_m: -5.5, east_m: 5"), 24, "north_m: -45, east_m: 5");
  try {
    (void)run_of(far);
    ADD_FAILURE() << "42 m off, nothing can be seen";
  } catch (const Error& refused) {
    EXPECT_EQ(refused.message().find("inf m"), std::string::npos) << refused.message();
    EXPECT_NE(refused.message().find("m off pile"), std::string::npos) << refused.message();
  }
}

TEST(InspectionInARun, IsTheSameToTheBitHoweverItIsSteppedAndTakenUp) {
  std::string yaml = water_of(0.2);
  for (int i = 0; i < 9; ++i) yaml += rov_that_films(defects, "rov" + std::to_string(i), 6 + i);
  const auto state_after = [](twin::Run& run, int steps) {
    for (int i = 0; i < steps; ++i) run.step();
    std::vector<twin::InspectionState> all;
    for (const twin::AgentState& state : run.states()) all.push_back(state.inspection);
    return all;
  };
  const auto first = run_of(yaml), threads = run_of(yaml, 2), single = run_of(yaml, 1, false),
             before = run_of(yaml), after = run_of(yaml);
  const auto wanted = state_after(*first, 400);
  (void)state_after(*before, 150);
  after->restore(before->checkpoint());
  const std::pair<const char*, std::vector<twin::InspectionState>> others[] = {
      {"two threads", state_after(*threads, 400)},
      {"one by one", state_after(*single, 400)},
      {"taken up", state_after(*after, 250)}};
  for (const auto& [what, states] : others)
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      ASSERT_GT(wanted[i].rays, 0U);
      EXPECT_EQ(states[i].rays, wanted[i].rays) << what << i;
      ASSERT_EQ(states[i].best[0].size(), wanted[i].best[0].size());
      EXPECT_EQ(std::memcmp(states[i].best[0].data(), wanted[i].best[0].data(),
                            wanted[i].best[0].size() * sizeof(twin::BestLook)),
                0)
          << what << i;
    }
}

TEST(InspectionInARun, TwoThatCarryTheSameInstrumentDoNotDrawAlike) {
  const auto run =
      run_of(water_of(0) + rov_that_films(defects, "one") + rov_that_films(defects, "two"));
  while (run->time_s() < 300 && !run->all_ended()) run->step();
  const auto findings_of = [&](std::size_t i) {
    return twin::inspection_findings(*run->agents()[i].inspection, run->states()[i].inspection);
  };
  const twin::InspectionFindings one = findings_of(0), two = findings_of(1);
  // The same truth, seen alike; what is measured of it is each one's own.
  ASSERT_EQ(one.planted.size(), two.planted.size());
  EXPECT_EQ(one.planted[3].patch, two.planted[3].patch);
  ASSERT_FALSE(one.findings.found.empty());
  ASSERT_FALSE(two.findings.found.empty());
  std::size_t alike = 0;
  for (const twin::Finding& a : one.findings.found)
    for (const twin::Finding& b : two.findings.found) alike += a.size_m == b.size_m ? 1 : 0;
  EXPECT_EQ(alike, 0U);
}

}  // namespace
}  // namespace slackwater::tests::inspection_in_a_run_test
