#pragma once
#include <array>
#include <string>
#include <vector>

#include "api/door/dds/message/bytes.h"

namespace slackwater::dds {

using Gid = std::array<std::uint8_t, 16>;

/// rmw_dds_common/msg/ParticipantEntitiesInfo of a participant with one node, so that lists of
/// nodes know it.
struct NodeEntities {
  Gid participant{};
  std::string name;  ///< of the node; its namespace is "/"
  std::vector<Gid> readers;
  std::vector<Gid> writers;
};
[[nodiscard]] Bytes participant_entities(const NodeEntities& node);

}  // namespace slackwater::dds
