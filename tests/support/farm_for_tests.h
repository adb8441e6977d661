#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <span>
#include <string>

#include "tests/support/store_for_tests.h"

namespace slackwater::tests {

/// A pile of 5 m in 30 m of water.
inline const std::string pile_yaml = R"(
water_depth_m: 30
hub_height_m: 80
landing_deg: 0
foundation: {kind: monopile, diameter_m: 5, top_height_m: 18}
)";

/// A farm of one such pile, T1, where no product is: for missions in made-up water.
inline std::string farm_yaml() {
  return "id: farm\nlatitude_deg: 48.9\nlongitude_deg: -3.1\n" + pile_yaml +
         "turbines: [{id: T1, latitude_deg: 48.9, longitude_deg: -3.1}]\n";
}

/// An ROV that looks at a pile: the head of an agent of a task.
inline const std::string eye_yaml = R"(agents:
  - role: eye
    kinds: [rov]
    needs: [camera]
    model: bluerov2_heavy
    speed_m_s: 0.4
    start: {distance_m: 12, depth_m: 3}
)";
/// Its work: down and up beside the pile, twice.
inline const std::string eyes_work_yaml = R"(    work:
      - {pattern: verticals, stand_off_m: 3, from: {depth_m: 4}, to: {depth_m: 9}, bearings: 2}
)";

/// The site of the test products with such a pile, the turbine T1, at its point.
/// @param more  lines of YAML beside
inline std::string farm_at_the_site(const StoreForTests& made, const std::string& more = "") {
  std::string site = read_bytes(made.site());
  const auto value_of = [&](const std::string& key) {
    const std::size_t at = site.find(key + ": ") + key.size() + 2;
    return site.substr(at, site.find('\n', at) - at);
  };
  const std::string place =
      "latitude_deg: " + value_of("latitude_deg") + ", longitude_deg: " + value_of("longitude_deg");
  for (const char* key : {"water_depth_m", "hub_height_m", "turbines"})
    if (const std::size_t at = site.find(std::string(key) + ":"); at != std::string::npos)
      site.erase(at, site.find('\n', at) + 1 - at);
  return site + pile_yaml + "turbines: [{id: T1, " + place + "}]\n" + more;
}

/// A part of a task's file, what stands there instead, and what is said of it.
struct BadTask {
  const char* what;
  const char* instead;
  const char* says;
};

/// That a mission is refused before its first step, with nothing written, for each of them.
/// @param file  of the task beside mission.yaml
inline void expect_refused(StoreForTests& made, const std::string& file, const std::string& task,
                           std::span<const BadTask> all) {
  for (const BadTask& bad : all) {
    std::string yaml = task;
    yaml.replace(yaml.find(bad.what), std::string(bad.what).size(), bad.instead);
    (void)made.write(file, yaml);
    const ProgramResult run =
        made.run({"rehearse", made.path("mission.yaml"), "--out", made.path("bad.nc")});
    EXPECT_EQ(run.exit_code, 3) << bad.instead << "\n" << run.err;
    EXPECT_NE(run.err.find(bad.says), std::string::npos) << bad.instead << "\n-> " << run.err;
    EXPECT_FALSE(std::filesystem::exists(made.path("bad.nc"))) << bad.instead;
  }
}

/// That what a scenario, laid_out.yaml, does is in a checkpoint: taken up it comes out the same.
inline void expect_in_a_checkpoint(StoreForTests& made, const std::string& at) {
  const auto path = [&](const std::string& name) { return made.path(name); };
  ASSERT_EQ(made.run({"simulate", path("laid_out.yaml"), "--out", path("whole.nc"), "--checkpoint",
                      path("half.checkpoint"), "--checkpoint-at", at})
                .exit_code,
            0);
  ASSERT_EQ(made.run({"simulate", path("laid_out.yaml"), "--restore", path("half.checkpoint"),
                      "--threads", "2", "--out", path("restored.nc")})
                .exit_code,
            0);
  EXPECT_EQ(read_bytes(path("restored.nc")), read_bytes(path("whole.nc")));
}

}  // namespace slackwater::tests
