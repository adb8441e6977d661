#include "twin/mission/read_behaviour_tree.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <span>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/base/time.h"

namespace slackwater::twin {
namespace {

constexpr double longest_s = 30 * 86400.0;
constexpr std::size_t most_trees = 100;  // each may refer to the next

const std::vector<std::string>& node_kinds() {
  static const std::vector<std::string> keys{"do",    "when",  "sequence", "fallback", "parallel",
                                             "guard", "retry", "timeout",  "tree"};
  return keys;
}

/// Says which words of that sort there are.
[[noreturn]] void refuse_word(const Config& config, std::string_view key, std::string_view word,
                              const std::vector<std::string>& known, std::string_view what) {
  if (known.empty())
    config.refuse(key, formatted("found '{}', but there is no {} to name", word, what));
  const auto nearest = nearest_word(word, known);
  config.refuse(
      key, formatted("found '{}', expected one of the {}s {}{}", word, what, joined(known, ", "),
                     nearest ? "; did you mean '" + *nearest + "'?" : std::string()));
}

/// The place of the word after `key` among the known ones.
std::size_t read_word(const Config& config, std::string_view key,
                      const std::vector<std::string>& known, std::string_view what) {
  const std::string word = config.text(key);
  const auto found = std::find(known.begin(), known.end(), word);
  if (found == known.end()) refuse_word(config, key, word, known, what);
  return static_cast<std::size_t>(found - known.begin());
}

/// The key that says what a node is.
std::string read_kind(const Config& node) {
  std::string kind;
  for (const std::string& word : node_kinds()) {
    if (!node.has(word)) continue;
    if (!kind.empty()) node.refuse(word, "found beside " + kind + "; a node is of one kind");
    kind = word;
  }
  if (!kind.empty()) return kind;
  for (const std::string& key : node.keys()) {
    if (key == "name" || key == "reactive") continue;
    if (std::find(node_kinds().begin(), node_kinds().end(), key) != node_kinds().end())
      node.refuse(key, "found nothing after it; say what");
    refuse_word(node, key, key, node_kinds(), "kind");
  }
  node.refuse("do", "missing; a node has one of the keys " + joined(node_kinds(), ", "));
}

double read_limit_s(const Config& timeout) {
  const auto seconds = timeout.optional_number("after_s", {0.001, longest_s});
  const auto text = timeout.optional_text("after");
  if (seconds && text) timeout.refuse("after_s", "found beside after; give one of the two");
  if (!seconds && !text) timeout.refuse("after", "missing; give it as 10min, or after_s");
  if (seconds) return *seconds;
  double limit_s = 0;
  try {
    limit_s = std::chrono::duration<double>(parse_duration(*text)).count();
  } catch (const Error& problem) {
    timeout.refuse("after", problem.message());
  }
  if (!(limit_s > 0 && limit_s <= longest_s))
    timeout.refuse("after", "found " + *text + ", expected more than 0 and at most 30d");
  return limit_s;
}

class Reader {
 public:
  Reader(const Config& mission, const LeafNames& names)
      : trees_(mission.optional_child("trees")), names_(names) {
    if (!trees_) return;
    tree_names_ = trees_->keys();
    if (tree_names_.size() > most_trees)
      mission.refuse("trees", formatted("found {} trees, expected at most {}", tree_names_.size(),
                                        most_trees));
    for (const std::string& name : tree_names_) read_tree(*trees_, name, name, 1);
  }

  /// @param level  of the node; the root's is 1
  BehaviourTree read(const Config& node, std::size_t level) {
    const std::string kind = read_kind(node);
    limit_levels(node, kind, level);
    if (node.has("reactive") && kind != "sequence" && kind != "fallback")
      node.refuse("reactive", "found beside " + kind + "; only a sequence or fallback is reactive");
    const BehaviourTree tree = read_as(kind, node, level);
    const auto name = node.optional_text("name");
    return name ? tree.named(*name) : tree;
  }

 private:
  BehaviourTree read_as(const std::string& kind, const Config& node, std::size_t level) {
    if (kind == "do")
      return BehaviourTree::action(read_word(node, kind, names_.actions, "action"),
                                   node.text(kind));
    if (kind == "when")
      return BehaviourTree::condition(read_word(node, kind, names_.conditions, "condition"),
                                      node.text(kind));
    if (kind == "tree") return read_tree(node, kind, node.text(kind), level);
    if (kind == "sequence" || kind == "fallback") {
      const std::vector<BehaviourTree> children = read_children(node, kind, level);
      const bool is_reactive = node.optional_flag("reactive").value_or(false);
      if (kind == "sequence")
        return is_reactive ? BehaviourTree::reactive_sequence(children)
                           : BehaviourTree::sequence(children);
      return is_reactive ? BehaviourTree::reactive_fallback(children)
                         : BehaviourTree::fallback(children);
    }
    const Config settings = node.child(kind);
    if (kind == "parallel") {
      const std::string success_on = settings.text("success_on");
      if (success_on != "all" && success_on != "one")
        settings.refuse("success_on", "found '" + success_on + "', expected all or one");
      if (!settings.has("of")) settings.refuse("of", "missing; list what runs side by side");
      return BehaviourTree::parallel(success_on == "all" ? SuccessOn::all : SuccessOn::one,
                                     read_children(settings, "of", level));
    }
    if (kind == "guard") {
      const std::size_t condition = read_word(settings, "while", names_.conditions, "condition");
      return BehaviourTree::guard(condition, read_child(settings, level));
    }
    if (kind == "retry") {
      const int times = settings.integer("times", 1, 1000);
      return BehaviourTree::retry(static_cast<std::size_t>(times), read_child(settings, level));
    }
    const double after_s = read_limit_s(settings);
    return BehaviourTree::timeout(after_s, read_child(settings, level));
  }

  std::vector<BehaviourTree> read_children(const Config& config, std::string_view key,
                                           std::size_t level) {
    std::vector<BehaviourTree> children;
    std::size_t nodes = 1;
    for (const Config& child : config.children(key)) {
      children.push_back(read(child, level + 1));
      nodes += children.back().nodes().size();
      limit_nodes(config, key, nodes);
    }
    if (children.empty())
      config.refuse(key, "found an empty list, expected at least one node in it");
    return children;
  }

  /// `then` of a guard, retry or timeout.
  BehaviourTree read_child(const Config& settings, std::size_t level) {
    BehaviourTree child = read(settings.child("then"), level + 1);
    limit_nodes(settings, "then", 1 + child.nodes().size());
    return child;
  }

  /// The tree of that name, where `config` refers to it with `key`.
  BehaviourTree read_tree(const Config& config, std::string_view key, const std::string& name,
                          std::size_t level) {
    if (const auto known = read_.find(name); known != read_.end()) {
      limit_levels(config, key, level - 1 + known->second.depth());
      return known->second;
    }
    if (std::find(tree_names_.begin(), tree_names_.end(), name) == tree_names_.end())
      refuse_word(config, key, name, tree_names_, "tree");
    if (const auto above = std::find(under_way_.begin(), under_way_.end(), name);
        above != under_way_.end())
      config.refuse(
          key,
          formatted("found '{}', which leads back to itself: {} > {}; a tree cannot contain itself",
                    name, joined(std::span(above, under_way_.end()), " > "), name));
    under_way_.push_back(name);
    const Config node = trees_->child(name);
    BehaviourTree tree = read(node, level);
    if (!node.has("name")) tree = tree.named(name);
    under_way_.pop_back();
    return read_.emplace(name, std::move(tree)).first->second;
  }

  static void limit_levels(const Config& config, std::string_view key, std::size_t levels) {
    if (levels > BehaviourTree::deepest)
      config.refuse(key, formatted("found {} levels of nodes, expected at most {}; make the tree "
                                   "wider, not deeper",
                                   levels, BehaviourTree::deepest));
  }
  static void limit_nodes(const Config& config, std::string_view key, std::size_t nodes) {
    if (nodes > BehaviourTree::most_nodes)
      config.refuse(key, formatted("found a tree of {} nodes, expected at most {}; those of trees "
                                   "it refers to count each time",
                                   nodes, BehaviourTree::most_nodes));
  }

  std::optional<Config> trees_;
  const LeafNames& names_;
  std::vector<std::string> tree_names_;
  std::vector<std::string> under_way_;
  std::map<std::string, BehaviourTree, std::less<>> read_;
};

}  // namespace

BehaviourTree read_behaviour_tree(const Config& mission, const LeafNames& names) {
  Reader reader(mission, names);
  return reader.read(mission.child("behaviour"), 1);
}

}  // namespace slackwater::twin
