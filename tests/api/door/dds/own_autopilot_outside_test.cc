// Our own guidance flies a route twice: where it is at home, and in a client that is told of the
// vehicle over DDS and asks for velocities.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

#include "api/door/dds/message/frames.h"
#include "slackwater_msgsPubSubTypes.h"
#include "tests/api/door/dds/cdr_by_hand.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/dds/without_leaks.h"
#include "tests/api/door/live/live_records.h"
#include "tests/strangers/live/service_client.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/control/control_laws.h"
#include "twin/control/guidance.h"

namespace slackwater::tests::own_autopilot_outside_test {
namespace {

using namespace std::chrono_literals;
using twin::Triple;
constexpr double step_s = 0.05, speed_m_s = 0.5;

/// Still water, so that a velocity through it is the one over ground.
std::string scenario(const std::string& tasks, const char* duration) {
  std::string yaml = calm_head(step_s) +
                     "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, "
                     "depth_m: 10, heading_deg: 0}, speed_m_s: 0.5, tasks: " +
                     tasks + "}\n";
  return yaml.replace(yaml.find("30min"), 5, duration);
}
const std::vector<Triple<double>> corners_m{{6, 0, 10}, {6, 6, 10}, {0, 6, 10}, {0, 0, 10}};
std::string route() {
  std::string tasks = "[{do: route, waypoints: [";
  for (const auto& at : corners_m)
    tasks += "{north_m: " + std::to_string(at.x) + ", east_m: " + std::to_string(at.y) +
             ", depth_m: " + std::to_string(at.z) + "}, ";
  return tasks + "]}, {do: hold}]";
}

/// Where it was at each step, NED, s since the first of the record.
std::vector<Triple<double>> way_in(const std::filesystem::path& record) {
  std::vector<Triple<double>> way;
  for (const LiveMessage& message : messages_of(record)) {
    if (message.topic != "/rov/odometry") continue;
    HandReader reader(message.payload);
    (void)reader.get<std::int32_t>();
    (void)reader.count();
    (void)reader.string();
    (void)reader.string();
    const auto enu = reader.reals(3);
    way.push_back(dds::enu_ned({enu[0], enu[1], enu[2]}));
  }
  return way;
}

/// The vehicle's guidance and the law from a place on the path to a velocity, by what is observed.
class PilotOutside {
 public:
  explicit PilotOutside(const twin::Agent& agent)
      : autopilot_(*agent.autopilot), guidance_(agent.mission.guidance) {}
  [[nodiscard]] bool is_done() const { return route_ && route_->is_done(); }
  [[nodiscard]] std::uint64_t begun() const { return begun_; }

  slackwater_msgs::msg::AgentCommand answer(const slackwater_msgs::msg::AgentObservation& seen) {
    const auto& p = seen.pose().position();
    const auto& q = seen.pose().orientation();
    const auto& v = seen.twist().linear();
    const auto& w = seen.twist().angular();
    twin::Measured measured;
    measured.position_m = dds::enu_ned({p.x(), p.y(), p.z()});
    measured.attitude = dds::enu_flu_ned_frd({q.w(), q.x(), q.y(), q.z()});
    measured.nu = {dds::flu_frd({v.x(), v.y(), v.z()}), dds::flu_frd({w.x(), w.y(), w.z()})};
    if (!route_) {
      std::vector<twin::Waypoint> waypoints;
      for (const auto& at : corners_m) waypoints.push_back({at});
      route_.emplace(measured.position_m, waypoints);
      begun_ = seen.step();
    }
    const twin::Reference reference = twin::reference_along(guidance_, *route_, measured);
    twin::Outset outset;
    outset.r = twin::rotation_of(measured.attitude);
    outset.velocity_m_s = outset.r.to_ned(measured.nu.linear);
    const double yaw = std::atan2(outset.r.east.x, outset.r.north.x);
    outset.bow = twin::course_of(yaw);
    const Triple<double> wanted = twin::wanted_velocity(autopilot_, measured, reference, outset);
    const double turn = std::remainder(twin::bearing_rad(reference.heading) - yaw, 2 * M_PI);
    slackwater_msgs::msg::AgentCommand command;
    command.step(seen.step());
    command.kind(1);
    auto& asked = command.velocity();
    asked.linear().x(std::cos(yaw) * wanted.x + std::sin(yaw) * wanted.y);
    asked.linear().y(std::sin(yaw) * wanted.x - std::cos(yaw) * wanted.y);
    asked.linear().z(-wanted.z);
    asked.angular().z(-std::clamp(autopilot_.heading.outer_per_s * turn,
                                  -autopilot_.settings.most_yaw_rate_rad_s,
                                  autopilot_.settings.most_yaw_rate_rad_s));
    return command;
  }

 private:
  const twin::Autopilot& autopilot_;
  twin::Guidance guidance_;
  std::optional<twin::Route> route_;
  std::uint64_t begun_ = 0;
};

/// Flies until it is round. @return whether it came round
bool fly(int domain, PilotOutside& pilot) {
  peer::Node node(domain);
  auto* request = node.writer<slackwater_msgs::msg::HostRequestPubSubType>("rt/rov/host/request");
  auto* command = node.writer<slackwater_msgs::msg::AgentCommandPubSubType>("rt/rov/host/command");
  auto* observed =
      node.reader<slackwater_msgs::msg::AgentObservationPubSubType>("rt/rov/host/observation");
  const auto until = std::chrono::steady_clock::now() + 120s;
  slackwater_msgs::msg::AgentObservation seen;
  peer::fdds::SampleInfo info;
  bool is_taken = false;
  while (std::chrono::steady_clock::now() < until && !pilot.is_done()) {
    if (!is_taken) {
      slackwater_msgs::msg::HostRequest asked;
      asked.token(1);
      asked.version(1);
      asked.role(1);
      asked.timeout_s(2);
      peer::fdds::PublicationMatchedStatus hears;
      command->get_publication_matched_status(hears);
      if (hears.current_count > 0) request->write(&asked);
    }
    observed->wait_for_unread_message({0, 100'000'000});
    while (observed->take_next_sample(&seen, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      is_taken = true;
      auto answer = pilot.answer(seen);
      command->write(&answer);
    }
  }
  return pilot.is_done();
}

TEST(OwnAutopilotOutside, GivesTheTrackOfTheOneAtHomeWithinTheLatencysWorth) {
  const OwnDomain domain;
  const TemporaryFolder folder;
  std::ofstream(folder / "home.yaml") << scenario(route(), "2min");
  std::ofstream(folder / "outside.yaml") << scenario("[{do: hold}]", "20min");
  const ProgramResult home = run_program(
      {"live", folder / "home.yaml", "--real-time-factor", "0", "--record", folder / "home.mcap"});
  ASSERT_EQ(home.exit_code, 0) << home.err;
  StartedProgram run(start_program(
      {"live", folder / "outside.yaml", "--dds-domain", std::to_string(domain.number()),
       "--real-time-factor", "10", "--record", folder / "outside.mcap"},
      without_leaks()));
  const twin::ReadyRun ready = ready_of(scenario("[{do: hold}]", "20min"));
  PilotOutside pilot(ready.agents[0]);
  ASSERT_TRUE(fly(domain.number(), pilot));
  EXPECT_EQ(run.end(SIGINT), 0);

  const auto at_home = way_in(folder / "home.mcap"), outside = way_in(folder / "outside.mcap");
  ASSERT_GT(outside.size(), pilot.begun() + 800);
  double worst_m = 0, worst_depth_m = 0, way_m = 0;
  std::size_t compared = 0;
  for (; compared < at_home.size() && pilot.begun() + compared < outside.size(); ++compared) {
    const Triple<double> off_m = outside[pilot.begun() + compared] - at_home[compared];
    worst_m = std::max(worst_m, std::hypot(off_m.x, off_m.y));
    worst_depth_m = std::max(worst_depth_m, std::abs(off_m.z));
    way_m = std::max(way_m, twin::length_of(at_home[compared] - at_home[0]));
  }
  // Round the square, less the corners that are cut.
  EXPECT_GT(static_cast<double>(compared) * step_s * speed_m_s, 22);
  EXPECT_GT(way_m, 8) << "the far corner";
  // What is seen at the opening of a step is answered in that step, whose barrier then asks for it:
  // latency is one step, and its worth the way of one. A course that is moved on by a rate instead
  // of the bow's direction costs nothing of the way: this craft pushes any way it likes.
  constexpr double latency_m = step_s * speed_m_s;
  EXPECT_LT(worst_m, latency_m) << "after " << compared << " steps";
  // One begins at rest and rises a little until it is trimmed, the other has held its depth; a rate
  // down keeps what it has, a place would be come back to.
  EXPECT_LT(worst_depth_m, 0.05);
  RecordProperty("worst_mm", std::to_string(1000 * worst_m));
  RecordProperty("worst_depth_mm", std::to_string(1000 * worst_depth_m));
}

}  // namespace
}  // namespace slackwater::tests::own_autopilot_outside_test
