// made_up_vehicle DOMAIN SECONDS: says all that a vehicle "rov" and a site "site" say, ten times a
// second, always the same; writes what clients ask of it, one line of JSON each, and answers
// /slackwater/spawn. Ends early where a client asks it to by the name "end".
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "api/door/dds/message/navigate.h"
#include "api/door/dds/message/orders.h"
#include "api/door/dds/message/services.h"
#include "api/door/dds/participant.h"
#include "tests/api/door/dds/site_for_tests.h"
#include "tests/api/door/dds/vehicle_for_tests.h"

namespace slackwater::tests {
namespace {

const bag::Quality state{true, false, 10}, latched{true, true, 1}, best_effort{false, false, 1};

struct Saying {
  const char* topic;
  const char* type;
  bag::Quality quality;
  dds::Bytes message;
};

std::vector<Saying> sayings() {
  VehicleForTests rov;
  const SiteForTests site;
  const dds::Stamp stamp = rov.stamp;
  twin::Shown& shown = rov.state.navigation.instruments.shown;
  shown.turn_rate_rad_s = {0.5, 0.25, 0.125};
  shown.specific_force_m_s2 = {1, 2, -9.75};
  shown.gnss_position_m = {0, 0, -2};
  shown.depth_m = 10;
  shown.dvl_velocity_m_s = {1, 0.5, -0.25};
  shown.dvl_is_bottom = 1;
  shown.dvl_ahead_m_s = 1.25;
  dds::AisTarget target;
  target.mmsi = 227'000'001;
  target.name = "MARIE";
  target.point = site.point;
  target.speed_m_s = 5.5;
  const double power_w[] = {5e6, 0, 2.5e6};
  dds::GoalId goal{};
  goal.fill(0xA5);
  const dds::GoalState goals[] = {{{goal, stamp}, dds::GoalStatus::executing}};
  return {
      {"/clock", "rosgraph_msgs/msg/Clock", best_effort, dds::clock(stamp)},
      {"/rov/odometry", "nav_msgs/msg/Odometry", state,
       dds::odometry(rov.agent, rov.state, "rov", stamp)},
      {"/rov/pose", "geometry_msgs/msg/PoseStamped", state, dds::pose(rov.state, stamp)},
      {"/rov/battery_state", "sensor_msgs/msg/BatteryState", latched,
       dds::battery_state(rov.agent, rov.state, "rov", stamp)},
      {"/rov/imu", "sensor_msgs/msg/Imu", state, dds::imu(rov.agent, rov.state, "rov", stamp)},
      {"/rov/nav_sat_fix", "sensor_msgs/msg/NavSatFix", state,
       dds::nav_sat_fix(rov.state, site.point, 50, "rov", stamp)},
      {"/rov/fluid_pressure", "sensor_msgs/msg/FluidPressure", state,
       dds::fluid_pressure(rov.state, 1025, "rov", stamp)},
      {"/rov/dvl", "geometry_msgs/msg/TwistWithCovarianceStamped", state,
       dds::dvl(rov.agent, rov.state, "rov", stamp)},
      {"/rov/dvl_water", "geometry_msgs/msg/TwistWithCovarianceStamped", state,
       dds::dvl_water(rov.agent, rov.state, "rov", stamp)},
      {"/rov/active_waypoints", "nav_msgs/msg/Path", latched,
       dds::active_waypoints({{{1, 2, 3}, 0, 0}, {{10, 20, 30}, 0, 0}}, stamp)},
      {"/rov/mission_state", "std_msgs/msg/String", latched,
       dds::text(R"({"task": 1, "says": "on its \"way\""})")},
      {"/rov/reserve", "slackwater_msgs/msg/Reserve", state,
       dds::reserve({1e6, 4e5, 900, "come home by 10:40"}, "rov", stamp)},
      {"/rov/navigate/_action/feedback", "slackwater_msgs/action/Navigate_FeedbackMessage", state,
       dds::feedback(goal, 2, 12.5)},
      {"/rov/navigate/_action/status", "action_msgs/msg/GoalStatusArray", latched,
       dds::goal_status(goals)},
      {"/site/current_profile", "slackwater_msgs/msg/CurrentProfile", latched,
       dds::current_profile(site.water(), site.time, stamp)},
      {"/site/wind", "geometry_msgs/msg/Vector3Stamped", latched,
       dds::wind(site.water(), site.time, stamp)},
      {"/site/wave", "slackwater_msgs/msg/SeaState", latched,
       dds::wave({{1.5, 7, 270}, SampleStatus::ok}, stamp)},
      {"/site/tide_level", "std_msgs/msg/Float64", latched,
       dds::tide_level(site.water(), site.time)},
      {"/site/turbine_power", "std_msgs/msg/Float64MultiArray", latched,
       dds::turbine_power(power_w)},
      {"/ais", "slackwater_msgs/msg/AisTarget", state, dds::ais_target(target, stamp)},
  };
}

/// One line of JSON: what was asked, and by whom.
void write(const char* what, const std::string& client, const std::vector<double>& numbers) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  std::printf("{\"asked\": \"%s\", \"client\": \"%s\", \"numbers\": [", what, client.c_str());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    std::printf("%s%.17g", i > 0 ? ", " : "", numbers[i]);
  std::puts("]}");
  std::fflush(stdout);
}

void hear_orders(dds::Participant& participant) {
  using dds::Payload;
  participant.subscribe(
      {"/rov/cmd_vel", "geometry_msgs/msg/Twist", "", state},
      [](Payload message, const std::string& client) {
        const auto nu = dds::velocity_asked(message);
        write("cmd_vel", client,
              {nu.linear.x, nu.linear.y, nu.linear.z, nu.angular.x, nu.angular.y, nu.angular.z});
      });
  participant.subscribe({"/rov/thrusters", "std_msgs/msg/Float64MultiArray", "", state},
                        [](Payload message, const std::string& client) {
                          write("thrusters", client, dds::thrusters_asked(message));
                        });
  participant.subscribe({"/rov/waypoints", "nav_msgs/msg/Path", "", state},
                        [](Payload message, const std::string& client) {
                          std::vector<double> numbers;
                          for (const auto& place : dds::path_asked(message))
                            numbers.insert(numbers.end(), {place.x, place.y, place.z});
                          write("waypoints", client, numbers);
                        });
}

}  // namespace
}  // namespace slackwater::tests

int main(int argc, char** argv) {
  using namespace slackwater;
  if (argc != 3) {
    std::fprintf(stderr, "made_up_vehicle DOMAIN SECONDS\n");
    return 2;
  }
  dds::DomainSettings settings;
  settings.domain = std::atoi(argv[1]);
  settings.is_loopback_only = true;
  settings.on_trouble = [](const std::string& told) {
    std::fprintf(stderr, "trouble: %s\n", told.c_str());
  };
  dds::Participant participant(settings);
  std::vector<std::pair<dds::Participant::WriterId, dds::Bytes>> said;
  for (const tests::Saying& saying : tests::sayings())
    said.emplace_back(participant.publish_on({saying.topic, saying.type, "", saying.quality}),
                      saying.message);
  tests::hear_orders(participant);
  std::atomic<bool> is_over = false;
  participant.serve({"/slackwater/spawn", "slackwater_msgs/srv/Spawn"},
                    [&](dds::Payload request, const std::string&, const dds::Answer& answer) {
                      const std::string name = dds::read_spawn(request).name;
                      is_over = name == "end";
                      answer(dds::done_reply(true, name));
                    });
  participant.on_lost([](const std::string& client) { tests::write("lost", client, {}); });
  participant.announce();
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(std::atoi(argv[2]));
  while (!is_over && std::chrono::steady_clock::now() < end) {
    for (const auto& [writer, message] : said) participant.send(writer, message);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return 0;
}
