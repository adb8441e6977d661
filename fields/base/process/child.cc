#include "fields/base/process/child.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>

namespace slackwater {

Child::~Child() {
  if (process_ <= 0) return;
  end();
  wait();
}

std::uint64_t Child::bytes_in_use() const {
  std::ifstream file("/proc/" + std::to_string(process_) + "/statm");
  std::uint64_t all = 0, resident = 0;
  file >> all >> resident;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void Child::end() const noexcept {
  if (process_ > 0) ::kill(process_, SIGKILL);
}

int Child::wait() noexcept {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

int Child::wait_a_while() noexcept {
  int status = 0;
  for (int turn = 0; turn < 1000; ++turn) {
    if (::waitpid(process_, &status, WNOHANG) == process_) {
      process_ = -1;
      return status;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(turn < 100 ? 1 : 10));
  }
  end();
  return wait();
}

}  // namespace slackwater
