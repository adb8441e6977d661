#pragma once
#include <functional>

#include "api/door/dds/message/hosted.h"
#include "api/door/dds/message/navigate.h"
#include "api/door/dds/message/orders.h"
#include "api/door/dds/message/services.h"
#include "tests/api/door/dds/cdr_by_hand.h"

namespace slackwater::tests {

/// All that reads what a client sent, each with a message that it takes.
struct ReaderCase {
  std::string name;
  std::function<void(dds::Payload)> read;
  std::function<void(HandWriter&)> write;
  bool is_service = true;

  [[nodiscard]] dds::Bytes message(Order order = Order::little) const {
    HandWriter writer(order);
    write(writer);
    return writer.bytes();
  }
};

[[nodiscard]] inline std::vector<ReaderCase> reader_cases() {
  using dds::Payload;
  const auto path = [](HandWriter& writer) {
    writer.header(10, 20, "map").put(3U);
    for (const double north : {1, 2, 3})
      writer.header(10, 20, "map").doubles({0, north, -3}).doubles({0, 0, 0, 1});
  };
  const auto id = [](HandWriter& writer) {
    for (std::uint8_t i = 0; i < 16; ++i) writer.put(static_cast<std::uint8_t>(0xA0 + i));
  };
  return {
      {"cmd_vel", [](Payload p) { (void)dds::velocity_asked(p); },
       [](HandWriter& w) {
         w.doubles({1, 0, 0, 0, 0, 0.25});
       },
       false},
      {"cmd_vel_stamped", [](Payload p) { (void)dds::stamped_velocity_asked(p); },
       [](HandWriter& w) {
         w.header(10, 20, "base_link").doubles({1, 0, 0, 0, 0, 0.25});
       },
       false},
      {"thrusters", [](Payload p) { (void)dds::thrusters_asked(p); },
       [](HandWriter& w) {
         w.put(1U).string("thruster").put(4U).put(4U).put(0U).put(4U).doubles({1, -1, 0.5, 0});
       },
       false},
      {"actuators", [](Payload p) { (void)dds::actuators_asked(p); },
       [](HandWriter& w) {
         w.put(2U).string("starboard").string("rudder").put(2U).doubles({0.5, -0.25});
         w.put(std::uint8_t{1});
       },
       false},
      {"waypoints", [](Payload p) { (void)dds::path_asked(p); }, path, false},
      {"trigger", [](Payload p) { dds::read_trigger(p); },
       [](HandWriter& w) { w.put(std::uint8_t{0}); }},
      {"set_bool", [](Payload p) { (void)dds::read_set_bool(p); },
       [](HandWriter& w) { w.put(std::uint8_t{1}); }},
      {"step", [](Payload p) { (void)dds::read_step(p); }, [](HandWriter& w) { w.put(100U); }},
      {"spawn", [](Payload p) { (void)dds::read_spawn(p); },
       [](HandWriter& w) {
         w.string("bluerov2_heavy").string("second").header(10, 20, "map");
         w.doubles({1, 2, -3}).doubles({0, 0, 0, 1});
       }},
      {"set_waypoints", [](Payload p) { (void)dds::read_set_waypoints(p); },
       [path](HandWriter& w) {
         path(w);
         w.put(std::uint8_t{1});
       }},
      {"query_profile", [](Payload p) { (void)dds::read_query_profile(p); },
       [](HandWriter& w) {
         w.doubles({48.5, -2.5}).put(std::int32_t{1'748'844'000}).put(0U);
       }},
      {"send_goal", [](Payload p) { (void)dds::read_send_goal(p); },
       [path, id](HandWriter& w) {
         id(w);
         path(w);
       }},
      {"cancel_goal", [](Payload p) { (void)dds::read_cancel_goal(p); },
       [id](HandWriter& w) {
         id(w);
         w.put(std::int32_t{7}).put(8U);
       }},
      {"get_result", [](Payload p) { (void)dds::read_get_result(p); }, id},
      {"host_request", [](Payload p) { (void)dds::read_host_request(p); },
       [](HandWriter& w) { w.put(std::uint64_t{7}).put(1U).put(std::uint8_t{2}).put(0.25); },
       false},
      {"agent_command", [](Payload p) { (void)dds::read_agent_command(p); },
       [path](HandWriter& w) {
         w.put(std::uint64_t{9}).put(std::uint8_t{2}).doubles({1, 2, 3, 4, 5, 6});
         w.put(2U).doubles({0.5, -1});
         path(w);
       },
       false},
      {"physics_output", [](Payload p) { (void)dds::read_physics_output(p); },
       [](HandWriter& w) {
         w.put(std::uint64_t{9}).put(std::uint8_t{1}).doubles({1, 2, -3}).doubles({0, 0, 0, 1});
         w.doubles({1, 2, 3, 4, 5, 6}).doubles({7, 8, 9, 10, 11, 12}).put(100.0);
       },
       false},
  };
}

}  // namespace slackwater::tests
