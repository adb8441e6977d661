#include "api/door/dds/mismatch.h"

#include <algorithm>

#include "api/door/dds/message/names.h"

namespace slackwater::dds {
namespace {

/// What their writer lacks, or their reader asks for beyond ours; empty: nothing.
std::string unmet_quality(const Endpoint& ours, const Endpoint& theirs) {
  const Endpoint& writer = ours.is_writer ? ours : theirs;
  const Endpoint& reader = ours.is_writer ? theirs : ours;
  if (reader.is_reliable && !writer.is_reliable) {
    return ours.is_writer ? "asks for reliability, written here is best effort: it hears nothing; "
                            "read best effort"
                          : "writes best effort, read here is reliably: nothing of it is heard; "
                            "write reliably";
  }
  if (reader.durability <= writer.durability) return {};
  return ours.is_writer
             ? "asks for what was said before it came (durability), which is not kept here: it "
               "hears nothing; read volatile"
             : "does not keep what it said for who comes late (durability), as is asked for here: "
               "nothing of it is heard; write transient local";
}

}  // namespace

std::optional<std::string> mismatch_of(const Endpoint& ours, const Endpoint& theirs,
                                       const std::string& client, const std::string& elsewhere) {
  if (ours.topic != theirs.topic || ours.is_writer == theirs.is_writer) return std::nullopt;
  const std::string who = ros_topic_of(ours.topic) + ": " + client + " ";
  if (ours.type != theirs.type) {
    const std::string their_type = ros_type_of(theirs.type), our_type = ros_type_of(ours.type);
    std::string words = ours.is_writer ? who + "reads " + their_type + ", written here is " +
                                             our_type + ": it hears nothing; read that type"
                                       : who + "writes " + their_type + ", read here is " +
                                             our_type + ": nothing of it is heard; write that type";
    if (!elsewhere.empty()) words += ", or use " + ros_topic_of(elsewhere) + ", which has yours";
    return words;
  }
  const std::string quality = unmet_quality(ours, theirs);
  return quality.empty() ? std::nullopt : std::optional(who + quality);
}

MismatchWatch::Words MismatchWatch::add_ours(const Endpoint& endpoint) {
  Words words;
  const std::lock_guard lock(mutex_);
  ours_[endpoint.topic].push_back(endpoint);
  if (const auto there = theirs_.find(endpoint.topic); there != theirs_.end())
    for (const Their& their : there->second) look(endpoint, their, words);
  return words;
}

MismatchWatch::Words MismatchWatch::add_theirs(const Gid& id, const std::string& client,
                                               Endpoint endpoint) {
  Words words;
  const std::lock_guard lock(mutex_);
  std::vector<Their>& on_topic = theirs_[endpoint.topic];
  topics_[id] = endpoint.topic;
  const auto known = std::find_if(on_topic.begin(), on_topic.end(),
                                  [&](const Their& their) { return their.id == id; });
  Their& their = known == on_topic.end() ? on_topic.emplace_back() : *known;
  their = {id, client, std::move(endpoint)};
  if (const auto here = ours_.find(their.is.topic); here != ours_.end())
    for (const Endpoint& ours : here->second) look(ours, their, words);
  return words;
}

void MismatchWatch::look(const Endpoint& ours, const Their& their, Words& words) {
  auto found = mismatch_of(ours, their.is, their.client, elsewhere(ours, their.is));
  if (found && said_[their.client].insert(*found).second) words.push_back(std::move(*found));
}

/// A topic of a longer name, by convention: "rt/rov/cmd_vel_stamped".
std::string MismatchWatch::elsewhere(const Endpoint& ours, const Endpoint& theirs) const {
  for (auto at = ours_.lower_bound(ours.topic);
       at != ours_.end() && at->first.starts_with(ours.topic); ++at)
    for (const Endpoint& one : at->second)
      if (one.is_writer == ours.is_writer && one.type == theirs.type && at->first != ours.topic)
        return at->first;
  return {};
}

void MismatchWatch::forget(const Gid& id) {
  const std::lock_guard lock(mutex_);
  const auto topic = topics_.find(id);
  if (topic == topics_.end()) return;
  const auto on_topic = theirs_.find(topic->second);
  std::erase_if(on_topic->second, [&](const Their& their) { return their.id == id; });
  if (on_topic->second.empty()) theirs_.erase(on_topic);
  topics_.erase(topic);
}

void MismatchWatch::forget_client(const std::string& client) {
  const std::lock_guard lock(mutex_);
  said_.erase(client);
  for (auto on_topic = theirs_.begin(); on_topic != theirs_.end();) {
    std::erase_if(on_topic->second, [&](const Their& their) {
      return their.client == client && topics_.erase(their.id) == 1;
    });
    on_topic = on_topic->second.empty() ? theirs_.erase(on_topic) : std::next(on_topic);
  }
}

}  // namespace slackwater::dds
