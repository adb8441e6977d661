#include "api/ask/render/rendered_run.h"

#include <cmath>
#include <functional>

#include "api/program/paths.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/api/ask/run/logged_runs.h"
#include "twin/scene/structure.h"

namespace slackwater::tests::rendered_run_test {
namespace {

const std::string yaml = R"(name: before a pile
seed: 11
origin: {latitude_deg: 54, longitude_deg: 6}
start: 2025-06-10T11:00:00Z
duration: 1min
step_s: 0.05
log_every_s: 1
water: {made_up: {depth_m: 30, current: [{depth_m: 0, east_m_s: 0.1, north_m_s: 0}]}}
waves:
  components: 24
  partitions: [{significant_height_m: 1, peak_period_s: 6, from_deg: 270}]
structures:
  - {name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6, top_height_m: 12,
     bottom_depth_m: 30}
vehicles:
  - name: rov
    model: bluerov2_heavy
    start: {north_m: -9, east_m: 0.5, depth_m: 8, heading_deg: 0}
    tasks: [{do: hold}]
  - name: auv
    model: lrauv_tethys
    start: {north_m: -5.5, east_m: -2, depth_m: 8, heading_deg: 90}
    tasks: [{do: hold}]
  - name: uav
    model: x500
    start: {north_m: -30, east_m: 0, height_m: 10, heading_deg: 0}
    tasks: [{do: hold}]
)";

class RenderedRunOfARun : public LoggedRuns {
 protected:
  RenderedRunOfARun() : LoggedRuns(yaml), log_(make("run.nc", {}).log) {}
  [[nodiscard]] api::RenderedRun rendered(const std::string& sensor,
                                          const std::string& vehicle = {}, int threads = 1) const {
    api::RenderChoice choice;
    choice.log = log_;
    choice.sensor = sensor;
    choice.vehicle = vehicle;
    choice.threads = threads;
    return {choice, folder_.path() / "store"};
  }
  std::filesystem::path log_;
};

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& problem) {
    return problem.message();
  }
  return "";
}

// What the pixels meet is what the run's own structure is met at, and the other vehicle is there.
TEST_F(RenderedRunOfARun, SeesThePileWhereItStands) {
  const api::RenderedRun looking = rendered("rov_camera");
  EXPECT_EQ(looking.vehicle(), "rov");
  const api::RenderView view = looking.view_at(2.5);
  const auto& seen = std::get<api::CameraView>(view.seen);
  const twin::RenderSensor& sensor = looking.sensor();
  const twin::Pinhole camera(view.pose, std::get<twin::CameraSheet>(sensor.device).frame);
  const twin::Structure pile = twin::Cylinder{0, 0, 3, -12, 30};
  std::size_t met = 0, of_auv = 0;
  for (int j = 0; j < camera.high(); j += 7)
    for (int i = 0; i < camera.wide(); i += 7) {
      const auto at = static_cast<std::size_t>(j * camera.wide() + i);
      const twin::SeenClass kind = seen.truth.seen_class[at];
      of_auv += kind == twin::SeenClass::vehicle ? 1 : 0;
      if (kind != twin::SeenClass::structure) continue;
      const auto hit = twin::first_hit(pile, camera.ray(i, j));
      // Near its outline the prism of 96 faces is missed or met where the cylinder is not.
      if (!hit || hit->squareness(camera.ray(i, j)) < 0.2) continue;
      // A facet lies within R (1 - cos(pi/96)), 1.6 mm, of the cylinder.
      EXPECT_NEAR(seen.truth.range_m[at], hit->range_m, 0.0017 / 0.2);
      ++met;
    }
  EXPECT_GT(met, 300U);
  EXPECT_GT(of_auv, 10U);
  EXPECT_EQ(seen.picture.rgb.size(), 3 * seen.truth.pixels());
}

TEST_F(RenderedRunOfARun, IsTheSameToTheBitAgainAndOnAnyNumberOfThreads) {
  const api::RenderView one = rendered("rov_camera").view_at(3),
                        two = rendered("rov_camera", "rov", 3).view_at(3);
  const auto& a = std::get<api::CameraView>(one.seen);
  const auto& b = std::get<api::CameraView>(two.seen);
  EXPECT_EQ(a.picture.rgb, b.picture.rgb);
  EXPECT_EQ(a.truth.instance, b.truth.instance);
  const auto sonar = [&](int threads) {
    return std::get<twin::SonarImage>(rendered("imaging_sonar", "rov", threads).view_at(3).seen)
        .intensity;
  };
  EXPECT_EQ(sonar(1), sonar(2));
}

TEST_F(RenderedRunOfARun, InAirSeesSkySeaAndPile) {
  const api::RenderView view = rendered("uav_camera").view_at(1);
  const auto& truth = std::get<api::CameraView>(view.seen).truth;
  std::array<std::size_t, twin::seen_classes> count{};
  for (const twin::SeenClass kind : truth.seen_class) ++count[static_cast<std::size_t>(kind)];
  EXPECT_GT(count[static_cast<std::size_t>(twin::SeenClass::nothing)], truth.pixels() / 10);
  EXPECT_GT(count[static_cast<std::size_t>(twin::SeenClass::water)], truth.pixels() / 10);
  EXPECT_GT(count[static_cast<std::size_t>(twin::SeenClass::structure)], truth.pixels() / 100);
  const auto scan = std::get<twin::LidarScan>(rendered("uav_lidar").view_at(1).seen);
  float nearest_m = 1000;
  for (std::size_t i = 0; i < scan.range_m.size(); ++i)
    if (scan.true_range_m[i] < nearest_m) nearest_m = scan.true_range_m[i];
  // The lowest channel, 22.5 degrees down, meets the sea 10 m below; waves are some decimetres.
  EXPECT_NEAR(nearest_m, 10 / std::sin(22.5 * constants::degree), 3);
}

TEST_F(RenderedRunOfARun, WhatCannotBeIsOneClearError) {
  EXPECT_NE(
      refusal([&] { (void)rendered("rov_camera", "uav").view_at(1); }).find("found it in air at"),
      std::string::npos);
  EXPECT_NE(refusal([&] {
              (void)rendered("rov_camera").view_at(999);
            }).find("found 999 s, expected a time of the run, 0 to 60 s"),
            std::string::npos);
  EXPECT_NE(refusal([&] { (void)rendered("rov_camera", "usv"); }).find("found no vehicle usv"),
            std::string::npos);
  EXPECT_NE(refusal([&] { (void)rendered("rov_camra"); }).find("rov_camera"), std::string::npos);
  ingest::TrajectoryFile bare = ingest::read_trajectories(log_);
  std::erase_if(bare.attributes, [](const auto& entry) { return entry.first == "scenario"; });
  ingest::write_trajectories(bare, log_);
  EXPECT_NE(refusal([&] { (void)rendered("rov_camera"); }).find("holds no scenario"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::rendered_run_test
