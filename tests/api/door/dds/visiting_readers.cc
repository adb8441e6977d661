// visiting_readers DOMAIN JOINS udp|shared-memory: readers of /test/latched and /test/stream join
// that often, hear something on each and leave: of a node that stays, and the last time with a node
// of their own. Exit 3: one heard nothing within 20 s.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "api/door/dds/participant.h"
#include "std_msgsPubSubTypes.h"
#include "tests/api/door/dds/generated_client.h"

namespace slackwater::tests {
namespace {

fdds::DataReader* reader(GeneratedParticipant& node, const char* topic, bool is_latched) {
  return node.reader(topic, fdds::TypeSupport(new std_msgs::msg::StringPubSubType), nullptr,
                     is_latched);
}

bool visit(GeneratedParticipant& node) {
  fdds::DataReader* const latched = reader(node, "rt/test/latched", true);
  fdds::DataReader* const stream = reader(node, "rt/test/stream", false);
  const bool is_heard =
      comes_true([&] { return latched->get_unread_count() > 0 && stream->get_unread_count() > 0; });
  node.leave(latched);
  node.leave(stream);
  return is_heard;
}

bool visit_as_a_node(int domain, bool is_udp_only) {
  dds::DomainSettings settings;
  settings.domain = domain;
  settings.is_loopback_only = settings.is_udp_only = is_udp_only;
  std::atomic<int> latched = 0, stream = 0;  // before the node: it counts until the node is gone
  dds::Participant node(settings);
  const auto hear = [&](const char* topic, bool is_latched, std::atomic<int>& heard) {
    node.subscribe({topic, "std_msgs/msg/String", "", {true, is_latched, 1}},
                   [&heard](dds::Payload, const std::string&) { ++heard; });
  };
  hear("/test/latched", true, latched);
  hear("/test/stream", false, stream);
  return comes_true([&] { return latched > 0 && stream > 0; });
}

int visit_all(int domain, int joins, bool is_udp_only) {
  GeneratedParticipant node(domain, is_udp_only);
  for (int join = 1; join <= joins; ++join) {
    if (join == joins ? visit_as_a_node(domain, is_udp_only) : visit(node)) continue;
    std::printf("join %d heard nothing\n", join);
    return 3;
  }
  return 0;
}

}  // namespace
}  // namespace slackwater::tests

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  return slackwater::tests::visit_all(std::atoi(argv[1]), std::atoi(argv[2]),
                                      std::string_view(argv[3]) == "udp");
}
