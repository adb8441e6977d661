#include "api/log/state_json.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "fields/base/error.h"
#include "twin/run/command_numbers.h"
#include "twin/run/state_members.h"

namespace slackwater::tests::state_json_test {
namespace {

using namespace api;
using nlohmann::json;

TEST(ExactText, IsTheSameBitsBack) {
  const double least = std::numeric_limits<double>::denorm_min();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Rng rng(1, "state_json_test");
  std::vector<double> all{
      0.0,      -0.0,      0.1, -1e300, least,
      HUGE_VAL, -HUGE_VAL, nan, -nan,   std::bit_cast<double>(std::uint64_t{0x7ff800000000beef})};
  for (int i = 0; i < 1000; ++i) all.push_back(std::bit_cast<double>(rng.bits()));
  for (const double value : all) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(exact_number(exact_text(value))),
              std::bit_cast<std::uint64_t>(value))
        << exact_text(value);
  }
  for (const char* none : {"", "bits:", "one", "0x1p+1 ", "1,5"})
    EXPECT_THROW((void)exact_number(none), Error) << none;
}

/// Gives every leaf of a state another value; counts the bytes that it reaches.
struct Changer {
  std::uint64_t next = 1;

  template <typename T>
  std::size_t change(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      value = !value;
    } else if constexpr (std::is_same_v<T, double>) {
      value = 0.1 * static_cast<double>(++next);
    } else if constexpr (std::is_enum_v<T>) {
      value = static_cast<T>(3);
    } else if constexpr (std::is_integral_v<T>) {
      value = static_cast<T>(++next);
    } else if constexpr (twin::is_numbers<T>) {
      auto* number = reinterpret_cast<double*>(&value);
      for (std::size_t i = 0; i < sizeof(T) / sizeof(double); ++i)
        number[i] = 0.1 * static_cast<double>(++next);
    } else if constexpr (std::is_array_v<T>) {
      for (auto& element : value) (void)change(element);
    } else if constexpr (requires { value.resize(2); }) {
      value.resize(2);
      for (auto& element : value) (void)change(element);
    } else {
      std::size_t bytes = 0, slack = 0;
      twin::for_each_member(value, [&](const char*, auto& member) {
        bytes += change(member);
        slack += 8 - (sizeof member - 1) % 8 - 1;
      });
      // What is not named is padding beside members that are not eight bytes long.
      EXPECT_LE(bytes, sizeof(T)) << typeid(T).name();
      EXPECT_GE(bytes + slack, sizeof(T)) << typeid(T).name() << ": a member is not visited";
    }
    return sizeof(T);
  }
};

TEST(StateJson, EveryMemberIsVisitedAndComesBack) {
  twin::AgentState state;
  const json before = state_json(state);
  Changer changer;
  (void)changer.change(state);
  const json written = state_json(state);
  const twin::AgentState back = state_of(json::parse(written.dump()));
  EXPECT_EQ(state_json(back), written);
  // No leaf was left as it was.
  const json was = before.flatten(), is = written.flatten();
  for (const auto& [name, value] : was.items()) {
    if (is.contains(name)) {
      EXPECT_NE(is.at(name), value) << name;
    }
  }
  EXPECT_EQ(back.mission.route.to().position_m.x, state.mission.route.to().position_m.x);
  twin::AgentState copy = back, original = state;
  EXPECT_EQ(copy.gust_rng.bits(), original.gust_rng.bits());
  EXPECT_EQ(copy.navigation.instruments.dvl.normal(), original.navigation.instruments.dvl.normal());
  EXPECT_EQ(std::memcmp(&copy.vehicle, &original.vehicle, sizeof copy.vehicle), 0);
}

TEST(StateJson, CommandsComeBackInTheirOrder) {
  twin::VehicleState<double> elsewhere;
  elsewhere.body.position_m = {0.1, -0.0, 1e-300};
  const std::vector<twin::Command> commands{
      {7, 1, twin::Reroute{{{{1, 2, 3}, 0.1}, {}}, true}, "dds 01.0f.ab", 3, 0.1},
      {7, 0, twin::PutVehicle{elsewhere}},
      {9, 1, twin::Reroute{}},
      {9, 1, twin::SetVelocity{{0.1, 0.2, 0.3, 0.4}}, "http \"a\"", 1ULL << 52, 8.9},
      {9, 1, twin::SetThrusters{{0.1, -0.3}}},
      {9, 1, twin::HoldHere{true}},
      {9, 1, twin::GoHome{}},
      {9, 1, twin::Resume{}},
      {9, 1, twin::HostPhysics{true}},
      {9, 1, twin::SetActuators{{{0.1, -0.0}, {1, 1}}, true}}};
  const json written = commands_json(commands);
  const std::vector<twin::Command> back = commands_of(json::parse(written.dump()));
  EXPECT_EQ(commands_json(back), written);
  ASSERT_EQ(back.size(), commands.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(back[i].source, commands[i].source);
    EXPECT_EQ(back[i].sequence, commands[i].sequence);
    EXPECT_EQ(back[i].received_s, commands[i].received_s);
    EXPECT_EQ(twin::numbers_of(back[i].what), twin::numbers_of(commands[i].what));
    EXPECT_EQ(back[i].what.index(), commands[i].what.index());
  }
  EXPECT_TRUE(std::get<twin::Reroute>(back[0].what).loop);
  EXPECT_EQ(back[0].step, 7U);
  EXPECT_EQ(std::get<twin::Reroute>(back[0].what).waypoints[0].speed_m_s, 0.1);
  const twin::VehicleState<double>& put = std::get<twin::PutVehicle>(back[1].what).vehicle;
  EXPECT_EQ(std::memcmp(&put, &elsewhere, sizeof put), 0);
  EXPECT_TRUE(std::get<twin::Reroute>(back[2].what).waypoints.empty());
}

TEST(StateJson, RefusalsComeBack) {
  const std::vector<twin::RefusalCount> refusals{
      {"dds 1", "rov", twin::RefusalReason::no_place, 7, 0.1, "waypoint 3: ..."}};
  EXPECT_EQ(refusals_of(json::parse(refusals_json(refusals).dump())), refusals);
  json bad = refusals_json(refusals);
  bad[0]["reason"] = "spite";
  EXPECT_THROW((void)refusals_of(bad), Error);
}

TEST(StateJson, WhatIsNoCommandIsRefused) {
  const json good = commands_json(std::vector<twin::Command>{{1, 0, twin::HoldHere{}}});
  json bad = good;
  bad[0]["kind"] = "sing";
  EXPECT_THROW((void)commands_of(bad), Error);
  bad = good;
  bad[0]["numbers"].push_back(exact_text(1));
  EXPECT_THROW((void)commands_of(bad), Error);
  bad[0]["numbers"] = json::array();
  EXPECT_THROW((void)commands_of(bad), Error);
}

TEST(StateJson, WhatIsNoStateIsRefused) {
  const json good = state_json({});
  json bad = good;
  bad.erase("tether");
  EXPECT_ANY_THROW((void)state_of(bad));
  bad = good;
  bad["vehicle"].erase(0);
  EXPECT_ANY_THROW((void)state_of(bad));
  bad = good;
  bad["halted_at_s"] = 5;
  EXPECT_ANY_THROW((void)state_of(bad));
  EXPECT_ANY_THROW((void)state_of(json::array()));
}

}  // namespace
}  // namespace slackwater::tests::state_json_test
