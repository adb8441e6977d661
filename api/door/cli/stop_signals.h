#pragma once
#include <csignal>

namespace slackwater::api {

/// Blocks SIGINT and SIGTERM for this and all later threads, so that one place waits for them. A
/// thread that a library began before (OpenBLAS does) does not block them: it hands them on.
class StopSignals {
 public:
  StopSignals() {
    // Whoever reads our log may go; writing to nobody must not end the server.
    std::signal(SIGPIPE, SIG_IGN);
    sigemptyset(&set_);
    sigaddset(&set_, SIGINT);
    sigaddset(&set_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &set_, nullptr);
    waiting_ = pthread_self();
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, hand_on);
  }
  void wait() const {
    int signal = 0;
    sigwait(&set_, &signal);
  }

 private:
  static void hand_on(int signal) { pthread_kill(waiting_, signal); }

  static inline pthread_t waiting_{};
  sigset_t set_{};
};

}  // namespace slackwater::api
