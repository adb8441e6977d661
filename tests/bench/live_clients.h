#pragma once
#include <string>
#include <vector>

// Clients of a live run as processes of their own: the benchmark starts itself again in one of
// these roles.

namespace slackwater::bench {

/// What this program is where its first argument is "--client"; nothing: it is the benchmark.
///
///   hear DOMAIN VEHICLES    listens to odometry, pose and imu of v0, v1, ...; prints "ready" when
///                           it has met them all and, asked to end by SIGTERM, how many came of
///                           each of the three, from the vehicle of which the fewest came
///   readers DOMAIN COUNT    COUNT readers of a profile; when 1000 messages came to each, prints
///                           the 50th and 99th percentile of their age, s
///   agent DOMAIN            hosts the agent of v0 and asks for nothing
///   push DOMAIN TRIALS      thrusters of v0 to and fro; prints the same of the time until its
///                           odometry shows it, s, of those that it shows within 2 s
///   steer DOMAIN TRIALS     drives v0 by cmd_vel and, when it goes steadily at `steered_m_s`, asks
///                           for `steered_by_m_s` more; prints the same of the time until its
///                           odometry shows `steered_shows_m_s` of that, of those within 1 s
///   lists DOMAIN            lists of 10 000 waypoints for v0, ten a second
///   pace STEP_S             a loop at that pace that does nothing; prints "ready" when it begins
///                           and, asked to end by SIGTERM, how many steps it began late, of how
///                           many, and that in words
/// @return the exit code
int live_client(const std::vector<std::string>& role);

inline constexpr double steered_m_s = 0.3, steered_by_m_s = 0.2;
inline constexpr double steered_shows_m_s = 2e-3;  ///< as of thrusters

/// A process of this program in a role, with what it prints.
class ClientProcess {
 public:
  explicit ClientProcess(const std::vector<std::string>& role);
  ~ClientProcess();  ///< ends it
  ClientProcess(const ClientProcess&) = delete;
  ClientProcess& operator=(const ClientProcess&) = delete;

  /// Waits for a line of its. @throws std::runtime_error where it ends without one
  void wait_for_line();
  /// Asks it to end. @return what it printed, but for lines waited for
  [[nodiscard]] std::string asked_result();
  /// Waits for its end. @return what it printed
  [[nodiscard]] std::string result();
  /// User and system time of all that were waited for, s.
  [[nodiscard]] static double children_cpu_s();
  void end();

 private:
  int process_ = -1;
  int out_ = -1;
};

/// A payload whose first number is the clock of now, so that who reads it knows its age.
[[nodiscard]] double monotonic_s();

}  // namespace slackwater::bench
