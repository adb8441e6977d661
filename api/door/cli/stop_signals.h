#pragma once
#include <csignal>

namespace slackwater::api {

/// Blocks SIGINT and SIGTERM for this and all later threads, so that one place waits for them.
class StopSignals {
 public:
  StopSignals() {
    // Whoever reads our log may go; writing to nobody must not end the server.
    std::signal(SIGPIPE, SIG_IGN);
    sigemptyset(&set_);
    sigaddset(&set_, SIGINT);
    sigaddset(&set_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &set_, nullptr);
  }
  void wait() const {
    int signal = 0;
    sigwait(&set_, &signal);
  }

 private:
  sigset_t set_{};
};

}  // namespace slackwater::api
