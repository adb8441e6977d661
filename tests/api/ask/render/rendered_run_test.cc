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
traffic:
  vessels:
    - {mmsi: 211000003, name: ANNE, speed_m_s: 5,
       waypoints: [{north_m: 120, east_m: -70}, {north_m: 120, east_m: 300}]}
vehicles:
  - name: rov
    model: bluerov2_heavy
    start: {north_m: -9, east_m: 0.5, depth_m: 8, heading_deg: 0}
    tether: {top: {north_m: -9, east_m: 4, depth_m: 2}, length_m: 10}
    tasks: [{do: hold}]
  - name: auv
    model: lrauv_tethys
    start: {north_m: -5.5, east_m: -2, depth_m: 8, heading_deg: 90}
    tasks: [{do: hold}]
  - name: behind
    model: lrauv_tethys
    start: {north_m: -14, east_m: 2, depth_m: 5, heading_deg: 0}
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

/// That of the ROV, 3 to 6 m before the AUV that lies behind it: 8 mm are two or three pixels.
TEST_F(RenderedRunOfARun, SeesTheTetherOfAnother) {
  const api::RenderView view = rendered("rov_camera", "behind").view_at(1);
  const auto& truth = std::get<api::CameraView>(view.seen).truth;
  std::size_t of_tether = 0;
  for (std::size_t i = 0; i < truth.pixels(); ++i) {
    if (truth.seen_class[i] != twin::SeenClass::tether) continue;
    EXPECT_EQ(view.things[truth.instance[i] - 1U].name, "rov/tether");
    EXPECT_NEAR(truth.depth_m[i], 4.5, 2.5);
    ++of_tether;
  }
  EXPECT_GT(of_tether, 100U);
}

/// The vessel of the traffic, where its track says: 20 m long, 150 m off, on its way to the east.
TEST_F(RenderedRunOfARun, SeesAVesselPassBy) {
  const api::RenderedRun looking = rendered("uav_camera");
  const auto middle_px = [&](double t_s) {
    const api::RenderView view = looking.view_at(t_s);
    const auto& truth = std::get<api::CameraView>(view.seen).truth;
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < truth.pixels(); ++i) {
      if (truth.seen_class[i] != twin::SeenClass::vessel) continue;
      EXPECT_EQ(view.things[truth.instance[i] - 1U].name, "ANNE");
      EXPECT_NEAR(truth.depth_m[i], 150, 10);
      sum += static_cast<double>(i % static_cast<std::size_t>(truth.wide));
      count += 1;
    }
    EXPECT_GT(count, 200);
    return sum / count;
  };
  // 5 m/s for 4 s, in pixels of 150 m over the focal length.
  const double focal_px = 640 / std::tan(32.5 * constants::degree);
  EXPECT_NEAR(middle_px(5) - middle_px(1), 20 * focal_px / 150, 0.25 * 20 * focal_px / 150);
}

// In the sun the pile is warmer than the sea; the sky is colder the higher it is seen.
TEST_F(RenderedRunOfARun, TellsWarmFromCold) {
  const auto seen = std::get<api::InfraredView>(rendered("uav_infrared").view_at(1).seen);
  std::array<double, twin::seen_classes> sum{}, count{};
  for (std::size_t i = 0; i < seen.truth.pixels(); ++i) {
    const auto kind = static_cast<std::size_t>(seen.truth.seen_class[i]);
    sum[kind] += seen.heat.apparent_k[i];
    ++count[kind];
    EXPECT_EQ(std::isnan(seen.heat.temperature_k[i]), kind == 0);
  }
  const auto mean_k = [&](twin::SeenClass kind) {
    const auto at = static_cast<std::size_t>(kind);
    EXPECT_GT(count[at], 100);
    return sum[at] / count[at];
  };
  EXPECT_GT(mean_k(twin::SeenClass::structure), mean_k(twin::SeenClass::water));
  double highest_k = 0;
  for (int i = 0; i < seen.truth.wide; ++i)
    highest_k += static_cast<double>(seen.heat.apparent_k[static_cast<std::size_t>(i)]) /
                 static_cast<double>(seen.truth.wide);
  ASSERT_EQ(seen.truth.seen_class[0], twin::SeenClass::nothing);
  EXPECT_LT(highest_k, mean_k(twin::SeenClass::nothing) - 0.3);
  const auto again =
      std::get<api::InfraredView>(rendered("uav_infrared", "uav", 2).view_at(1).seen);
  EXPECT_EQ(seen.heat.apparent_k, again.heat.apparent_k);
}

// Blur and flakes change the picture, and nothing of its truth.
TEST_F(RenderedRunOfARun, BlurAndMarineSnowLeaveTheTruthAsItIs) {
  const auto clear = std::get<api::CameraView>(rendered("rov_camera").view_at(3).seen);
  const auto blurred = std::get<api::CameraView>(rendered("rov_camera_blurred").view_at(3).seen);
  EXPECT_EQ(clear.truth.instance, blurred.truth.instance);
  EXPECT_EQ(clear.truth.normal, blurred.truth.normal);
  EXPECT_NE(clear.picture.rgb, blurred.picture.rgb);
  EXPECT_EQ(clear.flakes, 0U);
  EXPECT_GT(blurred.flakes, 20U);
  const auto again =
      std::get<api::CameraView>(rendered("rov_camera_blurred", "rov", 2).view_at(3).seen);
  EXPECT_EQ(blurred.picture.rgb, again.picture.rgb);
}

TEST_F(RenderedRunOfARun, SprayLeavesTheTruthAsItIs) {
  const auto clear = std::get<api::CameraView>(rendered("uav_camera", "uav").view_at(1).seen);
  const auto wet =
      std::get<api::CameraView>(rendered("uav_camera_in_spray", "uav").view_at(1).seen);
  EXPECT_EQ(clear.truth.instance, wet.truth.instance);
  EXPECT_EQ(clear.drops, 0U);
  EXPECT_GT(wet.drops, 100U);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < clear.picture.rgb.size(); ++i)
    changed += clear.picture.rgb[i] != wet.picture.rgb[i];
  EXPECT_GT(changed, 0U);
}

// The second picture is that of a camera 0.12 m to the right; f b / z by the file's own matrix.
TEST_F(RenderedRunOfARun, APairOfCamerasHasItsDisparity) {
  const api::RenderView view = rendered("rov_stereo").view_at(2);
  const auto& seen = std::get<api::CameraView>(view.seen);
  ASSERT_TRUE(seen.right);
  EXPECT_EQ(seen.right->picture.rgb.size(), seen.picture.rgb.size());
  EXPECT_NE(seen.right->picture.rgb, seen.picture.rgb);
  std::size_t both = 0;
  for (std::size_t i = 0; i < seen.truth.pixels(); ++i) {
    if (std::isnan(seen.truth.depth_m[i])) continue;
    EXPECT_NEAR(seen.right->truth.disparity[i], seen.matrix[0] * 0.12 / seen.truth.depth_m[i],
                1e-4);
    both += seen.right->truth.is_in_both[i];
  }
  EXPECT_GT(both, seen.truth.pixels() / 4);
}

// 30 m of water, level; the pile ends in it.
TEST_F(RenderedRunOfARun, SoundsTheBedWhereItLies) {
  const auto swath = std::get<api::MultibeamView>(rendered("multibeam").view_at(5).seen);
  std::size_t on_bed = 0;
  for (const twin::Sounding& one : swath.soundings) {
    if (!std::isfinite(one.true_range_m) || one.true_place_m.z < 29) continue;
    EXPECT_NEAR(one.true_place_m.z, 30, 1e-4);
    if (!std::isfinite(one.range_m)) continue;
    EXPECT_NEAR(one.place_m.z, 30,
                6 * (0.01 + 0.001 * one.range_m + 0.05 * constants::degree * one.range_m));
    ++on_bed;
  }
  EXPECT_GT(on_bed, 300U);
  const api::RenderView one = rendered("echo_sounder").view_at(5);
  const auto& sounding = std::get<twin::EchoSounding>(one.seen);
  EXPECT_NEAR(one.pose.position_m.z + sounding.axis_range_m * one.pose.axis.z, 30, 1e-4);
  EXPECT_NEAR(sounding.range_m, sounding.footprint_range_m,
              6 * (0.01 + 0.005 * sounding.footprint_range_m));
}

// The run's own current, to the east, and its waves, which the depth takes away.
TEST_F(RenderedRunOfARun, ProfilesTheCurrentThatTheRunHas) {
  const auto profile = std::get<twin::CurrentProfile>(rendered("adcp").view_at(5).seen);
  std::size_t told = 0;
  double sum = 0;
  for (const twin::ProfileBin& bin : profile.bins) {
    if (bin.depth_m > 20 && bin.depth_m < 28) {
      // exp(-k z) of waves of 6 s at 20 m is 0.1 of some 0.5 m/s; piles turn a little of it.
      EXPECT_NEAR(bin.true_velocity_m_s.y, 0.1, 0.06);
      EXPECT_NEAR(bin.true_velocity_m_s.x, 0, 0.06);
    }
    if (bin.flaw != twin::BinFlaw::none) continue;
    // One ping, 64 mm/s along a beam: over 2^(1/2) sin(20 degrees) across.
    EXPECT_NEAR(bin.velocity_m_s.y, bin.true_velocity_m_s.y, 5 * 0.064 / 1.414 / 0.342 + 0.1);
    sum += bin.velocity_m_s.y - bin.true_velocity_m_s.y;
    ++told;
  }
  EXPECT_GE(told, 15U);
  EXPECT_NEAR(sum / static_cast<double>(told), 0,
              4 * 0.064 / 1.414 / 0.342 / std::sqrt(static_cast<double>(told)) + 0.02);
  EXPECT_EQ(profile.bins.back().flaw, twin::BinFlaw::side_lobe) << "below the bed";
}

TEST_F(RenderedRunOfARun, OfSoundIsTheSameOnAnyNumberOfThreads) {
  const auto seen = [&](const char* sensor, int threads) {
    return rendered(sensor, "rov", threads).view_at(3).seen;
  };
  EXPECT_EQ(std::get<twin::SideScanPing>(seen("side_scan", 1)).intensity,
            std::get<twin::SideScanPing>(seen("side_scan", 2)).intensity);
  EXPECT_EQ(std::get<twin::EchoSounding>(seen("echo_sounder", 1)).intensity,
            std::get<twin::EchoSounding>(seen("echo_sounder", 2)).intensity);
  const auto one = std::get<api::MultibeamView>(seen("multibeam", 1)).soundings;
  const auto two = std::get<api::MultibeamView>(seen("multibeam", 2)).soundings;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (std::isfinite(one[i].range_m)) {
      EXPECT_EQ(one[i].range_m, two[i].range_m);
    }
  }
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
