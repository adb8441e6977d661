#include "twin/scenario/write_conduct.h"

namespace slackwater::twin {
namespace {

YamlValue node_value(std::span<const BehaviourNode> nodes, std::size_t at);

std::vector<YamlValue> children_of(std::span<const BehaviourNode> nodes, std::size_t at) {
  std::vector<YamlValue> children;
  for (std::size_t child = at + 1; child < at + nodes[at].size; child += nodes[child].size)
    children.push_back(node_value(nodes, child));
  return children;
}

YamlValue node_value(std::span<const BehaviourNode> nodes, std::size_t at) {
  const BehaviourNode& node = nodes[at];
  YamlValue settings, value;
  std::string usual_name = name_of(node.kind);
  switch (node.kind) {
    case NodeKind::action:
      usual_name = conduct_leaves().actions[node.leaf];
      value.put(name_of(node.kind), usual_name);
      break;
    case NodeKind::condition:
      usual_name = conduct_leaves().conditions[node.leaf];
      value.put(name_of(node.kind), usual_name);
      break;
    case NodeKind::sequence:
    case NodeKind::fallback:
      value.put(name_of(node.kind), children_of(nodes, at));
      if (node.is_reactive) value.put("reactive", true);
      break;
    case NodeKind::parallel:
      settings.put("success_on", node.success_on == SuccessOn::all ? "all" : "one")
          .put("of", children_of(nodes, at));
      break;
    case NodeKind::guard:
      settings.put("while", conduct_leaves().conditions[node.leaf])
          .put("then", node_value(nodes, at + 1));
      break;
    case NodeKind::retry:
      settings.put("times", static_cast<double>(node.times)).put("then", node_value(nodes, at + 1));
      break;
    case NodeKind::timeout:
      settings.put("after_s", node.after_s).put("then", node_value(nodes, at + 1));
      break;
  }
  if (!settings.is_empty()) value.put(name_of(node.kind), settings);
  if (node.name != usual_name) value.put("name", node.name);
  return value;
}

}  // namespace

YamlValue behaviour_value(const BehaviourTree& tree) { return node_value(tree.nodes(), 0); }

}  // namespace slackwater::twin
