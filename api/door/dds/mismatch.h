#pragma once
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "api/door/dds/message/graph.h"

namespace slackwater::dds {

/// A reader or a writer, as discovery tells of it.
struct Endpoint {
  std::string topic;  ///< of DDS: "rt/rov/cmd_vel"
  std::string type;   ///< of DDS: "geometry_msgs::msg::dds_::Twist_"
  bool is_writer = false;
  bool is_reliable = true;
  int durability = 0;  ///< 0 volatile, 1 transient local, above: what no writer of ours has

  bool operator==(const Endpoint&) const = default;
};

/// Why a reader and a writer of one topic do not hear each other, for people: the topic, who, what
/// they have, what is here, what to do. Nothing: they do; or both read, or both write.
/// @param elsewhere  topic of ours that has their type; empty: none
[[nodiscard]] std::optional<std::string> mismatch_of(const Endpoint& ours, const Endpoint& theirs,
                                                     const std::string& client,
                                                     const std::string& elsewhere);

/// Looks at each reader and writer that comes up, on either side, and finds those that do not
/// match: DDS itself says nothing of two types on one topic. Each is said once of a client while it
/// is there; nothing is kept of who left. Members are for any thread.
class MismatchWatch {
 public:
  using Words = std::vector<std::string>;
  [[nodiscard]] Words add_ours(const Endpoint& endpoint);
  [[nodiscard]] Words add_theirs(const Gid& id, const std::string& client, Endpoint endpoint);
  void forget(const Gid& id);
  void forget_client(const std::string& client);

 private:
  struct Their {
    Gid id{};
    std::string client;
    Endpoint is;
  };
  void look(const Endpoint& ours, const Their& their, Words& words);
  [[nodiscard]] std::string elsewhere(const Endpoint& ours, const Endpoint& theirs) const;

  std::mutex mutex_;
  std::map<std::string, std::vector<Endpoint>> ours_;  ///< by topic
  std::map<std::string, std::vector<Their>> theirs_;   ///< by topic
  std::map<Gid, std::string> topics_;                  ///< of theirs
  std::map<std::string, std::set<std::string>> said_;  ///< by client
};

}  // namespace slackwater::dds
