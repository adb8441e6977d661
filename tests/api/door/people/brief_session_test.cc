// Stations of a session that are told briefly: the same as the others, in a fraction of the bytes.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/api/door/people/fleet_in_waves.h"
#include "tests/api/door/people/moved_reader.h"
#include "tests/api/door/people/station_for_tests.h"

namespace slackwater::tests::brief_session_test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using people::Role;

const session::Frame& read(const std::string& bytes) {
  return *session::GetFrame(reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

// 15 kB/s are a twentieth of the 300 kB/s that twenty spectators may take together.
TEST(BriefSession, ShowsFiftyVehiclesInWavesIn15KilobytesASecondAsTheyAre) {
  SessionUnderWay run(fleet_in_waves(50, 0.05));
  StationClient brief(run, run.token(Role::looks_on)), plain(run, run.token(Role::looks_on));
  ASSERT_FALSE(brief.hello("brief", true).is_null());
  ASSERT_FALSE(plain.hello("plain").is_null());
  brief.listen(300ms);
  const std::size_t before = brief.wire_bytes;
  const auto began = std::chrono::steady_clock::now();
  for (int i = 0; i < 40; ++i) {
    brief.listen(50ms);
    plain.listen(50ms);
  }
  const double length_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const double kB_s = static_cast<double>(brief.wire_bytes - before) / length_s / 1000;
  EXPECT_LT(kB_s, 15);
  EXPECT_GT(kB_s, 1) << "vehicles move";
  RecordProperty("kB_s", std::to_string(kB_s));

  std::map<std::uint64_t, std::map<std::uint16_t, session::Pose>> as_they_are;
  std::map<std::uint16_t, session::Pose> now;
  for (const std::string& bytes : plain.frames) {
    for (const session::Pose* pose : *read(bytes).poses()) now[pose->vehicle()] = *pose;
    as_they_are[read(bytes).step()] = now;
  }
  MovedReader reader;
  std::size_t compared = 0;
  for (const std::string& bytes : brief.frames) {
    ASSERT_TRUE(reader.take(read(bytes)));
    EXPECT_EQ(reader.vehicles(), 50U);
    const auto then = as_they_are.find(read(bytes).step());
    if (then == as_they_are.end()) continue;
    for (const auto& [vehicle, is] : then->second) {
      const people::Pose& shown = reader.of(vehicle).shown;
      // Half a step, and what is not told again to those who get poses; floats of 1 km.
      EXPECT_NEAR(shown.east_m, is.east_m(), 0.0025 + 0.005 + 1e-4);
      EXPECT_NEAR(shown.north_m, is.north_m(), 0.0025 + 0.005 + 1e-4);
      EXPECT_NEAR(shown.up_m, is.up_m(), 0.0025 + 0.005 + 1e-4);
      EXPECT_NEAR(shown.roll_rad, is.roll_rad(), 0.0002 + 0.002);
      EXPECT_NEAR(shown.pitch_rad, is.pitch_rad(), 0.0002 + 0.002);
      EXPECT_NEAR(std::remainder(shown.heading_rad - is.heading_rad(), 6.283185307), 0, 0.0022);
      ++compared;
    }
  }
  EXPECT_GT(compared, 50U * 10U);

  std::map<std::string, int> told;
  for (const json& message : brief.messages) ++told[message["is"].get<std::string>()];
  EXPECT_GE(told["reserves"], 1);
  EXPECT_GE(told["thrusts"], 2);
  EXPECT_EQ(told["thrust"], 0);
  EXPECT_LE(told["status"], 50) << "at first, and not for a reserve";
  told.clear();
  for (const json& message : plain.messages) ++told[message["is"].get<std::string>()];
  EXPECT_EQ(told["reserves"], 0);
  EXPECT_EQ(told["thrusts"], 0);
  EXPECT_GT(told["thrust"], 50);
  EXPECT_GT(told["status"], 75);
}

TEST(BriefSession, GivesAWholeFrameToWhoLostTrack) {
  SessionUnderWay run(fleet_in_waves(2, 0.05));
  StationClient brief(run, run.token(Role::looks_on));
  (void)brief.hello("brief", true);
  brief.says_saw = false;  // nothing can be read any more
  brief.listen(2s);
  EXPECT_LE(brief.frames.size(), 20U) << "it is not kept up with";
  const std::size_t before = brief.frames.size();
  brief.says({{"do", "saw"}, {"frame", 0}, {"is_lost", true}});
  brief.listen(500ms);
  ASSERT_GT(brief.frames.size(), before + 1);
  EXPECT_TRUE(read(brief.frames[before]).is_whole());
  MovedReader reader;
  for (std::size_t i = before; i < brief.frames.size(); ++i)
    EXPECT_TRUE(reader.take(read(brief.frames[i])));
  EXPECT_EQ(reader.vehicles(), 2U);
}

}  // namespace
}  // namespace slackwater::tests::brief_session_test
