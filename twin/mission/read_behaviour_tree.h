#pragma once
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "twin/mission/behaviour_tree.h"

namespace slackwater::twin {

/// What leaves may ask for. Their numbers in the tree are the places in these lists.
struct LeafNames {
  std::vector<std::string> actions;
  std::vector<std::string> conditions;
};

/// `behaviour` of a mission's YAML, and `trees`, the named subtrees that it may refer to:
///
///     trees:
///       survey: {sequence: [{do: transit}, {do: scan}]}
///     behaviour:
///       fallback:
///         - guard: {while: within_limits, then: {tree: survey}}
///         - {do: go_home, name: away}
///       reactive: true
///
/// A node is a mapping with the key of its kind, and a `name` for the log if that of its kind, its
/// action, its condition or its tree will not do:
///
///     do: ACTION                       when: CONDITION                tree: NAME
///     sequence: [NODE, ...]            fallback: [NODE, ...]
///     both with `reactive: true` beside them, or without: `tick.h` says what that does
///     parallel: {success_on: all or one, of: [NODE, ...]}
///     guard: {while: CONDITION, then: NODE}
///     retry: {times: 1 to 1000, then: NODE}
///     timeout: {after: 10min, then: NODE}, or `after_s: 30`
///
/// All named trees are read, whether or not the behaviour refers to them; keys that are not read
/// are left to `expect_all_read`.
/// @throws Error(invalid_input) with file and line for what is no such node, unknown names, trees
///         that lead back to themselves, and more than `deepest` levels or `most_nodes`
[[nodiscard]] BehaviourTree read_behaviour_tree(const Config& mission, const LeafNames& names);

}  // namespace slackwater::twin
