#include "twin/mission/behaviour_tree.h"

#include <gtest/gtest.h>

#include <limits>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "tests/bench/counted_allocations.h"
#include "tests/twin/mission/leaves_for_tests.h"
#include "twin/mission/tick.h"
#include "twin/run/state_members.h"

namespace slackwater::twin::behaviour_tree_test {
namespace {

using Tree = BehaviourTree;
using Trees = std::vector<BehaviourTree>;

const Tree a = Tree::action(0, "a"), b = Tree::action(1, "b"), c = Tree::action(2, "c");
const Tree p = Tree::condition(0, "p"), q = Tree::condition(1, "q");

char letter(NodeStatus status) { return "irsf"[static_cast<int>(status)]; }

NodeStatus status_of(char letter) {
  return letter == 'r'   ? NodeStatus::running
         : letter == 's' ? NodeStatus::success
                         : NodeStatus::failure;
}

/// A tree in a run that is told what its leaves answer.
class Flown {
 public:
  explicit Flown(Tree tree) : tree_(std::move(tree)), state(idle_state(tree_)) {}

  /// @param told  a letter for each action (r, s, f), then + or - for each condition
  /// @return the root's answer and the calls: "r: +a -b"
  std::string tick(const std::string& told, double now_s = 0) {
    tell(told);
    const NodeStatus answer = twin::tick(tree_, state, now_s, leaves_, changes);
    EXPECT_EQ(answer, state.nodes.front().status);
    return std::string(1, letter(answer)) + ": " + leaves_.calls;
  }
  std::string halt() {
    leaves_.calls.clear();
    twin::halt(tree_, state, leaves_, changes);
    return leaves_.calls;
  }
  /// "0i>r 1r>s"
  [[nodiscard]] std::string changed() const {
    std::string out;
    for (const auto& [node, from, to] : changes) {
      if (!out.empty()) out += ' ';
      out += std::to_string(node) + letter(from) + '>' + letter(to);
    }
    return out;
  }
  [[nodiscard]] std::string statuses() const {
    std::string out;
    for (const NodeState& node : state.nodes) out += letter(node.status);
    return out;
  }

 private:
  void tell(const std::string& told) {
    leaves_.calls.clear();
    std::size_t action = 0, condition = 0;
    for (const char what : told) {
      if (what == '+' || what == '-')
        leaves_.truths.at(condition++) = what == '+';
      else
        leaves_.answers.at(action++) = status_of(what);
    }
  }

  Tree tree_;
  tests::ScriptedLeaves leaves_;

 public:
  BehaviourState state;
  std::vector<StatusChange> changes;
};

TEST(BehaviourTree, StandsInPreorderWithTheSizeOfEachSubtree) {
  const Tree tree = Tree::sequence(Trees{a, Tree::guard(1, b), p}).named("work");
  ASSERT_EQ(tree.nodes().size(), 5U);
  EXPECT_EQ(tree.depth(), 3U);
  const std::vector<std::string> names{"work", "a", "guard", "b", "p"};
  const std::vector<std::size_t> sizes{5, 1, 2, 1, 1};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(tree.nodes()[i].name, names[i]);
    EXPECT_EQ(tree.nodes()[i].size, sizes[i]);
  }
  EXPECT_EQ(tree.nodes()[2].leaf, 1U);
  EXPECT_EQ(tree, Tree::sequence(Trees{a, Tree::guard(1, b), p}).named("work"));
  EXPECT_NE(tree, Tree::sequence(Trees{a, Tree::guard(0, b), p}).named("work"));
  EXPECT_NE(tree, Tree::reactive_sequence(Trees{a, Tree::guard(1, b), p}).named("work"));
}

TEST(BehaviourTree, RefusesWhatNoTickCouldWalk) {
  EXPECT_THROW((void)Tree::sequence({}), ContractViolation);
  EXPECT_THROW((void)Tree::fallback({}), ContractViolation);
  EXPECT_THROW((void)Tree::parallel(SuccessOn::one, {}), ContractViolation);
  EXPECT_THROW((void)Tree::retry(0, a), ContractViolation);
  EXPECT_THROW((void)Tree::timeout(0, a), ContractViolation);
  EXPECT_THROW((void)Tree::timeout(-1, a), ContractViolation);
  EXPECT_THROW((void)Tree::timeout(std::numeric_limits<double>::quiet_NaN(), a), ContractViolation);
  EXPECT_THROW((void)Tree::timeout(std::numeric_limits<double>::infinity(), a), ContractViolation);
  Tree deep = a;
  while (deep.depth() < Tree::deepest) deep = Tree::retry(2, deep);
  EXPECT_THROW((void)Tree::retry(2, deep), ContractViolation);
  const Trees leaves(Tree::most_nodes, a);
  EXPECT_EQ(Tree::sequence(std::span(leaves).first(Tree::most_nodes - 1)).nodes().size(),
            Tree::most_nodes);
  EXPECT_THROW((void)Tree::sequence(leaves), ContractViolation);
}

TEST(Tick, AnActionIsStartedOnceThenGoesOn) {
  Flown run(a);
  EXPECT_EQ(run.tick("r"), "r: +a");
  EXPECT_EQ(run.tick("r"), "r: =a");
  EXPECT_EQ(run.tick("s"), "s: =a");
  EXPECT_EQ(run.tick("f"), "f: +a");
  EXPECT_EQ(run.tick("r"), "r: +a");
}

TEST(Tick, AConditionIsAskedAtEachTickAndNeverRuns) {
  Flown run(p);
  EXPECT_EQ(run.tick("+"), "s: ?p");
  EXPECT_EQ(run.tick("-"), "f: ?p");
  EXPECT_EQ(run.tick("-"), "f: ?p");
  EXPECT_EQ(run.changed(), "");
  EXPECT_EQ(run.halt(), "");
}

TEST(Tick, ASequenceGoesOnAtTheChildThatRuns) {
  Flown run(Tree::sequence(Trees{a, p, b}));
  EXPECT_EQ(run.tick("rr+"), "r: +a");
  EXPECT_EQ(run.tick("sr+"), "r: =a ?p +b");
  EXPECT_EQ(run.tick("fr-"), "r: =b");
  EXPECT_EQ(run.tick("fs-"), "s: =b");
  EXPECT_EQ(run.tick("fs-"), "f: +a");
  EXPECT_EQ(run.tick("ss-"), "f: +a ?p");
}

TEST(Tick, AReactiveSequenceAsksFromTheFirstAndHaltsWhatIsBehind) {
  Flown run(Tree::reactive_sequence(Trees{p, a, b}));
  EXPECT_EQ(run.tick("sr+"), "r: ?p +a +b");
  EXPECT_EQ(run.tick("sr+"), "r: ?p +a =b");
  EXPECT_EQ(run.tick("rr+"), "r: ?p +a -b") << "b is displaced by a, after a was started";
  EXPECT_EQ(run.tick("rr-"), "f: ?p -a");
  EXPECT_EQ(run.tick("rr-"), "f: ?p") << "halted once";
}

TEST(Tick, AFallbackGoesOnAtTheChildThatRuns) {
  Flown run(Tree::fallback(Trees{p, a, b}));
  EXPECT_EQ(run.tick("rr-"), "r: ?p +a");
  EXPECT_EQ(run.tick("fr+"), "r: =a +b") << "p holds now, and is not asked";
  EXPECT_EQ(run.tick("fs+"), "s: =b");
  EXPECT_EQ(run.tick("fs+"), "s: ?p");
  EXPECT_EQ(run.tick("ff-"), "f: ?p +a +b");
}

TEST(Tick, AReactiveFallbackAsksFromTheFirstAndHaltsWhatIsBehind) {
  Flown run(Tree::reactive_fallback(Trees{p, a, b}));
  EXPECT_EQ(run.tick("fr-"), "r: ?p +a +b");
  EXPECT_EQ(run.tick("rr-"), "r: ?p +a -b");
  EXPECT_EQ(run.tick("rr+"), "s: ?p -a");
  EXPECT_EQ(run.tick("rr+"), "s: ?p");
}

TEST(Tick, AParallelNodeThatWantsAllWaitsForTheLastAndAsksNoneTwice) {
  Flown run(Tree::parallel(SuccessOn::all, Trees{a, b}));
  EXPECT_EQ(run.tick("sr"), "r: +a +b");
  EXPECT_EQ(run.tick("fr"), "r: =b") << "the first has done its part";
  EXPECT_EQ(run.tick("fs"), "s: =b");
  EXPECT_EQ(run.tick("rr"), "r: +a +b") << "it begins anew";
  EXPECT_EQ(run.tick("fr"), "f: =a =b -b") << "all are ticked before one is halted";
  EXPECT_EQ(run.tick("sf"), "f: +a +b");
}

TEST(Tick, AParallelNodeThatWantsOneFailsWhereOneFailsAllTheSame) {
  Flown run(Tree::parallel(SuccessOn::one, Trees{a, b, c}));
  EXPECT_EQ(run.tick("rrr"), "r: +a +b +c");
  EXPECT_EQ(run.tick("rsr"), "s: =a =b =c -a -c");
  EXPECT_EQ(run.tick("rsf"), "f: +a +b +c -a");
  EXPECT_EQ(run.tick("sss"), "s: +a +b +c");
}

TEST(Tick, AGuardAsksBeforeEachTickOfItsChild) {
  Flown run(Tree::guard(0, a));
  EXPECT_EQ(run.tick("r-"), "f: ?p");
  EXPECT_EQ(run.tick("r+"), "r: ?p +a");
  EXPECT_EQ(run.tick("r+"), "r: ?p =a");
  EXPECT_EQ(run.tick("r-"), "f: ?p -a");
  EXPECT_EQ(run.tick("r-"), "f: ?p");
  EXPECT_EQ(run.tick("s+"), "s: ?p +a");
}

TEST(Tick, ARetryRunsUntilTheLastFailure) {
  Flown run(Tree::retry(3, a));
  EXPECT_EQ(run.tick("f"), "r: +a");
  EXPECT_EQ(run.tick("r"), "r: +a");
  EXPECT_EQ(run.tick("f"), "r: =a");
  EXPECT_EQ(run.state.nodes[0].failures, 2U);
  EXPECT_EQ(run.tick("f"), "f: +a");
  EXPECT_EQ(run.tick("f"), "r: +a") << "it counts anew";
  EXPECT_EQ(run.tick("s"), "s: +a");
  EXPECT_EQ(run.state.nodes[0].failures, 0U);
  Flown once(Tree::retry(1, a));
  EXPECT_EQ(once.tick("f"), "f: +a");
}

TEST(Tick, ARetryBetweenTwoAttemptsHasNothingToHalt) {
  Flown run(Tree::reactive_sequence(Trees{p, Tree::retry(3, a)}));
  EXPECT_EQ(run.tick("f+"), "r: ?p +a");
  EXPECT_EQ(run.tick("f-"), "f: ?p");
  EXPECT_EQ(run.changed(), "1s>f 2r>i 0r>f");
  EXPECT_EQ(run.tick("f+"), "r: ?p +a");
  EXPECT_EQ(run.state.nodes[2].failures, 1U) << "halted, it counts anew";
}

TEST(Tick, ATimeoutIsOverAfterItsTimeAndNotAtIt) {
  Flown run(Tree::timeout(10, a));
  EXPECT_EQ(run.tick("r", 100), "r: +a");
  EXPECT_EQ(run.tick("r", 110), "r: =a");
  EXPECT_EQ(run.tick("r", 110.001), "f: =a -a") << "the child is ticked once more";
  EXPECT_EQ(run.tick("r", 200), "r: +a") << "its time begins anew";
  EXPECT_EQ(run.tick("s", 300), "s: =a") << "what ends, ends, late as it is";
  EXPECT_EQ(run.tick("f", 300), "f: +a");
  Flown from_zero(Tree::timeout(10, a));
  for (const double now_s : {0, 5, 10}) EXPECT_EQ(from_zero.tick("r", now_s).substr(0, 2), "r:");
  EXPECT_EQ(from_zero.tick("r", 11), "f: =a -a");
}

TEST(Tick, HaltsAWholeSubtreeOnceFromFirstToLast) {
  const Tree both = Tree::parallel(
      SuccessOn::all, Trees{Tree::timeout(100, a), Tree::sequence(Trees{p, b}), Tree::retry(5, c)});
  Flown run(Tree::guard(1, both));
  EXPECT_EQ(run.tick("rrr++"), "r: ?q +a ?p +b +c");
  EXPECT_EQ(run.tick("rrf++"), "r: ?q =a =b =c");
  EXPECT_EQ(run.tick("rrr+-"), "f: ?q -a -b") << "c has failed and waits for its next attempt";
  EXPECT_EQ(run.changed(), "1r>i 2r>i 3r>i 4r>i 6r>i 7r>i 0r>f");
  EXPECT_EQ(run.tick("rrr+-"), "f: ?q");
  EXPECT_EQ(run.changed(), "");
}

TEST(Halt, StopsFromOutsideWhatRuns) {
  Flown run(Tree::sequence(Trees{a, Tree::parallel(SuccessOn::one, Trees{b, c})}));
  EXPECT_EQ(run.tick("srr"), "r: +a +b +c");
  EXPECT_EQ(run.halt(), "-b -c");
  EXPECT_EQ(run.statuses(), "isiii");
  EXPECT_EQ(run.changed(), "0r>i 2r>i 3r>i 4r>i");
  EXPECT_EQ(run.halt(), "");
  EXPECT_EQ(run.tick("srr"), "r: +a +b +c") << "from the beginning";
}

TEST(Changes, AreToldInTheOrderInWhichTheyHappen) {
  Flown run(Tree::sequence(Trees{a, b}));
  (void)run.tick("rr");
  EXPECT_EQ(run.changed(), "1i>r 0i>r");
  (void)run.tick("rr");
  EXPECT_EQ(run.changed(), "");
  (void)run.tick("sr");
  EXPECT_EQ(run.changed(), "1r>s 2i>r");
  (void)run.tick("sf");
  EXPECT_EQ(run.changed(), "2r>f 0r>f");
  Flown brief(Tree::parallel(SuccessOn::all, Trees{a, b}));
  (void)brief.tick("rf");
  EXPECT_EQ(brief.changed(), "1i>r 2i>f 1r>i 0i>f") << "begun and halted in one tick";
}

TEST(BehaviourState, ANodeThatDoesNotRunRemembersOnlyHowItEnded) {
  Flown run(
      Tree::sequence(Trees{Tree::retry(3, a), Tree::timeout(5, b), Tree::fallback(Trees{p, c})}));
  EXPECT_EQ(run.tick("frr-", 7), "r: +a");
  EXPECT_EQ(run.tick("srr-", 8), "r: +a +b");
  EXPECT_EQ(run.state.nodes[0].child, 3U);
  EXPECT_EQ(run.state.nodes[3].began_s, 8);
  EXPECT_EQ(run.tick("ssr-", 9), "r: =b ?p +c");
  EXPECT_EQ(run.state.nodes[5].child, 7U);
  (void)run.halt();
  for (const NodeState& node : run.state.nodes) EXPECT_EQ(node, (NodeState{.status = node.status}));
}

TEST(BehaviourState, OfAnotherTreeIsRefused) {
  tests::ScriptedLeaves leaves;
  std::vector<StatusChange> changes;
  BehaviourState other = idle_state(Tree::sequence(Trees{a, b}));
  EXPECT_THROW(tick(a, other, 0, leaves, changes), ContractViolation);
  EXPECT_THROW(halt(a, other, leaves, changes), ContractViolation);
  other.nodes[0] = {.status = NodeStatus::running, .child = 7};
  EXPECT_THROW(tick(Tree::sequence(Trees{a, b}), other, 0, leaves, changes), ContractViolation);
  BehaviourState own = idle_state(a);
  leaves.answers[0] = NodeStatus::idle;
  EXPECT_THROW(tick(a, own, 0, leaves, changes), ContractViolation);
}

/// Numbers of all members, in the order in which a checkpoint names them.
std::vector<double> named_members(const BehaviourState& state) {
  std::vector<double> out;
  for_each_member(state, [&](const char*, const std::vector<NodeState>& nodes) {
    for (const NodeState& node : nodes)
      for_each_member(node,
                      [&](const char*, const auto& x) { out.push_back(static_cast<double>(x)); });
  });
  return out;
}

BehaviourState state_of(const std::vector<double>& members) {
  BehaviourState state;
  std::size_t next = 0;
  for_each_member(state, [&](const char*, std::vector<NodeState>& nodes) {
    nodes.resize(members.size() / 4);
    for (NodeState& node : nodes)
      for_each_member(node, [&](const char*, auto& x) {
        x = static_cast<std::remove_reference_t<decltype(x)>>(members.at(next++));
      });
  });
  return state;
}

const Tree all_kinds = Tree::reactive_fallback(
    Trees{Tree::guard(0, Tree::sequence(Trees{a, Tree::retry(3, b)})),
          Tree::parallel(SuccessOn::one, Trees{Tree::timeout(4, c), Tree::fallback(Trees{q, a})}),
          Tree::reactive_sequence(Trees{q, Tree::parallel(SuccessOn::all, Trees{b, c})})});

std::string told_by(Rng& rng) {
  std::string told;
  for (int i = 0; i < 3; ++i) told += "rrrrssf"[static_cast<int>(7 * rng.uniform())];
  for (int i = 0; i < 2; ++i) told += rng.uniform() < 0.6 ? '+' : '-';
  return told;
}

TEST(BehaviourState, StoredByItsMembersItGoesOnTheSame) {
  Rng rng(1, "behaviour_tree_test");
  std::size_t halts = 0;
  for (int run = 0; run < 200; ++run) {
    Flown first(all_kinds);
    const int stored_at = static_cast<int>(20 * rng.uniform());
    for (int i = 0; i < stored_at; ++i) (void)first.tick(told_by(rng), i);
    Flown second(all_kinds);
    second.state = state_of(named_members(first.state));
    ASSERT_EQ(second.state, first.state);
    for (int i = stored_at; i < 40; ++i) {
      const std::string told = told_by(rng);
      const std::string said = first.tick(told, i);
      ASSERT_EQ(second.tick(told, i), said) << run << " at " << i;
      ASSERT_EQ(second.state, first.state);
      ASSERT_EQ(second.changes, first.changes);
      halts += said.find('-') != std::string::npos ? 1U : 0U;
    }
  }
  EXPECT_GT(halts, 500U);
}

/// Calls no one, keeps no list.
struct CountingLeaves {
  Rng rng{2, "behaviour_tree_test"};
  std::size_t asked = 0;
  NodeStatus start(const Leaf&) { return go_on({}); }
  NodeStatus go_on(const Leaf&) {
    ++asked;
    const double u = rng.uniform();
    return u < 0.6 ? NodeStatus::running : u < 0.85 ? NodeStatus::success : NodeStatus::failure;
  }
  void halt(const Leaf&) { ++asked; }
  bool holds(const Leaf&) { return rng.uniform() < 0.6; }
};

TEST(Tick, AllocatesNothingAndTellsAtMostTwoChangesOfANode) {
  CountingLeaves leaves;
  BehaviourState state = idle_state(all_kinds);
  std::vector<StatusChange> changes;
  changes.reserve(2 * state.nodes.size());
  const std::size_t before = bench::allocations();
  for (int i = 0; i < 10000; ++i) {
    tick(all_kinds, state, i, leaves, changes);
    if (i % 100 == 0) halt(all_kinds, state, leaves, changes);
  }
  EXPECT_EQ(bench::allocations(), before);
  EXPECT_GT(leaves.asked, 10000U);
  (void)idle_state(all_kinds);
  EXPECT_GT(bench::allocations(), before) << "the counter counts";
}

}  // namespace
}  // namespace slackwater::twin::behaviour_tree_test
