#include "api/door/sessions/session_host.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fields/base/error.h"
#include "fields/base/log.h"
#include "fields/base/text.h"
#include "twin/run/printable.h"

namespace slackwater::sessions {
namespace {

using nlohmann::json;

constexpr std::size_t longest_shown = 60;  ///< of what a client wrote

/// "20250310T050002Z": to the second, as part of a name.
std::string moment_in_name(UtcTime time) {
  std::string text = format_utc(std::chrono::floor<std::chrono::seconds>(time));
  std::erase_if(text, [](char c) { return c == '-' || c == ':'; });
  return text;
}

}  // namespace

SessionHost::SessionHost(OperatorFile file, std::filesystem::path store_folder,
                         std::function<UtcTime()> now)
    : file_(std::move(file)), store_folder_(std::move(store_folder)), now_(std::move(now)) {}

void SessionHost::begin_at_start() {
  for (const Offer& offer : file_.offers)
    if (offer.begins_at_start) (void)begin(offer.id, "the server");
}

std::variant<people::Grant, Refused> SessionHost::supervisor_of(std::string_view token) const {
  const auto found = file_.people.find(token);
  if (!found)
    return Refused{401,
                   "found no token of this server's people, expected 'Authorization: Bearer "
                   "TOKEN' of a supervisor"};
  const people::Grant& grant = file_.people.grants()[*found];
  if (grant.until <= now_())
    return Refused{401, "found a token that ended at " + format_utc(grant.until) +
                            "; ask whoever runs this server for a new one"};
  if (grant.role == people::Role::supervises) return grant;
  return Refused{403, "sessions are begun and ended by supervisors, and your role is " +
                          std::string(name_of(grant.role))};
}

std::string SessionHost::next_id(const std::string& offer) {
  const auto is_offered = [&](const std::string& id) {
    return std::any_of(file_.offers.begin(), file_.offers.end(),
                       [&](const Offer& one) { return one.id == id; });
  };
  int& count = begun_[offer];
  std::string id = ++count == 1 ? offer : offer + "-" + std::to_string(count);
  // The second run of "a" is not taken for one of the offer "a-2".
  while (count > 1 && is_offered(id)) id = offer + "-" + std::to_string(++count);
  return id;
}

/// None that is there: a log is never written over.
std::filesystem::path SessionHost::log_of(const std::string& id) const {
  if (file_.logs.empty()) return {};
  const std::string name = id + "-" + moment_in_name(now_());
  std::filesystem::path log = file_.logs / (name + ".nc");
  for (int n = 2; std::filesystem::exists(log); ++n)
    log = file_.logs / (name + "-" + std::to_string(n) + ".nc");
  return log;
}

std::size_t SessionHost::under_way() const {
  return static_cast<std::size_t>(
      std::count_if(runs_.begin(), runs_.end(), [](const Run& run) { return !run->has_ended(); }));
}

/// With the lock held.
void SessionHost::forget_the_oldest() {
  const auto has_ended = [](const Run& run) { return run->has_ended(); };
  while (runs_.size() - under_way() > most_ended)
    runs_.erase(std::find_if(runs_.begin(), runs_.end(), has_ended));
}

std::variant<std::string, Refused> SessionHost::begin(const std::string& offer,
                                                      const std::string& by) {
  const std::lock_guard one_at_a_time(begin_mutex_);
  const auto found = std::find_if(file_.offers.begin(), file_.offers.end(),
                                  [&](const Offer& one) { return one.id == offer; });
  if (found == file_.offers.end()) {
    std::vector<std::string> ids;
    for (const Offer& one : file_.offers) ids.push_back(one.id);
    return Refused{404, "found no session '" + twin::printable(offer, longest_shown) +
                            "' to begin, expected one of " + joined(ids, ", ")};
  }
  {
    const std::lock_guard lock(mutex_);
    if (is_stopping_) return Refused{503, "the server is stopping"};
    if (under_way() >= file_.most_at_once)
      return Refused{409, formatted("found {} sessions under way, which is as many as may be at "
                                    "once; end one of them first",
                                    under_way())};
  }
  const std::string id = next_id(offer);
  const std::filesystem::path log = log_of(id);
  auto run = std::make_shared<HostedRun>(
      HostedRunChoice{id, *found, file_.people, store_folder_, log, by, now_});
  const std::lock_guard lock(mutex_);
  if (is_stopping_) run->stop();
  runs_.push_back(std::move(run));
  forget_the_oldest();
  return id;
}

SessionHost::Run SessionHost::run_of(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> ids;
  for (const Run& run : runs_) {
    if (run->id() == id) return run;
    ids.push_back(run->id());
  }
  throw Error(ErrorKind::not_found,
              "found no session '" + twin::printable(id, longest_shown) + "', expected " +
                  (ids.empty() ? "one that was begun: none was yet" : joined(ids, ", ")));
}

std::shared_ptr<people::Session> SessionHost::find(const std::string& id) const {
  return run_of(id)->session();
}

std::string SessionHost::end(const std::string& id, const std::string& by) {
  const Run run = run_of(id);
  log_event(LogLevel::info, "session is to end", {{"session", id}, {"by", by}});
  run->stop();
  return run->state();
}

void SessionHost::stop() {
  {
    const std::lock_guard lock(mutex_);
    is_stopping_ = true;
    for (const Run& run : runs_) run->stop();
  }
  std::deque<Run> runs;
  {
    // Whoever is about to begin one has it in the list by now, and it is told to stop.
    const std::lock_guard nobody_begins(begin_mutex_);
    const std::lock_guard lock(mutex_);
    runs = runs_;
  }
  for (const Run& run : runs) run->wait();
}

json SessionHost::summary(const std::string& id) const { return run_of(id)->summary(); }

json SessionHost::list() const {
  json sessions = json::array(), offers = json::array();
  const std::lock_guard lock(mutex_);
  for (const Run& run : runs_) sessions.push_back(run->summary());
  for (const Offer& offer : file_.offers)
    offers.push_back({{"id", offer.id}, {"name", offer.name}});
  return {{"sessions", sessions},
          {"may_begin", offers},
          {"under_way", under_way()},
          {"most_at_once", file_.most_at_once}};
}

}  // namespace slackwater::sessions
