#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "api/ask/run/scenario_run.h"
#include "ingest/cf/trajectory_file.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests {

/// Runs of one scenario, each with its log in a folder, and those made again by it.
class LoggedRuns : public ::testing::Test {
 protected:
  struct Made {
    api::ScenarioResult result;
    std::filesystem::path log;
  };

  explicit LoggedRuns(const std::string& yaml)
      : scenario_(twin::parse_scenario(yaml, "scenario.yaml")) {}

  Made make(const std::string& name, const api::RunChoice& choice) {
    Made made;
    made.result = api::run_scenario(scenario_, water_, choice);
    made.log = folder_.path() / name;
    ingest::write_trajectories(made.result.file, made.log);
    return made;
  }
  api::ReplayResult replayed(const std::filesystem::path& log, std::size_t threads = 1,
                             bool is_batch = true) {
    api::RunChoice choice;
    choice.threads = threads;
    choice.is_batch = is_batch;
    return api::replay(log, folder_.path() / "store", {}, choice);
  }

  TemporaryFolder folder_;
  twin::Scenario scenario_;
  api::ScenarioWater water_ = api::water_of(scenario_, folder_.path() / "store", folder_.path());
};

}  // namespace slackwater::tests
