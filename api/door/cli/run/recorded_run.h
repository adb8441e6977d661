#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "api/ask/run/scenario_run.h"
#include "api/door/cli/run/recordings.h"
#include "api/door/live/record_teller.h"

namespace slackwater::api {

/// Records what a run tells, as `slackwater live` does, of a run that nobody takes part in.
class RecordedRun {
 public:
  /// Joins the run of a choice. @param paths  of bags; none: does nothing
  /// @throws Error(invalid_input) where something lies at one of them
  RecordedRun(const std::vector<std::filesystem::path>& paths, RunChoice& choice);
  ~RecordedRun();
  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  /// Of the run, once it is over and they are completed.
  [[nodiscard]] const Recordings& completed();
  /// What of the commands and refusals of a log is in them.
  [[nodiscard]] const live::RecordTold& told() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The site whose name topics have: that of the forecast, "site" of water that is made up.
[[nodiscard]] std::string site_of(const twin::Scenario& scenario, const ScenarioWater& water);

/// Says what went wrong beside a run that goes on.
void tell_trouble(const std::string& text);

}  // namespace slackwater::api
