#include "api/door/live/spawn_service.h"

#include <algorithm>
#include <exception>

#include "api/door/dds/message/names.h"
#include "api/door/dds/message/services.h"
#include "fields/base/text.h"
#include "twin/run/printable.h"

namespace slackwater::live {
namespace {

/// With what is behind it, within the 256 letters that a topic of DDS may have.
constexpr std::size_t longest_name = 64;

using twin::Refusal;
using twin::RefusalReason;

}  // namespace

const std::set<std::string>& reserved_names() {
  static const std::set<std::string> names{"slackwater", "clock", "ais"};
  return names;
}

SpawnService::SpawnService(dds::Participant& participant, twin::CommandArbiter& arbiter,
                           const twin::NewcomerYard& newcomer_yard, const std::string& site)
    : arbiter_(arbiter), newcomer_yard_(newcomer_yard), taken_(reserved_names()) {
  taken_.insert(lower_case(site));
  participant.serve(
      {"/slackwater/spawn", "slackwater_msgs/srv/Spawn"},
      [this](dds::Payload request, const std::string& client, const dds::Answer& answer) {
        try {
          take(request, client, answer);
        } catch (const std::exception& e) {
          answer(dds::done_reply(false, e.what()));
        }
      });
}

void SpawnService::take(dds::Payload request, const std::string& client,
                        const dds::Answer& answer) {
  const twin::Newcomer newcomer = dds::read_spawn(request);
  const double now_s = arbiter_.time_s();
  if (auto refusal = reserve(newcomer, answer)) {
    (void)arbiter_.refuse(client, newcomer.name, *refusal, now_s);
    return answer(dds::done_reply(false, refusal->text));
  }
  std::optional<Refusal> refusal;
  try {
    refusal = arbiter_.spawn(client, newcomer, newcomer_yard_, now_s);
  } catch (...) {
    forget(newcomer.name);
    throw;
  }
  if (!refusal) return;
  forget(newcomer.name);
  answer(dds::done_reply(false, refusal->text));
}

std::optional<Refusal> SpawnService::reserve(const twin::Newcomer& newcomer,
                                             const dds::Answer& answer) {
  const std::string& name = newcomer.name;
  if (name.empty() || name.size() > longest_name || dds::ros_token(name) != name)
    return Refusal{RefusalReason::bad_name,
                   formatted("name: found '{}', expected a token of ROS, of letters, digits and "
                             "single underscores, at most {} of them",
                             twin::printable(name, longest_name), longest_name)};
  const std::lock_guard lock(mutex_);
  if (!taken_.insert(lower_case(name)).second)
    return Refusal{RefusalReason::bad_name,
                   formatted("name: {} is taken; give the vehicle another one", name)};
  waiting_.push_back({newcomer, answer});
  return std::nullopt;
}

void SpawnService::forget(const std::string& name) {
  const std::lock_guard lock(mutex_);
  taken_.erase(lower_case(name));
  std::erase_if(waiting_, [&](const Waiting& one) { return one.newcomer.name == name; });
}

void SpawnService::open(const std::string& name) {
  const std::lock_guard lock(mutex_);
  taken_.insert(lower_case(name));
  for (Waiting& one : waiting_) one.is_there = one.is_there || one.newcomer.name == name;
}

void SpawnService::speak() {
  std::vector<Waiting> there;
  {
    const std::lock_guard lock(mutex_);
    const auto first = std::stable_partition(waiting_.begin(), waiting_.end(),
                                             [](const Waiting& one) { return !one.is_there; });
    there.assign(std::make_move_iterator(first), std::make_move_iterator(waiting_.end()));
    waiting_.erase(first, waiting_.end());
  }
  for (const Waiting& one : there)
    one.answer(dds::done_reply(
        true,
        formatted(
            "/{}: a {} without a client at the helm; it holds its place until a client commands it",
            one.newcomer.name, one.newcomer.model)));
}

void SpawnService::end_run() {
  const std::lock_guard lock(mutex_);
  for (const Waiting& one : waiting_)
    one.answer(dds::done_reply(false, "the run ended before " + one.newcomer.name + " joined it"));
  waiting_.clear();
}

}  // namespace slackwater::live
