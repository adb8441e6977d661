#include "api/door/sessions/hosted_run.h"

#include <nlohmann/json.hpp>

#include "fields/base/error.h"
#include "fields/base/log.h"
#include "fields/base/whole_file.h"

namespace slackwater::sessions {
namespace {

people::SessionSettings session_settings(const HostedRunChoice& choice) {
  people::SessionSettings settings;
  settings.id = choice.id;
  settings.name = choice.offer.name;
  settings.now = choice.now;
  return settings;
}

}  // namespace

HostedRun::HostedRun(HostedRunChoice choice)
    : choice_(std::move(choice)),
      begun_(choice_.now()),
      control_(choice_.offer.real_time_factor),
      kept_(session_settings(choice_), choice_.book, choice_.store_folder, choice_.id,
            [this](const std::string& trouble) { tell(trouble); }),
      thread_([this] { run(); }) {}

HostedRun::~HostedRun() { stop(); }

void HostedRun::tell(const std::string& trouble) const {
  log_event(LogLevel::warning, "session", {{"session", choice_.id}, {"problem", trouble}});
}

void HostedRun::run_to_its_log() {
  const api::ScenarioAtHand read = at_hand(choice_.offer, choice_.store_folder);
  api::RunChoice choice;
  choice.control = &control_;
  choice.on_ready = [&](const api::RunInHand& hand) {
    kept_.begin(hand);
    for (const std::string& warning : hand.water.warnings) tell(warning);
  };
  choice.on_over = [&] { kept_.session()->end(); };
  choice.actions = [&] { return kept_.actions(); };
  const api::ScenarioResult result = api::run_scenario(read.scenario, read.water, choice);
  if (choice_.log.empty()) return;
  with_context("its log", [&] {
    write_beside(choice_.log, [&](const std::filesystem::path& partial) {
      ingest::write_trajectories(result.file, partial);
    });
  });
}

void HostedRun::run() noexcept {
  End how = End::over;
  std::string why;
  log_event(LogLevel::info, "session begun",
            {{"session", choice_.id}, {"by", choice_.by}, {"log", choice_.log.string()}});
  try {
    run_to_its_log();
  } catch (const std::exception& problem) {
    how = End::failed;
    why = problem.what();
  } catch (...) {
    how = End::failed;
    why = "an exception that is no std::exception";
  }
  ended(how, why);
}

void HostedRun::ended(End how, const std::string& why) {
  kept_.end();
  if (how == End::failed)
    log_event(LogLevel::error, "session failed", {{"session", choice_.id}, {"problem", why}});
  else
    log_event(LogLevel::info, "session over",
              {{"session", choice_.id}, {"log", choice_.log.string()}});
  const std::lock_guard lock(mutex_);
  end_ = how;
  why_ = why;
  has_ended_.notify_all();
}

bool HostedRun::has_ended() const {
  const std::lock_guard lock(mutex_);
  return end_ != End::not_yet;
}

void HostedRun::wait() const {
  std::unique_lock lock(mutex_);
  has_ended_.wait(lock, [this] { return end_ != End::not_yet; });
}

std::string HostedRun::state() const { return summary()["state"]; }

nlohmann::json HostedRun::summary() const {
  nlohmann::json summary = kept_.session()->summary();
  summary["of"] = choice_.offer.id;
  summary["begun"] = format_utc(begun_);
  const std::lock_guard lock(mutex_);
  if (end_ == End::failed) {
    summary["state"] = "failed";
    summary["why"] = why_;
  } else if (end_ == End::not_yet && (summary["state"] == "over" || control_.is_stopped())) {
    summary["state"] = "ending";
  } else if (end_ == End::over) {
    summary["state"] = "over";
  }
  return summary;
}

}  // namespace slackwater::sessions
