#include "api/door/cli/run/recorded_run.h"

#include "api/door/live/live_run.h"
#include "fields/base/log.h"

namespace slackwater::api {

struct RecordedRun::Parts {
  explicit Parts(const std::vector<std::filesystem::path>& paths) : recordings(paths) {}
  Recordings recordings;
  live::LiveSettings settings;
  std::unique_ptr<live::LiveRun> joined;
  live::RecordTold told;
};

RecordedRun::RecordedRun(const std::vector<std::filesystem::path>& paths, RunChoice& choice)
    : parts_(std::make_unique<Parts>(paths)) {
  if (paths.empty()) return;
  choice.on_ready = [parts = parts_.get()](const RunInHand& hand) {
    parts->settings.outlets = parts->recordings.open(hand.run);
    parts->settings.site = site_of(hand.scenario, hand.water);
    parts->joined = std::make_unique<live::LiveRun>(hand, parts->settings);
  };
  choice.on_over = [parts = parts_.get()] {
    if (parts->joined) parts->told = parts->joined->record_told();
    parts->joined.reset();
  };
}

RecordedRun::~RecordedRun() = default;

const Recordings& RecordedRun::completed() {
  parts_->recordings.close();
  return parts_->recordings;
}

const live::RecordTold& RecordedRun::told() const noexcept { return parts_->told; }

std::string site_of(const twin::Scenario& scenario, const ScenarioWater& water) {
  const std::string& id = water.surround.field->snapshot().site_id;
  const bool is_made_up = std::holds_alternative<twin::MadeUpWater>(scenario.water);
  return is_made_up || id.empty() ? "site" : id;
}

void tell_trouble(const std::string& text) {
  log_event(LogLevel::warning, "live", {{"problem", text}});
}

}  // namespace slackwater::api
