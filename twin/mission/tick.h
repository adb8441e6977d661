#pragma once
#include <concepts>
#include <cstddef>
#include <vector>

#include "twin/mission/behaviour_tree.h"

namespace slackwater::twin {

/// How a node stands: never begun, or halted; on its way; how it last ended.
enum class NodeStatus { idle, running, success, failure };

/// What changes of a node in a run. All but the status is 0 unless it runs.
struct NodeState {
  NodeStatus status = NodeStatus::idle;
  std::size_t child = 0;     ///< of a sequence or fallback: the node under way
  std::size_t failures = 0;  ///< of a retry, since it began
  double began_s = 0;        ///< of a timeout

  [[nodiscard]] bool operator==(const NodeState&) const = default;
};

/// How far a run has come in a tree: one entry for each node. A value: a copy goes on like the
/// original.
struct BehaviourState {
  std::vector<NodeState> nodes;

  [[nodiscard]] bool operator==(const BehaviourState&) const = default;
};

/// The tree before its first tick.
[[nodiscard]] BehaviourState idle_state(const BehaviourTree& tree);

/// A node's status became another.
struct StatusChange {
  std::size_t node = 0;
  NodeStatus from = NodeStatus::idle;
  NodeStatus to = NodeStatus::idle;

  [[nodiscard]] bool operator==(const StatusChange&) const = default;
};

/// Who is asked: the action or condition, and the node that asks for it. Several nodes may ask for
/// the same.
struct Leaf {
  std::size_t number = 0;  ///< BehaviourNode::leaf
  std::size_t node = 0;
};

/// What a tree's actions and conditions have to answer. An action is started, then goes on once a
/// tick while it says `running`; it is halted where it was running and is no longer asked for, and
/// then has to stop what it does. It never answers `idle`.
template <typename T>
concept BehaviourLeaves = requires(T& leaves, const Leaf& leaf) {
  { leaves.start(leaf) } -> std::same_as<NodeStatus>;
  { leaves.go_on(leaf) } -> std::same_as<NodeStatus>;
  { leaves.halt(leaf) } -> std::same_as<void>;
  { leaves.holds(leaf) } -> std::same_as<bool>;
};

/// The same behind plain functions, so that the tick is written once.
struct LeafTable {
  void* leaves = nullptr;
  NodeStatus (*start)(void*, const Leaf&) = nullptr;
  NodeStatus (*go_on)(void*, const Leaf&) = nullptr;
  void (*halt)(void*, const Leaf&) = nullptr;
  bool (*holds)(void*, const Leaf&) = nullptr;
};
template <BehaviourLeaves T>
[[nodiscard]] LeafTable table_of(T& leaves) noexcept {
  return {&leaves, [](void* of, const Leaf& leaf) { return static_cast<T*>(of)->start(leaf); },
          [](void* of, const Leaf& leaf) { return static_cast<T*>(of)->go_on(leaf); },
          [](void* of, const Leaf& leaf) { static_cast<T*>(of)->halt(leaf); },
          [](void* of, const Leaf& leaf) { return static_cast<T*>(of)->holds(leaf); }};
}

/// Asks the tree once what is to be done, from the root down. A node that was not running begins
/// anew; a root that has ended is begun again by the next tick.
///
///   do         starts its action, or lets it go on
///   when       success where its condition holds, else failure; never running
///   sequence   ticks its children in turn until one does not succeed, and answers as that one;
///              success where all do
///   fallback   ticks its children in turn until one does not fail, and answers as that one;
///              failure where all do
///              With memory both go on at the child that was running, and what came before it is
///              not asked again. Reactive ones begin at their first child each tick.
///   parallel   ticks all its children each tick, but those that have succeeded since it began:
///              failure where one fails, whatever the others answer; success where all have
///              succeeded, or with `one` where one has; else running. What has to hold all along
///              is the condition of a guard: a `when` beside others is asked until it holds once
///   guard      asks its condition before each tick of its child: where it holds it answers as the
///              child, else the child is not ticked and it fails
///   retry      answers as its child, but a failure before the `times`-th is running: the child
///              begins anew at the next tick
///   timeout    ticks its child, and fails where that still runs more than `after_s` after the
///              timeout began; a child that ends in that late tick has ended all the same
///
/// Halting: a node that runs and whose parent will not ask it again is idle from then on; an action
/// is told so, once. That is whatever runs below a guard that does not hold, a timeout that is
/// over, a parallel node that has ended (after all its children were ticked), and to the right of
/// the child where a reactive sequence or fallback stopped (after that child was ticked: for the
/// length of a call both it and what it displaces are at work). The order is that of the nodes:
/// first to last, parents before children.
///
/// All this is that of py_trees 2.6: Sequence and Selector with and without memory,
/// ParallelPolicy.SuccessOnAll(synchronise=True) and SuccessOnOne, EternalGuard, Retry and
/// Timeout, but that the clock is `now_s`. Not so: a node that has ended keeps its status until it
/// is ticked again, where some of py_trees' parents clear it.
///
/// Reactive nodes are the book's Sequence and Fallback, those with memory its starred ones (1.3.2);
/// its Parallel fails only where success is out of reach.
///
/// @param now_s    of the simulated clock, since any epoch that stays the same
/// @param changes  what changed, in the order in which it did: a node when it answers, so after
///                 those below it, and when it is halted. What it held before is lost. Never more
///                 than two for each node.
/// @return running, success or failure: of the root
/// No allocation where `changes` has room for two entries for each node.
/// @throws ContractViolation for a state of another tree, and for an action that answers `idle`;
///         the state is then that of a tick cut short
/// Source: Colledanchise & Ogren (2018), Behavior Trees in Robotics and AI, ch. 1.3; py_trees
/// documentation, "Composites", "Decorators".
NodeStatus tick(const BehaviourTree& tree, BehaviourState& state, double now_s,
                const LeafTable& leaves, std::vector<StatusChange>& changes);
template <BehaviourLeaves T>
NodeStatus tick(const BehaviourTree& tree, BehaviourState& state, double now_s, T& leaves,
                std::vector<StatusChange>& changes) {
  return tick(tree, state, now_s, table_of(leaves), changes);
}

/// Halts all that runs, from outside the tree.
void halt(const BehaviourTree& tree, BehaviourState& state, const LeafTable& leaves,
          std::vector<StatusChange>& changes);
template <BehaviourLeaves T>
void halt(const BehaviourTree& tree, BehaviourState& state, T& leaves,
          std::vector<StatusChange>& changes) {
  halt(tree, state, table_of(leaves), changes);
}

}  // namespace slackwater::twin
