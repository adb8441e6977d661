// made_up_behaviours OUT [TREES [TICKS [SEED]]]: random behaviour trees, what their leaves are told
// to answer tick by tick, and what came of it, for strangers' tools to run again. Nodes go by their
// place in the tree:
//
//   outcomes  one letter for each node: r, s, f of an action, + or - of a condition or guard
//   calls     +3 started, =3 goes on, -3 halted, ?3 asked whether it holds; in their order
//   statuses  one letter for each node after the tick: i, r, s, f
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "twin/mission/tick.h"

namespace {

using namespace slackwater;
using nlohmann::json;
using twin::BehaviourTree;
using twin::NodeStatus;

constexpr std::size_t deepest = 5;

std::size_t pick(Rng& rng, std::size_t count) {
  return std::min(static_cast<std::size_t>(rng.uniform() * static_cast<double>(count)), count - 1);
}

BehaviourTree random_tree(Rng& rng, std::size_t levels);

std::vector<BehaviourTree> random_children(Rng& rng, std::size_t levels) {
  std::vector<BehaviourTree> children;
  for (std::size_t left = 1 + pick(rng, 4); left > 0; --left)
    children.push_back(random_tree(rng, levels - 1));
  return children;
}

BehaviourTree random_tree(Rng& rng, std::size_t levels) {
  switch (levels > 1 ? pick(rng, 12) : pick(rng, 3)) {
    case 0:
    case 1:
      return BehaviourTree::action(0);
    case 2:
      return BehaviourTree::condition(0);
    case 3:
      return BehaviourTree::sequence(random_children(rng, levels));
    case 4:
      return BehaviourTree::fallback(random_children(rng, levels));
    case 5:
      return BehaviourTree::reactive_sequence(random_children(rng, levels));
    case 6:
      return BehaviourTree::reactive_fallback(random_children(rng, levels));
    case 7:
      return BehaviourTree::parallel(twin::SuccessOn::all, random_children(rng, levels));
    case 8:
      return BehaviourTree::parallel(twin::SuccessOn::one, random_children(rng, levels));
    case 9:
      return BehaviourTree::guard(0, random_tree(rng, levels - 1));
    case 10:
      return BehaviourTree::retry(1 + pick(rng, 3), random_tree(rng, levels - 1));
    default:
      return BehaviourTree::timeout(0.5 * static_cast<double>(1 + pick(rng, 8)),
                                    random_tree(rng, levels - 1));
  }
}

char letter(NodeStatus status) { return "irsf"[static_cast<int>(status)]; }

/// Leaves that answer what stands in `outcomes`, and write down what they were asked.
struct ToldLeaves {
  std::string outcomes;
  std::string calls;

  NodeStatus start(const twin::Leaf& leaf) { return answered('+', leaf); }
  NodeStatus go_on(const twin::Leaf& leaf) { return answered('=', leaf); }
  void halt(const twin::Leaf& leaf) { write('-', leaf); }
  bool holds(const twin::Leaf& leaf) {
    write('?', leaf);
    return outcomes.at(leaf.node) == '+';
  }

 private:
  NodeStatus answered(char what, const twin::Leaf& leaf) {
    write(what, leaf);
    const char outcome = outcomes.at(leaf.node);
    return outcome == 'r'   ? NodeStatus::running
           : outcome == 's' ? NodeStatus::success
                            : NodeStatus::failure;
  }
  void write(char what, const twin::Leaf& leaf) {
    if (!calls.empty()) calls += ' ';
    calls += what + std::to_string(leaf.node);
  }
};

std::string random_outcomes(Rng& rng, const BehaviourTree& tree) {
  std::string outcomes;
  for (const twin::BehaviourNode& node : tree.nodes())
    outcomes += node.kind == twin::NodeKind::action ? "rrrrrsssff"[pick(rng, 10)]
                                                    : "+++++++---"[pick(rng, 10)];
  return outcomes;
}

json nodes_json(const BehaviourTree& tree) {
  json list = json::array();
  for (const twin::BehaviourNode& node : tree.nodes())
    list.push_back({{"kind", name_of(node.kind)},
                    {"size", node.size},
                    {"reactive", node.is_reactive},
                    {"success_on", node.success_on == twin::SuccessOn::all ? "all" : "one"},
                    {"times", node.times},
                    {"after_s", node.after_s}});
  return list;
}

/// One in twenty ticks comes after the tree was halted from outside. The clock moves by halves and
/// tenths of a second, often from 0, so that a timeout also meets its very end.
json ticks_json(Rng& rng, const BehaviourTree& tree, std::size_t ticks) {
  json list = json::array();
  twin::BehaviourState state = idle_state(tree);
  std::vector<twin::StatusChange> changes;
  ToldLeaves leaves;
  const double step_s = rng.uniform() < 0.5 ? 0.5 : 0.1;
  double now_s = rng.uniform() < 0.5 ? 0 : 100 * rng.uniform();
  for (std::size_t i = 0; i < ticks; ++i) {
    leaves.outcomes = random_outcomes(rng, tree);
    leaves.calls.clear();
    const bool is_halted = rng.uniform() < 0.05;
    if (is_halted) halt(tree, state, leaves, changes);
    const NodeStatus answer = tick(tree, state, now_s, leaves, changes);
    std::string statuses;
    for (const twin::NodeState& node : state.nodes) statuses += letter(node.status);
    list.push_back({{"now_s", now_s},
                    {"is_halted", is_halted},
                    {"outcomes", leaves.outcomes},
                    {"answer", std::string(1, letter(answer))},
                    {"calls", leaves.calls},
                    {"statuses", statuses}});
    now_s += step_s * static_cast<double>(pick(rng, 4));
  }
  return list;
}

std::size_t number(int argc, char** argv, int index, std::size_t otherwise) {
  return index < argc ? static_cast<std::size_t>(std::strtoul(argv[index], nullptr, 10))
                      : otherwise;
}

void write(int argc, char** argv) {
  const std::size_t trees = number(argc, argv, 2, 1000), ticks = number(argc, argv, 3, 30);
  const std::size_t seed = number(argc, argv, 4, 1);
  Rng rng(seed, "strangers/made_up_behaviours");
  json cases = json::array();
  while (cases.size() < trees) {
    const BehaviourTree tree = random_tree(rng, deepest);
    if (tree.depth() == 1 && rng.uniform() < 0.9) continue;  // leaves alone: a few are enough
    cases.push_back({{"nodes", nodes_json(tree)}, {"ticks", ticks_json(rng, tree, ticks)}});
  }
  std::ofstream file(argv[1], std::ios::binary);
  file << json{{"seed", seed}, {"cases", std::move(cases)}};
  if (!file.flush()) throw Error(ErrorKind::unavailable, std::string("cannot write ") + argv[1]);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "give OUT [TREES [TICKS [SEED]]]\n");
    return 2;
  }
  try {
    write(argc, argv);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
  return 0;
}
