#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace slackwater::twin {

/// What a node of a behaviour tree is; `tick` says what each does.
enum class NodeKind { sequence, fallback, parallel, guard, retry, timeout, action, condition };

/// Which children of a parallel node have to succeed for it to succeed.
enum class SuccessOn { all, one };

/// One node of a tree, and how many nodes stand below it.
struct BehaviourNode {
  NodeKind kind = NodeKind::action;
  std::string name;          ///< for logs; others may have the same
  std::size_t size = 1;      ///< nodes of the subtree: this one and all below it
  bool is_reactive = false;  ///< of a sequence or fallback: begins at its first child each tick
  SuccessOn success_on = SuccessOn::all;  ///< of a parallel node
  std::size_t leaf =
      0;  ///< which action or condition, by the caller's numbers; a guard's condition
  std::size_t times = 0;  ///< of a retry
  double after_s = 0;     ///< of a timeout

  [[nodiscard]] bool operator==(const BehaviourNode&) const = default;
};

/// What a vehicle is to do and when, as a tree of tasks and conditions: its shape, which does not
/// change. How far a run has come in it is a `BehaviourState`, and `tick` moves that on.
///
/// The nodes stand in preorder: the first child of node i is i + 1, and the one after a child c is
/// c + nodes[c].size, as long as that lies before i + nodes[i].size. Whatever stands below a node
/// is one range, first to last, left to right.
///
///     0 sequence (5)  1 action  2 guard (2)  3 action  4 condition
///
/// A value: trees are made of trees, and each is sound by itself. Those that make one throw
/// ContractViolation without children, for `times` or `after_s` that are not above 0, deeper than
/// `deepest` or larger than `most_nodes`.
/// Source: Colledanchise & Ogren (2018), Behavior Trees in Robotics and AI, ch. 1.3.
class BehaviourTree {
 public:
  static constexpr std::size_t deepest = 20;  ///< levels, the root and the leaves among them
  static constexpr std::size_t most_nodes = 1000;

  [[nodiscard]] static BehaviourTree action(std::size_t action, std::string name = "do");
  [[nodiscard]] static BehaviourTree condition(std::size_t condition, std::string name = "when");
  [[nodiscard]] static BehaviourTree sequence(std::span<const BehaviourTree> children);
  [[nodiscard]] static BehaviourTree fallback(std::span<const BehaviourTree> children);
  [[nodiscard]] static BehaviourTree reactive_sequence(std::span<const BehaviourTree> children);
  [[nodiscard]] static BehaviourTree reactive_fallback(std::span<const BehaviourTree> children);
  [[nodiscard]] static BehaviourTree parallel(SuccessOn success_on,
                                              std::span<const BehaviourTree> children);
  [[nodiscard]] static BehaviourTree guard(std::size_t condition, const BehaviourTree& child);
  [[nodiscard]] static BehaviourTree retry(std::size_t times, const BehaviourTree& child);
  [[nodiscard]] static BehaviourTree timeout(double after_s, const BehaviourTree& child);

  /// The same tree; its root has this name.
  [[nodiscard]] BehaviourTree named(std::string name) const;

  [[nodiscard]] std::span<const BehaviourNode> nodes() const noexcept { return nodes_; }
  [[nodiscard]] std::size_t depth() const noexcept { return depth_; }
  [[nodiscard]] bool operator==(const BehaviourTree&) const = default;

 private:
  BehaviourTree(BehaviourNode root, std::span<const BehaviourTree> children);

  std::vector<BehaviourNode> nodes_;
  std::size_t depth_ = 1;
};

/// The word for a kind in YAML and logs: sequence, fallback, parallel, guard, retry, timeout, do,
/// when.
[[nodiscard]] const char* name_of(NodeKind kind) noexcept;

}  // namespace slackwater::twin
