#include "api/cli/recorded_run.h"

#include "api/live/live_run.h"
#include "api/live/recording_outlet.h"
#include "fields/base/log.h"

namespace slackwater::api {

struct RecordedRun::Parts {
  live::LiveSettings settings;
  std::unique_ptr<live::LiveRun> joined;
};

RecordedRun::RecordedRun(const std::vector<std::filesystem::path>& paths, RunChoice& choice)
    : parts_(std::make_unique<Parts>()) {
  if (paths.empty()) return;
  for (const auto& path : paths) {
    parts_->settings.outlets.push_back(std::make_shared<live::RecordingOutlet>(path, tell_trouble));
  }
  choice.on_ready = [parts = parts_.get()](const RunInHand& hand) {
    parts->settings.site = site_of(hand.scenario, hand.water);
    parts->joined = std::make_unique<live::LiveRun>(hand, parts->settings);
  };
  choice.on_over = [parts = parts_.get()] { parts->joined.reset(); };
}

RecordedRun::~RecordedRun() = default;

std::string site_of(const twin::Scenario& scenario, const ScenarioWater& water) {
  const std::string& id = water.surround.field->snapshot().site_id;
  const bool is_made_up = std::holds_alternative<twin::MadeUpWater>(scenario.water);
  return is_made_up || id.empty() ? "site" : id;
}

void tell_trouble(const std::string& text) {
  log_event(LogLevel::warning, "live", {{"problem", text}});
}

}  // namespace slackwater::api
