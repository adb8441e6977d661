#include "api/door/dds/message/graph.h"

#include <algorithm>

#include "api/door/dds/message/cdr.h"
#include "rmw_dds_common.h"

namespace slackwater::dds {
namespace {

rmw_dds_common::msg::Gid gid_message(const Gid& gid) {
  rmw_dds_common::msg::Gid message;
  std::copy(gid.begin(), gid.end(), message.data().begin());
  return message;
}

}  // namespace

Bytes participant_entities(const NodeEntities& node) {
  rmw_dds_common::msg::NodeEntitiesInfo info;
  info.node_namespace("/");
  info.node_name(node.name);
  for (const Gid& gid : node.readers) info.reader_gid_seq().push_back(gid_message(gid));
  for (const Gid& gid : node.writers) info.writer_gid_seq().push_back(gid_message(gid));
  rmw_dds_common::msg::ParticipantEntitiesInfo message;
  message.gid(gid_message(node.participant));
  message.node_entities_info_seq({info});
  return encoded(message);
}

}  // namespace slackwater::dds
