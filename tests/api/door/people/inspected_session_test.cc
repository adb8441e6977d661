// What a session tells of an inspection under way: which patches are covered, what was found, and
// the surface itself.
#include <gtest/gtest.h>

#include <cmath>
#include <mutex>
#include <set>

#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/http_client.h"
#include "twin/inspection/inspection_outcome.h"

namespace slackwater::tests::inspected_session_test {
namespace {

using nlohmann::json;
using people::Role;

/// An ROV that films the south side of a pile of 6 m on its way along it, 2.5 m off.
const std::string film = R"(name: film
seed: 7
duration: 30min
step_s: 0.05
log_every_s: 1
water: {made_up: {depth_m: 40}}
waves: {from: calm}
structures:
  - {name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6, top_height_m: 20,
     bottom_depth_m: 40}
vehicles:
  - name: rov
    model: bluerov2_heavy
    speed_m_s: 0.4
    start: {north_m: -5.5, east_m: -5, depth_m: 10, heading_deg: 90}
    conduct:
      clear_m: 1
      inspection:
        surfaces: [{kind: monopile, name: pile, north_m: 0, east_m: 0, radius_m: 3,
                    from: {depth_m: 4}, to: {depth_m: 16}}]
        looks: [{instrument: rov_camera, kinds: [monopile], detail_mm: 40, incidence_deg: 70,
                 done_at: 0}]
        water: {visibility_m: 10}
        rays_per_look: 300
        defects: [{kind: corrosion, count: 300, severity_m: 0.006, size_m: 0.4}]
        detection: [rgb_corrosion]
    tasks: [{do: route, phase: work, waypoints: [{north_m: -5.5, east_m: 5, depth_m: 10}]}]
  - {name: other, model: bluerov2_heavy, start: {north_m: 30, east_m: 0, depth_m: 10},
     tasks: [{do: hold}]}
)";

/// What stations are told, added up as the page does.
struct Told {
  std::set<std::size_t> covered;
  double seen = 0;
  json findings = json::array();
  void take(const json& is) {
    if (is["is"] == "findings") findings = is["findings"];
    if (is["is"] != "covered") return;
    seen = is["seen"];
    for (const json& run : is["runs"])
      for (std::size_t i = 0; i < run[1].get<std::size_t>(); ++i) {
        const bool is_new = covered.insert(run[0].get<std::size_t>() + i).second;
        EXPECT_TRUE(is_new) << "told once";
      }
  }
};

TEST(InspectedSession, TellsWhatTheRunHasCoveredAndFound) {
  std::mutex mutex;
  twin::InspectionState last;
  std::shared_ptr<const twin::Inspection> inspection;
  SessionUnderWay::Choice choice;
  choice.real_time_factor = 4;
  choice.also = [&](const api::RunInHand& hand) {
    inspection = hand.run.agents()[0].inspection;
    hand.run.at_barrier([&, &run = hand.run](const twin::StepTime&) {
      const std::lock_guard lock(mutex);
      last = run.states()[0].inspection;
    });
  };
  SessionUnderWay run(film, std::move(choice));
  StationClient sue(run, run.token(Role::supervises));
  const json welcome = sue.hello("Sue");
  EXPECT_EQ(welcome.at("surfaces").size(), 1U) << "known before anybody has looked";
  Told told;
  for (const json& is : welcome.at("covered")) told.take(is);
  ASSERT_FALSE(sue.told("covered", [](const json& is) { return is["seen"] > 0.02; }).is_null());
  expect_taken(sue.asks({{"do", "pause"}}));
  sue.listen(std::chrono::seconds(3));  // what was looked at is told within one
  for (const json& is : sue.messages)
    if (is.contains("vehicle") && is["vehicle"] == 0) told.take(is);

  // Who comes now is told all of it at once, and the same.
  StationClient gus(run, run.token(Role::looks_on));
  const json later = gus.hello("Gus");
  ASSERT_EQ(later.at("surfaces").size(), 1U) << "of the one that inspects";
  const json surface = later["surfaces"][0];
  EXPECT_EQ(surface["vehicle"], 0);
  EXPECT_EQ(surface["name"], "pile");
  EXPECT_EQ(surface["kind"], "monopile");
  EXPECT_EQ(surface["asked"], 0);
  Told at_once;
  for (const json& is : later.at("covered")) at_once.take(is);
  EXPECT_EQ(at_once.covered, told.covered);
  EXPECT_EQ(surface["seen"], told.seen);
  EXPECT_EQ(later.at("findings")[0]["findings"], told.findings);

  // The run is at most a second of its own ahead of what was told: 0.4 m of way.
  const std::lock_guard lock(mutex);
  const twin::InspectionOutcome is = twin::inspection_outcome(*inspection, last);
  ASSERT_EQ(is.parts.size(), 1U);
  for (const std::size_t patch : told.covered) EXPECT_TRUE(is.parts[0].covered[patch]) << patch;
  EXPECT_GT(told.seen, 0.02);
  EXPECT_LE(told.seen, is.parts[0].share() + 1e-4);
  const double a_second = 0.4 * 2 * 2.5 / (12 * 18.85);  // way x height of a picture of the pile
  EXPECT_GT(told.seen, is.parts[0].share() - 2 * a_second);
  double area_m2 = 0;
  for (const std::size_t patch : told.covered)
    area_m2 += inspection->surfaces[0].patches[patch].area_m2;
  EXPECT_NEAR(told.seen, area_m2 / inspection->surfaces[0].area_m2(), 1e-4);
  EXPECT_FALSE(told.findings.empty());
  for (const json& finding : told.findings) {
    EXPECT_EQ(finding["kind"], "corrosion");
    EXPECT_NEAR(std::hypot(finding["at"][0].get<double>(), finding["at"][1].get<double>()), 3, 0.05)
        << "on the pile, but for where the vehicle takes itself to be";
    EXPECT_LT(finding["at"][1].get<double>(), 0) << "on its south side";
  }
}

TEST(InspectedSession, GivesTheSurfaceForDrawing) {
  std::shared_ptr<const twin::Inspection> inspection;
  SessionUnderWay::Choice choice;
  choice.also = [&](const api::RunInHand& hand) { inspection = hand.run.agents()[0].inspection; };
  SessionUnderWay run(film, std::move(choice));
  StationClient gus(run, run.token(Role::looks_on));
  (void)gus.hello("Gus");
  const auto get = [&](const std::string& path, const std::string& token) {
    return HttpClient(run.port())
        .get("/sessions/run/surfaces/" + path, "Authorization: Bearer " + token + "\r\n")
        .value();
  };
  const std::string& token = run.token(Role::looks_on);
  const HttpReply reply = get("0/0", token);
  ASSERT_EQ(reply.status, 200);
  const json surface = json::parse(reply.body);
  const std::size_t triangles = surface["triangles"].size() / 3;
  EXPECT_EQ(surface["patch_of"].size(), triangles);
  EXPECT_EQ(triangles, inspection->surfaces[0].mesh.triangles.size());
  // Round a pile of 3 m, from 4 to 16 m of depth; and outward: what it encloses is a cylinder.
  double six_volumes_m3 = 0;
  const auto corner = [&](std::size_t of) {
    const std::size_t at = 3 * surface["triangles"][of].get<std::size_t>();
    return twin::Triple<double>{surface["corners"][at], surface["corners"][at + 1],
                                surface["corners"][at + 2]};
  };
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto a = corner(3 * i), b = corner(3 * i + 1), c = corner(3 * i + 2);
    six_volumes_m3 += dot(a, cross(b, c));
    for (const auto& at : {a, b, c}) {
      EXPECT_LE(std::hypot(at.x, at.y), 3.001);
      EXPECT_LE(at.z, -3.999);
      EXPECT_GE(at.z, -16.001);
    }
  }
  // Its corners lie on the circle: of a polygon of n sides sin(2 pi/n)/(2 pi/n) of it is enclosed,
  // 0.988 of it with 24 of them.
  EXPECT_LE(six_volumes_m3 / 6, 3.14159 * 9 * 12);
  EXPECT_GE(six_volumes_m3 / 6, 0.988 * 3.14159 * 9 * 12);
  for (const json& patch : surface["patch_of"])
    EXPECT_LT(patch.get<long>(), static_cast<long>(inspection->surfaces[0].patches.size()));
  EXPECT_EQ(get("0/0", "wrong").status, 401);
  for (const char* path : {"0/1", "1/0", "9/0", "x/0", "0/-1", "0/99999999999999999999"})
    EXPECT_EQ(get(path, token).status, 404) << path;
  EXPECT_NE(get("1/0", token).body.find("there are 0/0"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::inspected_session_test
