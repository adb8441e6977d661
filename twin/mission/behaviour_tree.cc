#include "twin/mission/behaviour_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

BehaviourNode node_of(NodeKind kind) {
  BehaviourNode node;
  node.kind = kind;
  node.name = name_of(kind);
  return node;
}

BehaviourNode leaf_of(NodeKind kind, std::size_t leaf, std::string name) {
  BehaviourNode node;
  node.kind = kind;
  node.name = std::move(name);
  node.leaf = leaf;
  return node;
}

BehaviourNode reactive(NodeKind kind) {
  BehaviourNode node = node_of(kind);
  node.is_reactive = true;
  return node;
}

}  // namespace

BehaviourTree::BehaviourTree(BehaviourNode root, std::span<const BehaviourTree> children) {
  const bool is_leaf = root.kind == NodeKind::action || root.kind == NodeKind::condition;
  expects(is_leaf || !children.empty(), "a node of a behaviour tree without children");
  for (const BehaviourTree& child : children) {
    root.size += child.nodes_.size();
    depth_ = std::max(depth_, child.depth_ + 1);
  }
  expects(depth_ <= deepest, "a behaviour tree is too deep");
  expects(root.size <= most_nodes, "a behaviour tree has too many nodes");
  nodes_.reserve(root.size);
  nodes_.push_back(std::move(root));
  for (const BehaviourTree& child : children)
    nodes_.insert(nodes_.end(), child.nodes_.begin(), child.nodes_.end());
}

BehaviourTree BehaviourTree::action(std::size_t action, std::string name) {
  return {leaf_of(NodeKind::action, action, std::move(name)), {}};
}

BehaviourTree BehaviourTree::condition(std::size_t condition, std::string name) {
  return {leaf_of(NodeKind::condition, condition, std::move(name)), {}};
}

BehaviourTree BehaviourTree::sequence(std::span<const BehaviourTree> children) {
  return {node_of(NodeKind::sequence), children};
}

BehaviourTree BehaviourTree::fallback(std::span<const BehaviourTree> children) {
  return {node_of(NodeKind::fallback), children};
}

BehaviourTree BehaviourTree::reactive_sequence(std::span<const BehaviourTree> children) {
  return {reactive(NodeKind::sequence), children};
}

BehaviourTree BehaviourTree::reactive_fallback(std::span<const BehaviourTree> children) {
  return {reactive(NodeKind::fallback), children};
}

BehaviourTree BehaviourTree::parallel(SuccessOn success_on,
                                      std::span<const BehaviourTree> children) {
  BehaviourNode node = node_of(NodeKind::parallel);
  node.success_on = success_on;
  return {std::move(node), children};
}

BehaviourTree BehaviourTree::guard(std::size_t condition, const BehaviourTree& child) {
  BehaviourNode node = node_of(NodeKind::guard);
  node.leaf = condition;
  return {std::move(node), {&child, 1}};
}

BehaviourTree BehaviourTree::retry(std::size_t times, const BehaviourTree& child) {
  expects(times > 0, "a retry of no times");
  BehaviourNode node = node_of(NodeKind::retry);
  node.times = times;
  return {std::move(node), {&child, 1}};
}

BehaviourTree BehaviourTree::timeout(double after_s, const BehaviourTree& child) {
  expects(std::isfinite(after_s) && after_s > 0, "a timeout after no time");
  BehaviourNode node = node_of(NodeKind::timeout);
  node.after_s = after_s;
  return {std::move(node), {&child, 1}};
}

BehaviourTree BehaviourTree::named(std::string name) const {
  BehaviourTree copy = *this;
  copy.nodes_.front().name = std::move(name);
  return copy;
}

const char* name_of(NodeKind kind) noexcept {
  switch (kind) {
    case NodeKind::sequence:
      return "sequence";
    case NodeKind::fallback:
      return "fallback";
    case NodeKind::parallel:
      return "parallel";
    case NodeKind::guard:
      return "guard";
    case NodeKind::retry:
      return "retry";
    case NodeKind::timeout:
      return "timeout";
    case NodeKind::action:
      return "do";
    case NodeKind::condition:
      return "when";
  }
  return "";
}

}  // namespace slackwater::twin
