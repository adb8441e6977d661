// renewing_helm DOMAIN: drives /rov ahead through shared memory, a velocity twenty times a second
// until it is told SIGTERM, and stays in the domain until it is told again.
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "api/door/dds/message/orders.h"
#include "api/door/dds/participant.h"

int main(int argc, char** argv) {
  using namespace slackwater;
  if (argc != 2) return 2;
  sigset_t told;
  sigemptyset(&told);
  sigaddset(&told, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &told, nullptr);  // also of the threads to come
  dds::DomainSettings settings;
  settings.domain = std::atoi(argv[1]);
  settings.is_loopback_only = true;
  dds::Participant participant(settings);
  const auto velocity =
      participant.publish_on({"/rov/cmd_vel", "geometry_msgs/msg/Twist", "", {true, false, 1}});
  std::atomic<bool> drives = true;
  std::thread helm([&] {
    twin::Spatial<double> ahead;
    ahead.linear.x = 0.2;
    const dds::Bytes message = dds::velocity_order(ahead);
    for (; drives; std::this_thread::sleep_for(std::chrono::milliseconds(50)))
      participant.send(velocity, message);
  });
  int signal = 0;
  sigwait(&told, &signal);
  drives = false;
  helm.join();
  sigwait(&told, &signal);
  return 0;
}
