#include "api/door/cli/run/recordings.h"

#include <nlohmann/json.hpp>

#include "api/door/cli/run/recorded_run.h"
#include "data/bag/append_file.h"
#include "data/bag/bag.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

/// Of a recording that failed the writer does not know what of its last batch is there.
std::uint64_t readable_messages(const std::filesystem::path& path) {
  std::uint64_t messages = 0;
  try {
    const auto bag = bag::open_bag(path);
    while (bag->next()) ++messages;
  } catch (const Error&) {  // NOLINT(bugprone-empty-catch): up to there it can be read
  }
  return messages;
}

}  // namespace

Recordings::Recordings(std::vector<std::filesystem::path> paths) : paths_(std::move(paths)) {
  for (const auto& path : paths_) {
    std::error_code none;
    if (std::filesystem::exists(std::filesystem::symlink_status(path, none)))
      bag::refuse_existing(path);
  }
}

Recordings::~Recordings() {
  for (std::size_t i = 0; i < open_.size(); ++i) {
    (void)open_[i]->close();
    std::error_code none;
    if (!has_stepped_) std::filesystem::remove_all(paths_[i], none);
  }
}

std::vector<std::shared_ptr<live::Outlet>> Recordings::open(twin::Run& run) {
  if (empty()) return {};
  for (const auto& path : paths_)
    open_.push_back(std::make_shared<live::RecordingOutlet>(path, tell_trouble));
  run.at_barrier([this](const twin::StepTime&) { has_stepped_ = true; });
  return {open_.begin(), open_.end()};
}

void Recordings::close() {
  for (std::size_t i = 0; i < open_.size(); ++i) {
    const std::uint64_t messages = open_[i]->close();
    const bool is_complete = !open_[i]->has_failed();
    closed_.push_back(
        {paths_[i], is_complete ? messages : readable_messages(paths_[i]), is_complete});
  }
  open_.clear();
}

nlohmann::json Recordings::json() const {
  nlohmann::json all = nlohmann::json::array();
  for (const Closed& one : closed_) {
    all.push_back(
        {{"path", one.path.string()}, {"messages", one.messages}, {"complete", one.is_complete}});
  }
  return all;
}

void Recordings::expect_complete() const {
  std::string broken;
  for (const Closed& one : closed_) {
    if (one.is_complete) continue;
    broken += (broken.empty() ? "" : ", ") + one.path.string() + " (" +
              std::to_string(one.messages) + " messages)";
  }
  if (broken.empty()) return;
  throw Error(ErrorKind::unavailable,
              "the run is complete, but its recording is not: found " + broken +
                  "; free space on the disk; if the run has a log, record it again from that: "
                  "slackwater replay LOG --record FILE");
}

}  // namespace slackwater::api
