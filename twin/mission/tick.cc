#include "twin/mission/tick.h"

#include <span>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

/// One tick of one tree.
class Ticking {
 public:
  Ticking(const BehaviourTree& tree, BehaviourState& state, double now_s, const LeafTable& leaves,
          std::vector<StatusChange>& changes)
      : nodes_(tree.nodes()),
        state_(state.nodes),
        now_s_(now_s),
        leaves_(leaves),
        changes_(changes) {
    expects(state_.size() == nodes_.size(), "the state of another behaviour tree");
    changes_.clear();
  }

  NodeStatus tick(std::size_t i) {
    const NodeStatus answer = answer_of(i);
    expects(answer != NodeStatus::idle, "an action has answered that it is idle");
    set(i, answer);
    return answer;
  }

  /// What runs in [first, end).
  void halt(std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      if (!runs(i)) continue;
      if (nodes_[i].kind == NodeKind::action) leaves_.halt(leaves_.leaves, leaf(i));
      set(i, NodeStatus::idle);
    }
  }

 private:
  [[nodiscard]] bool runs(std::size_t i) const { return state_[i].status == NodeStatus::running; }
  [[nodiscard]] Leaf leaf(std::size_t i) const { return {nodes_[i].leaf, i}; }
  [[nodiscard]] std::size_t end_of(std::size_t i) const { return i + nodes_[i].size; }

  void set(std::size_t i, NodeStatus to) {
    const NodeStatus from = state_[i].status;
    if (from != to) changes_.push_back({i, from, to});
    if (to == NodeStatus::running)
      state_[i].status = to;
    else
      state_[i] = {.status = to};
  }

  NodeStatus answer_of(std::size_t i) {
    switch (nodes_[i].kind) {
      case NodeKind::action:
        return (runs(i) ? leaves_.go_on : leaves_.start)(leaves_.leaves, leaf(i));
      case NodeKind::condition:
        return holds(i) ? NodeStatus::success : NodeStatus::failure;
      case NodeKind::sequence:
        return in_turn(i, NodeStatus::success);
      case NodeKind::fallback:
        return in_turn(i, NodeStatus::failure);
      case NodeKind::parallel:
        return all_at_once(i);
      case NodeKind::guard:
        if (holds(i)) return tick(i + 1);
        halt(i + 1, end_of(i));
        return NodeStatus::failure;
      case NodeKind::retry:
        return retried(i);
      case NodeKind::timeout:
        return timed(i);
    }
    return NodeStatus::idle;
  }

  bool holds(std::size_t i) { return leaves_.holds(leaves_.leaves, leaf(i)); }

  /// A sequence or fallback. @param passing  the answer of a child after which the next is ticked
  NodeStatus in_turn(std::size_t i, NodeStatus passing) {
    const std::size_t end = end_of(i);
    std::size_t child = i + 1;
    if (runs(i) && !nodes_[i].is_reactive) {
      child = state_[i].child;
      expects(child > i && child < end, "the state of another behaviour tree");
    }
    for (; child < end; child = end_of(child)) {
      const NodeStatus answer = tick(child);
      if (answer == passing) continue;
      // With memory nothing runs there.
      halt(end_of(child), end);
      state_[i].child = child;
      return answer;
    }
    return passing;
  }

  NodeStatus all_at_once(std::size_t i) {
    const std::size_t end = end_of(i);
    const bool has_begun = runs(i);
    bool has_failure = false, has_success = false, has_other = false;
    for (std::size_t child = i + 1; child < end; child = end_of(child)) {
      if (has_begun && state_[child].status == NodeStatus::success) continue;
      const NodeStatus answer = tick(child);
      has_failure = has_failure || answer == NodeStatus::failure;
      has_success = has_success || answer == NodeStatus::success;
      has_other = has_other || answer != NodeStatus::success;
    }
    const bool succeeds = nodes_[i].success_on == SuccessOn::one ? has_success : !has_other;
    if (!has_failure && !succeeds) return NodeStatus::running;
    halt(i + 1, end);
    return has_failure ? NodeStatus::failure : NodeStatus::success;
  }

  NodeStatus retried(std::size_t i) {
    const NodeStatus answer = tick(i + 1);
    if (answer != NodeStatus::failure) return answer;
    return ++state_[i].failures < nodes_[i].times ? NodeStatus::running : NodeStatus::failure;
  }

  NodeStatus timed(std::size_t i) {
    if (!runs(i)) state_[i].began_s = now_s_;
    const NodeStatus answer = tick(i + 1);
    if (answer != NodeStatus::running || !(now_s_ > state_[i].began_s + nodes_[i].after_s))
      return answer;
    halt(i + 1, end_of(i));
    return NodeStatus::failure;
  }

  std::span<const BehaviourNode> nodes_;
  std::vector<NodeState>& state_;
  double now_s_;
  const LeafTable& leaves_;
  std::vector<StatusChange>& changes_;
};

}  // namespace

BehaviourState idle_state(const BehaviourTree& tree) {
  return {std::vector<NodeState>(tree.nodes().size())};
}

NodeStatus tick(const BehaviourTree& tree, BehaviourState& state, double now_s,
                const LeafTable& leaves, std::vector<StatusChange>& changes) {
  return Ticking(tree, state, now_s, leaves, changes).tick(0);
}

void halt(const BehaviourTree& tree, BehaviourState& state, const LeafTable& leaves,
          std::vector<StatusChange>& changes) {
  Ticking(tree, state, 0, leaves, changes).halt(0, tree.nodes().size());
}

}  // namespace slackwater::twin
