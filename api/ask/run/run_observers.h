#pragma once
#include <atomic>
#include <functional>

#include "twin/run/run_log.h"
#include "twin/run/sensor_log.h"

namespace slackwater::api {

// What looks on while a scenario runs: called at each barrier of a run, in the order in which they
// are attached. They point to what outlives the run and change nothing of it but when it ends.

/// At each n-th barrier only.
template <typename Observer>
struct EachNth {
  std::uint64_t n = 1;
  Observer observer;
  void operator()(const twin::StepTime& time) const {
    if ((time.step + 1) % n == 0) observer(time);
  }
};
template <typename Observer>
EachNth(std::uint64_t, Observer) -> EachNth<Observer>;

/// Writes a row of the log, and what the instruments show.
struct Recorder {
  twin::Run& run;
  twin::RunLog& log;
  twin::SensorLog& sensed;
  void record(double time_s) const {
    log.append(time_s, run.agents(), run.states());
    sensed.append(time_s, run.agents(), run.states());
  }
  void operator()(const twin::StepTime& time) const { record(time.end_s()); }
};

/// Tells how far the run has come, from 0 to 1.
struct ProgressReporter {
  const std::function<void(double)>& on_progress;
  std::uint64_t steps = 0;  ///< of the whole run
  void operator()(const twin::StepTime& time) const {
    if (on_progress) on_progress(static_cast<double>(time.step + 1) / static_cast<double>(steps));
  }
};

/// Ends the run when somebody asks for it.
struct StopWatcher {
  const std::atomic<bool>* is_stop_asked = nullptr;
  twin::RunControl& control;
  [[nodiscard]] bool is_asked() const { return is_stop_asked != nullptr && *is_stop_asked; }
  void operator()(const twin::StepTime&) const {
    if (is_asked()) control.stop();
  }
};

/// Ends the run when no vehicle goes on.
struct HaltWatcher {
  const twin::Run& run;
  twin::RunControl& control;
  void operator()(const twin::StepTime&) const {
    if (run.all_halted()) control.stop();
  }
};

/// Leaves the run in a file once it has made so many steps, unless it ends there.
struct Checkpointer {
  std::uint64_t due_step = 0;
  const twin::RunControl& control;
  std::function<void()> save;
  void operator()(const twin::StepTime& time) const {
    if (time.step + 1 == due_step && !control.is_stopped()) save();
  }
};

}  // namespace slackwater::api
