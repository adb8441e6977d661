// idle_participant DOMAIN: joins a domain with shared memory, says "ready" and waits to be killed.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "api/door/dds/participant.h"

int main(int argc, char** argv) {
  using namespace slackwater;
  if (argc != 2) return 2;
  dds::DomainSettings settings;
  settings.domain = std::atoi(argv[1]);
  settings.is_loopback_only = true;
  dds::Participant participant(settings);
  participant.subscribe({"/test", "std_msgs/msg/String", "", {true, true, 1}},
                        [](dds::Payload, const std::string&) {});
  std::puts("ready");
  std::fflush(stdout);
  for (;;) ::pause();
}
