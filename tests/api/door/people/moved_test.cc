// What a brief station is told of vehicles that move: never farther off than it says, however long
// and whatever happens; and small.
#include "api/door/people/wire/moved.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>

#include "api/door/people/wire/frame.h"
#include "tests/api/door/people/moved_reader.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::moved_test {
namespace {

using people::FrameFlow;
using people::FrameHead;
using people::Pose;

const session::Frame& read(const std::string& bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  flatbuffers::Verifier verifier(data, bytes.size());
  EXPECT_TRUE(session::VerifyFrameBuffer(verifier));
  return *session::GetFrame(data);
}

/// A brief station and what is sent to it.
struct Told {
  FrameFlow flow;
  MovedReader reader;
  std::size_t bytes = 0, frames = 0, poses = 0;
  std::string last;
  Told() { flow.be_brief(true); }
  /// @return whether it was told
  bool tell(const std::vector<Pose>& now, double time_s, bool says_saw = true) {
    FrameHead head;
    head.time_s = time_s;
    head.clock_ms = static_cast<std::uint64_t>(std::max(0.0, 1000 * time_s));
    std::string sent = flow.next(now, head);
    if (sent.empty()) return false;
    last = std::move(sent);
    bytes += last.size();
    ++frames;
    const session::Frame& frame = read(last);
    poses += frame.poses()->size();
    EXPECT_TRUE(reader.take(frame));
    if (says_saw) EXPECT_TRUE(flow.saw(frame.number()));
    return true;
  }
};

double apart(double a, double b) { return std::fabs(a - b); }
double apart_turned(double a, double b) {
  return std::fabs(std::remainder(a - b, 2 * std::numbers::pi));
}

/// What a number may be off: half of its step, as exact as a double is.
void expect_close(const Pose& is, const MovedReader& reader) {
  const MovedReader::Known& known = reader.of(is.vehicle);
  const MovedReader::Numbers& n = known.numbers;
  constexpr double exact = 1e-9, angle = 2607.5945876176133;
  EXPECT_LE(apart(n[6] / 200, is.east_m), 0.0025 + exact);
  EXPECT_LE(apart(n[7] / 200, is.north_m), 0.0025 + exact);
  EXPECT_LE(apart(n[8] / 200, is.up_m), 0.0025 + exact);
  EXPECT_LE(apart_turned(n[3] / angle, is.roll_rad), 0.0002);
  EXPECT_LE(apart_turned(n[4] / angle, is.pitch_rad), 0.0002);
  EXPECT_LE(apart_turned(n[5] / angle, is.heading_rad), 0.0002);
  EXPECT_LE(apart(n[0] / 100, is.east_m_s), 0.005 + exact);
  EXPECT_LE(apart(n[1] / 100, is.north_m_s), 0.005 + exact);
  EXPECT_LE(apart(n[2] / 100, is.up_m_s), 0.005 + exact);
  EXPECT_LE(apart(n[9] / 100, is.current_east_m_s), 0.005 + exact);
  EXPECT_LE(apart(n[10] / 100, is.current_north_m_s), 0.005 + exact);
  EXPECT_EQ(std::isnan(known.shown.bed_m), std::isnan(is.bed_m));
  if (!std::isnan(is.bed_m)) EXPECT_LE(apart(n[8] / 200 - n[11] / 20, is.bed_m), 0.0275 + exact);
  EXPECT_EQ(std::isnan(known.shown.charge), std::isnan(is.charge));
  if (!std::isnan(is.charge)) EXPECT_LE(apart(n[12] / 2000, is.charge), 0.00025 + exact);
  EXPECT_EQ(known.shown.is_halted, is.is_halted);
}

void expect_close(const std::vector<Pose>& now, const MovedReader& reader) {
  ASSERT_EQ(reader.vehicles(), now.size());
  for (const Pose& pose : now) expect_close(pose, reader);
}

void expect_same(const Pose& a, const Pose& b) {
  const auto numbers = [](const Pose& p) {
    return std::array{p.east_m,           p.north_m,           p.up_m,      p.roll_rad, p.pitch_rad,
                      p.heading_rad,      p.east_m_s,          p.north_m_s, p.up_m_s,   p.bed_m,
                      p.current_east_m_s, p.current_north_m_s, p.charge};
  };
  for (std::size_t i = 0; i < 13; ++i) {
    const float left = numbers(a)[i], right = numbers(b)[i];
    EXPECT_TRUE(left == right || (std::isnan(left) && std::isnan(right))) << i;
  }
}

/// A fleet in waves: each surges, heaves and rolls on its way.
class Fleet {
 public:
  Fleet(std::size_t vehicles, unsigned seed) : random_(seed) {
    for (std::size_t i = 0; i < vehicles; ++i) join();
  }
  void join() {
    Craft craft;
    craft.speed_m_s = drawn(-2, 2);
    craft.omega_rad_s = drawn(0.7, 2);
    craft.phase_rad = drawn(0, 6);
    craft.north_m = drawn(-3000, 3000);
    craft.turn_rad_s = drawn(-0.3, 0.3);
    craft.has_charge = crafts_.size() % 3 != 0;
    crafts_.push_back(craft);
  }
  [[nodiscard]] std::vector<Pose> at(double t_s) const {
    std::vector<Pose> now;
    for (const Craft& craft : crafts_) {
      const double swing = craft.omega_rad_s * t_s + craft.phase_rad;
      Pose pose;
      pose.vehicle = static_cast<std::uint16_t>(now.size());
      pose.east_m = narrow(craft.speed_m_s * t_s + 0.6 * std::sin(swing));
      pose.east_m_s = narrow(craft.speed_m_s + 0.6 * craft.omega_rad_s * std::cos(swing));
      pose.north_m = narrow(craft.north_m);
      pose.up_m = narrow(0.8 * std::cos(swing) - 5);
      pose.up_m_s = narrow(-0.8 * craft.omega_rad_s * std::sin(swing));
      pose.roll_rad = narrow(0.15 * std::sin(swing + 1));
      pose.pitch_rad = narrow(0.1 * std::sin(swing + 2));
      pose.heading_rad = narrow(std::remainder(craft.turn_rad_s * t_s, 2 * std::numbers::pi));
      pose.current_east_m_s = narrow(0.4 + 0.1 * std::sin(t_s / 600));
      pose.bed_m = narrow(30 + pose.up_m + 0.01 * pose.east_m);
      pose.charge = craft.has_charge ? narrow(1 - t_s / 20'000) : std::nanf("");
      now.push_back(pose);
    }
    return now;
  }
  double drawn(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() - std::mt19937::min()) /
                     (static_cast<double>(std::mt19937::max()) + 1);
  }

 private:
  struct Craft {
    double speed_m_s = 0, omega_rad_s = 0, phase_rad = 0, north_m = 0, turn_rad_s = 0;
    bool has_charge = false;
  };
  static float narrow(double value) { return static_cast<float>(value); }
  std::vector<Craft> crafts_;
  std::mt19937 random_;
};

TEST(Moved, IsWithinHalfAStepOfEachNumberOverAnHour) {
  Fleet fleet(4, 37);
  Told told;
  for (int i = 0; i < 72'000; ++i) {
    const std::vector<Pose> now = fleet.at(0.05 * i);
    ASSERT_TRUE(told.tell(now, 0.05 * i));
    if (i % 97 == 0) expect_close(now, told.reader);
    ASSERT_FALSE(HasFailure()) << "frame " << i;
  }
  EXPECT_EQ(told.poses, 4U) << "of the first frame, and none ever after";
}

// 300 kB/s for twenty stations at 20 Hz is 750 bytes a frame, and others are told beside it.
TEST(Moved, OfFiftyVehiclesInWavesIsASmallFrame) {
  Fleet fleet(50, 5);
  Told told;
  for (int i = 0; i < 400; ++i) ASSERT_TRUE(told.tell(fleet.at(0.05 * i), 0.05 * i));
  const double each = static_cast<double>(told.bytes) / 400;
  EXPECT_LT(each, 80 + 50 * 4) << "four bytes a vehicle";
  RecordProperty("bytes_a_frame", std::to_string(each));
}

// Steps of the clock that are uneven, frames left out, vehicles that come, halt, jump, lose sight
// of the bed, and numbers that are none.
TEST(Moved, IsRightWhateverHappens) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Fleet fleet(1 + seed % 5, seed);
    std::mt19937 random(seed);
    const auto one_in = [&](unsigned n) { return random() % n == 0; };
    Told told;
    std::vector<Pose> last;
    double t_s = fleet.drawn(0, 1e5), jump_m = 0;
    int deaf = 0;
    std::vector<bool> is_halted(64), is_blind(64);
    const float bad[] = {std::numeric_limits<float>::infinity(), std::nanf(""), 3e38F, -1e7F, 4e5F};
    for (int i = 0; i < 600 && !HasFailure(); ++i) {
      t_s += one_in(50)   ? fleet.drawn(0, 30)
             : one_in(80) ? -fleet.drawn(0, 5)
             : one_in(9)  ? 0
                          : fleet.drawn(0.001, 0.12);
      if (one_in(90) && is_halted.size() > told.reader.vehicles() + 1) fleet.join();
      if (one_in(60)) jump_m += fleet.drawn(-3e4, 3e4);
      std::vector<Pose> now = fleet.at(t_s);
      if (one_in(7) && last.size() == now.size()) now = last;  // it rests
      last = now;
      for (Pose& pose : now) {
        if (one_in(200)) is_halted[pose.vehicle] = !is_halted[pose.vehicle];
        if (one_in(200)) is_blind[pose.vehicle] = !is_blind[pose.vehicle];
        pose.is_halted = is_halted[pose.vehicle];
        if (is_blind[pose.vehicle]) pose.bed_m = std::nanf("");
        pose.north_m += static_cast<float>(jump_m);
        if (one_in(100)) pose.heading_rad += static_cast<float>(20 * std::numbers::pi + 0.3);
      }
      if (one_in(40)) {
        float* const any[] = {
            &now[0].east_m, &now[0].up_m,  &now[0].roll_rad,    &now[0].north_m_s,
            &now[0].charge, &now[0].bed_m, &now[0].heading_rad, &now[0].current_east_m_s};
        *any[random() % 8] = bad[random() % 5];
      }
      if (one_in(60)) deaf = 30;
      if (deaf > 0 && --deaf == 0) told.flow.saw(static_cast<std::uint32_t>(told.frames));
      (void)told.tell(now, t_s, deaf == 0);
      if (told.flow.take_left_out() > 0) continue;
      ASSERT_EQ(told.reader.vehicles(), now.size());
      for (const Pose& pose : now)
        if (people::counted(pose).is_countable)
          expect_close(pose, told.reader);
        else
          expect_same(pose, told.reader.of(pose.vehicle).shown);
    }
    EXPECT_GT(told.frames, 300U);
  }
}

TEST(Moved, CountsWhatCanBeCountedAndNothingElse) {
  Pose pose;
  EXPECT_TRUE(people::counted(pose).is_countable);
  pose.bed_m = pose.charge = std::nanf("");
  EXPECT_TRUE(people::counted(pose).is_countable);
  EXPECT_FALSE(people::counted(pose).has_bed);
  pose.east_m = 335'544;  // 2^26 / 200
  EXPECT_TRUE(people::counted(pose).is_countable);
  pose.east_m = 335'545;
  EXPECT_FALSE(people::counted(pose).is_countable);
  pose = {};
  pose.heading_rad = std::nanf("");
  EXPECT_FALSE(people::counted(pose).is_countable);
  EXPECT_EQ(people::wrapped(8192), -8192);
  EXPECT_EQ(people::wrapped(-8193), 8191);
  EXPECT_EQ(people::wrapped(8191 + 3LL * 16384), 8191);
}

TEST(Moved, WhenNothingMovesNothingIsSentButNowAndThen) {
  Fleet fleet(3, 2);
  const std::vector<Pose> now = fleet.at(7);
  Told told;
  int sent = 0;
  for (int i = 0; i < 21; ++i) sent += told.tell(now, 10 + 0.05 * i) ? 1 : 0;
  EXPECT_EQ(sent, 6) << "the first one, then five a second";
  EXPECT_LT(told.last.size(), 100U);
}

// Who misses a frame, or gets it damaged, knows; and has all again with the next one.
TEST(Moved, WhatDoesNotFollowIsNotTakenAndAWholeOneMakesItRight) {
  Fleet fleet(6, 11);
  Told told;
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(told.tell(fleet.at(0.05 * i), 0.05 * i));
  MovedReader late = told.reader;
  FrameHead head;
  head.time_s = 0.5;
  const std::string missed = told.flow.next(fleet.at(0.5), head);
  ASSERT_FALSE(missed.empty());
  head.time_s = 0.55;
  const std::string after = told.flow.next(fleet.at(0.55), head);
  EXPECT_FALSE(late.take(read(after))) << "one is missing";
  for (std::size_t at = 0; at < read(missed).moved()->size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      MovedReader once = told.reader;
      std::string damaged = missed;
      const auto* moved = read(missed).moved()->data();
      const auto place = moved - reinterpret_cast<const std::uint8_t*>(missed.data());
      char& byte = damaged[static_cast<std::size_t>(place) + at];
      byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << bit));
      EXPECT_FALSE(once.take(read(damaged))) << "byte " << at << ", bit " << bit;
    }
  // It says so, though it has seen none of the last ones.
  for (int i = 12; i < 60; ++i) {
    head.time_s = 0.05 * i;
    (void)told.flow.next(fleet.at(head.time_s), head);
  }
  head.time_s = 3;
  EXPECT_TRUE(told.flow.next(fleet.at(3), head).empty()) << "it is not kept up with";
  told.flow.lost();
  const std::string whole = told.flow.next(fleet.at(3), head);
  ASSERT_FALSE(whole.empty());
  EXPECT_TRUE(read(whole).is_whole());
  EXPECT_TRUE(late.take(read(whole)));
  expect_close(fleet.at(3), late);
}

/// Vehicles that swing by sums and products alone, so that no library of sines can change a bit.
std::vector<Pose> swinging(std::size_t frame) {
  std::vector<Pose> now(frame < 20 ? 3 : 4);
  for (std::size_t i = 0; i < now.size(); ++i) {
    double place = 1 + 0.25 * static_cast<double>(i), speed = 0;
    for (std::size_t step = 0; step < 10 * frame; ++step) {
      speed -= 0.005 * (2 + static_cast<double>(i)) * place;
      place += 0.005 * speed;
    }
    Pose& pose = now[i];
    pose.vehicle = static_cast<std::uint16_t>(10 + i);
    const auto narrow = [](double value) { return static_cast<float>(value); };
    pose.east_m = narrow(100 * static_cast<double>(i) + place);
    pose.east_m_s = narrow(speed);
    pose.north_m = narrow(-40 - 0.075 * static_cast<double>(frame));
    pose.north_m_s = -1.5F;
    pose.up_m = narrow(-6 + 0.5 * speed);
    pose.up_m_s = narrow(-0.5 * place);
    pose.roll_rad = narrow(0.1 * place);
    pose.pitch_rad = narrow(-0.05 * speed);
    pose.heading_rad = narrow(std::remainder(3 + 0.0625 * static_cast<double>(frame), 6.28125));
    pose.current_east_m_s = narrow(0.25 + 0.001 * static_cast<double>(frame));
    pose.current_north_m_s = narrow(0.5 * speed);
    pose.bed_m = i == 1 ? std::nanf("") : narrow(20 + pose.up_m);
    pose.charge = i == 2 ? std::nanf("") : narrow(0.9 - 0.001 * static_cast<double>(frame));
    pose.is_halted = i == 0 && frame > 30;
    if (i == 0 && frame > 30) pose.heading_rad = 1;
  }
  return now;
}

/// Frames and what is known after each, as tests/api/web/session/moved_frames_for_tests.ts has it.
std::string frames_for_the_page() {
  std::string text =
      "// Frames of a brief station, byte by byte, and after each what it knows: a vehicle and "
      "its\n"
      "// 13 numbers. Written by tests/api/door/people/moved_test.cc from what the server sends.\n"
      "export const MOVED_FRAMES = `\n";
  Told told;
  for (std::size_t frame = 0; frame < 48; ++frame) {
    const std::size_t late = frame / 7 + (frame > 15 ? 12 : 0);  // of a step, and of many
    const double time_s = 12.5 + 0.05 * static_cast<double>(frame + late);
    std::vector<Pose> now = swinging(frame);
    if (frame == 25) now[2].north_m = std::numeric_limits<float>::infinity();
    if (frame == 34) now[1] = swinging(33)[1];  // it rests, and goes on
    if (frame == 40) told.flow.begin_again();
    EXPECT_TRUE(told.tell(now, time_s));
    text += "frame\n";
    for (std::size_t i = 0; i < told.last.size(); ++i) {
      char hex[3];
      (void)std::snprintf(hex, sizeof hex, "%02x", static_cast<unsigned char>(told.last[i]));
      text += hex;
      if (i % 48 == 47 || i + 1 == told.last.size()) text += '\n';
    }
    for (const std::uint16_t vehicle : told.reader.order()) {
      text += "knows " + std::to_string(vehicle);
      for (const double n : told.reader.of(vehicle).numbers)
        text += " " + std::to_string(static_cast<long>(n));
      text += '\n';
    }
  }
  return text + "`;\n";
}

// The same bytes are read by the page (tests/api/web/session/moved.test.ts). After a change of the
// wire: SLACKWATER_WRITE_FRAMES=1 writes the file anew.
TEST(Moved, IsWhatThePageIsTriedWith) {
  const auto path = source_folder() / "tests/api/web/session/moved_frames_for_tests.ts";
  const std::string is = frames_for_the_page();
  if (std::getenv("SLACKWATER_WRITE_FRAMES") != nullptr) std::ofstream(path) << is;
  std::ifstream file(path);
  const std::string was{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(is == was) << "the server sends other bytes than the page is tried with";
}

}  // namespace
}  // namespace slackwater::tests::moved_test
