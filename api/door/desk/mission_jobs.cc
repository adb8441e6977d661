#include "api/door/desk/mission_jobs.h"

#include <algorithm>

#include "api/ask/rehearse/fly_mission.h"
#include "api/door/desk/kept_answers.h"
#include "api/door/desk/own_folder.h"
#include "api/show/rehearse/rehearsal_json.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/log.h"
#include "fields/base/whole_file.h"

namespace slackwater::api::desk {
namespace {

using nlohmann::json;

constexpr std::size_t most_waiting = 16;
constexpr std::size_t most_known = 64;

struct NotWanted {};

std::string number_of_question(const MissionAsked& asked, const std::string& mark) {
  std::string all = asked.mission + '\0' + std::to_string(asked.members) + '\0' + mark;
  for (const std::string& start : asked.starts) all += '\0' + start;
  return sha256_of_text(all).substr(0, 16);
}

bool is_open(JobState state) { return state == JobState::waiting || state == JobState::flying; }

std::vector<UtcTime> starts_of(const MissionAsked& asked) {
  std::vector<UtcTime> starts;
  for (const std::string& text : asked.starts) {
    try {
      starts.push_back(parse_utc(text));
    } catch (const Error& problem) {
      throw Error(ErrorKind::usage, "starts: " + problem.message());
    }
  }
  return starts;
}

/// A message without the names of files of ours.
std::string without(const std::filesystem::path& folder, std::string text) {
  const std::string name = (folder / "").string();
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at))
    text.erase(at, name.size());
  return text;
}

}  // namespace

std::string_view name_of(JobState state) noexcept {
  switch (state) {
    case JobState::waiting:
      return "waiting";
    case JobState::flying:
      return "flying";
    case JobState::done:
      return "done";
    case JobState::cancelled:
      return "cancelled";
    case JobState::failed:
      return "failed";
  }
  return "failed";
}

MissionJobs::MissionJobs(std::filesystem::path store_folder, std::filesystem::path data_folder,
                         std::size_t at_once)
    : store_folder_(std::move(store_folder)), data_folder_(std::move(data_folder)) {
  for (std::size_t i = 0; i < std::max<std::size_t>(at_once, 1); ++i)
    threads_.emplace_back([this] { work(); });
}

MissionJobs::~MissionJobs() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
    for (const auto& job : all_) job->is_unwanted = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

std::string MissionJobs::submit(MissionAsked asked) {
  static_cast<void>(starts_of(asked));
  const std::string mark = mark_of(store_folder_, data_folder_);
  std::string id = number_of_question(asked, mark);
  {
    const std::lock_guard lock(mutex_);
    const auto same =
        std::find_if(all_.begin(), all_.end(), [&](const auto& job) { return job->id == id; });
    if (same != all_.end()) {
      const Job& job = **same;
      if (job.state == JobState::done || (is_open(job.state) && !job.is_unwanted)) return id;
      all_.erase(same);  // what failed, or nobody wanted, is tried again
    }
    const auto waiting = std::count_if(
        all_.begin(), all_.end(), [](const auto& job) { return job->state == JobState::waiting; });
    if (static_cast<std::size_t>(waiting) >= most_waiting)
      throw Error(ErrorKind::unavailable,
                  "found " + std::to_string(waiting) +
                      " rehearsals that wait already, expected fewer; try again later, or cancel "
                      "one with POST /missions/ID/cancel");
    auto job = std::make_shared<Job>();
    job->id = id;
    job->asked = std::move(asked);
    all_.push_back(std::move(job));
    forget_old();
  }
  changed_.notify_one();
  return id;
}

void MissionJobs::forget_old() {
  for (auto job = all_.begin(); all_.size() > most_known && job != all_.end();)
    job = is_open((*job)->state) ? job + 1 : all_.erase(job);
}

void MissionJobs::work() {
  while (true) {
    std::shared_ptr<Job> next;
    {
      std::unique_lock lock(mutex_);
      const auto first_waiting = [&] {
        return std::find_if(all_.begin(), all_.end(),
                            [](const auto& job) { return job->state == JobState::waiting; });
      };
      changed_.wait(lock, [&] { return is_over_ || first_waiting() != all_.end(); });
      if (is_over_) return;
      next = *first_waiting();
      next->state = JobState::flying;
    }
    fly(next);
  }
}

void MissionJobs::fly(const std::shared_ptr<Job>& job) {
  JobState state = JobState::failed;
  std::string why;
  std::shared_ptr<const json> result;
  std::filesystem::path folder;
  try {
    const OwnFolder own;
    folder = own.path();
    const std::filesystem::path file = own.path() / "mission.yaml";
    write_text(file, job->asked.mission);
    LoadedMission mission = load_mission(file, store_folder_, {}, {});
    const RehearsalPlan plan =
        rehearsal_plan(mission, starts_of(job->asked), job->asked.members, 1, store_folder_);
    const Rehearsal rehearsal = fly_mission(mission, plan, [&](double share, const Rehearsal&) {
      const std::lock_guard lock(mutex_);
      job->share = share;
      if (job->is_unwanted) throw NotWanted{};
    });
    json out = rehearsal_json(mission, plan, rehearsal, {});
    out["intensity"] = nullptr;
    result = std::make_shared<const json>(std::move(out));
    state = JobState::done;
  } catch (const NotWanted&) {
    state = JobState::cancelled;
  } catch (const Error& problem) {
    why = without(folder, problem.message());
  } catch (const std::exception& bug) {
    why = "the rehearsal failed inside; the log of the server says more";
    log_event(LogLevel::error, "rehearsal failed", {{"id", job->id}, {"problem", bug.what()}});
  }
  const std::lock_guard lock(mutex_);
  job->state = state;
  job->why = why;
  job->result = std::move(result);
}

std::shared_ptr<MissionJobs::Job> MissionJobs::find(const std::string& id) const {
  const auto found =
      std::find_if(all_.begin(), all_.end(), [&](const auto& job) { return job->id == id; });
  if (found == all_.end())
    throw Error(ErrorKind::not_found,
                "found no rehearsal by that id; GET /missions lists those that are known, the "
                "oldest are forgotten");
  return *found;
}

json MissionJobs::told(const Job& job, bool with_result) const {
  json out{{"id", job.id},
           {"state", name_of(job.state)},
           {"share", job.state == JobState::done ? 1.0 : job.share},
           {"why", job.why.empty() ? json(nullptr) : json(job.why)}};
  if (with_result) out["result"] = job.result ? *job.result : json(nullptr);
  return out;
}

json MissionJobs::job(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  return told(*find(id), true);
}

json MissionJobs::jobs() const {
  const std::lock_guard lock(mutex_);
  json list = json::array();
  for (const auto& job : all_) list.push_back(told(*job, false));
  return {{"missions", std::move(list)}};
}

json MissionJobs::cancel(const std::string& id) {
  const std::lock_guard lock(mutex_);
  Job& job = *find(id);
  if (job.state == JobState::waiting) job.state = JobState::cancelled;
  job.is_unwanted = job.is_unwanted || job.state == JobState::flying;
  return told(job, false);
}

}  // namespace slackwater::api::desk
