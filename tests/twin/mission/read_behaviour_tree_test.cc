#include "twin/mission/read_behaviour_tree.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"

namespace slackwater::twin::read_behaviour_tree_test {
namespace {

using Tree = BehaviourTree;
using Trees = std::vector<BehaviourTree>;

const LeafNames names{{"transit", "scan", "go_home"}, {"within_limits", "is_daylight"}};

BehaviourTree read(const std::string& yaml) {
  const Config config = Config::parse(yaml, "made-up.yaml");
  BehaviourTree tree = read_behaviour_tree(config, names);
  config.expect_all_read();
  return tree;
}

/// What is said of a file that is refused.
std::string said_of(const std::string& yaml) {
  try {
    (void)read(yaml);
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "taken";
}

std::string said_of_node(const std::string& node) { return said_of("behaviour: " + node); }

TEST(ReadBehaviourTree, TakesEveryKindAsTheFileHasIt) {
  const Tree tree = read(R"(
trees:
  survey:
    sequence: [{do: transit}, {do: scan}]
  careful: {guard: {while: within_limits, then: {tree: survey}}, name: careful survey}
behaviour:
  fallback:
    - {tree: careful}
    - retry: {times: 3, then: {timeout: {after: 1h30min, then: {tree: survey, name: again}}}}
    - parallel:
        success_on: one
        of: [{do: go_home, name: away}, {when: is_daylight}]
    - {parallel: {success_on: all, of: [{timeout: {after_s: 2.5, then: {do: scan}}}]}}
    - {sequence: [{when: within_limits}], reactive: true}
  reactive: true
  name: day
)");
  const Tree transit = Tree::action(0, "transit"), scan = Tree::action(1, "scan");
  const Tree survey = Tree::sequence(Trees{transit, scan}).named("survey");
  const Tree daylight = Tree::condition(1, "is_daylight");
  const Tree expected =
      Tree::reactive_fallback(
          Trees{Tree::guard(0, survey).named("careful survey"),
                Tree::retry(3, Tree::timeout(5400, survey.named("again"))),
                Tree::parallel(SuccessOn::one, Trees{Tree::action(2, "away"), daylight}),
                Tree::parallel(SuccessOn::all, Trees{Tree::timeout(2.5, scan)}),
                Tree::reactive_sequence(Trees{Tree::condition(0, "within_limits")})})
          .named("day");
  EXPECT_EQ(tree, expected);
}

TEST(ReadBehaviourTree, ATreeMayReferToOneThatStandsBelowIt) {
  const Tree tree = read(
      "trees: {first: {tree: second}, second: {do: scan}}\n"
      "behaviour: {sequence: [{tree: first}, {tree: second}]}");
  EXPECT_EQ(tree, Tree::sequence(Trees{Tree::action(1, "first"), Tree::action(1, "second")}));
}

TEST(ReadBehaviourTree, RefusesWhatIsNoNode) {
  EXPECT_EQ(said_of("trees: {}\n"), "made-up.yaml:1: key 'behaviour' is missing; add it");
  EXPECT_EQ(said_of("behaviour:\n  squence: [{do: scan}]"),
            "made-up.yaml:2: behaviour.squence: found 'squence', expected one of the kinds do, "
            "when, sequence, fallback, parallel, guard, retry, timeout, tree; did you mean "
            "'sequence'?");
  EXPECT_EQ(said_of_node("{name: work}"),
            "made-up.yaml:1: behaviour.do: missing; a node has one of the keys do, when, sequence, "
            "fallback, parallel, guard, retry, timeout, tree");
  EXPECT_EQ(said_of_node("{do: }"),
            "made-up.yaml:1: behaviour.do: found nothing after it; say what");
  EXPECT_EQ(said_of("behaviour:\n  do: scan\n  when: is_daylight"),
            "made-up.yaml:3: behaviour.when: found beside do; a node is of one kind");
  EXPECT_EQ(said_of("behaviour:\n  sequence:\n    - scan"),
            "made-up.yaml:3: behaviour.sequence[0]: found 'scan' where a mapping (key: value) was "
            "expected");
  EXPECT_EQ(said_of_node("{sequence: scan}"),
            "made-up.yaml:1: behaviour.sequence: found 'scan' where a list was expected");
  EXPECT_EQ(said_of_node("{do: scan, nmae: x}"),
            "made-up.yaml:1: unknown key 'behaviour.nmae'; did you mean 'name'?");
  EXPECT_EQ(said_of_node("{retry: {times: 3, then: {do: scan}}, reactive: true}"),
            "made-up.yaml:1: behaviour.reactive: found beside retry; only a sequence or fallback "
            "is reactive");
}

TEST(ReadBehaviourTree, RefusesNamesThatNobodyHas) {
  EXPECT_EQ(said_of("behaviour:\n  sequence:\n    - {do: scann}"),
            "made-up.yaml:3: behaviour.sequence[0].do: found 'scann', expected one of the actions "
            "transit, scan, go_home; did you mean 'scan'?");
  EXPECT_EQ(said_of_node("{when: scan}"),
            "made-up.yaml:1: behaviour.when: found 'scan', expected one of the conditions "
            "within_limits, is_daylight");
  EXPECT_EQ(said_of_node("{guard: {while: within_limit, then: {do: scan}}}"),
            "made-up.yaml:1: behaviour.guard.while: found 'within_limit', expected one of the "
            "conditions within_limits, is_daylight; did you mean 'within_limits'?");
  EXPECT_EQ(said_of("trees:\n  survey: {do: scan}\nbehaviour:\n  tree: survay"),
            "made-up.yaml:4: behaviour.tree: found 'survay', expected one of the trees survey; did "
            "you mean 'survey'?");
  EXPECT_EQ(said_of_node("{tree: survey}"),
            "made-up.yaml:1: behaviour.tree: found 'survey', but there is no tree to name");
}

TEST(ReadBehaviourTree, RefusesNodesWithoutWhatTheyNeed) {
  EXPECT_EQ(said_of("behaviour:\n  sequence: []"),
            "made-up.yaml:2: behaviour.sequence: found an empty list, expected at least one node "
            "in it");
  EXPECT_EQ(said_of_node("{parallel: {success_on: all, of: []}}"),
            "made-up.yaml:1: behaviour.parallel.of: found an empty list, expected at least one "
            "node in it");
  EXPECT_EQ(said_of_node("{parallel: {success_on: all}}"),
            "made-up.yaml:1: behaviour.parallel.of: missing; list what runs side by side");
  EXPECT_EQ(said_of_node("{parallel: {success_on: two, of: [{do: scan}]}}"),
            "made-up.yaml:1: behaviour.parallel.success_on: found 'two', expected all or one");
  EXPECT_EQ(said_of_node("{parallel: {of: [{do: scan}]}}"),
            "made-up.yaml:1: key 'behaviour.parallel.success_on' is missing; add it");
  EXPECT_EQ(said_of_node("{guard: {then: {do: scan}}}"),
            "made-up.yaml:1: key 'behaviour.guard.while' is missing; add it");
  EXPECT_EQ(said_of_node("{retry: {times: 3, tehn: {do: scan}}}"),
            "made-up.yaml:1: key 'behaviour.retry.then' is missing; add it");
  EXPECT_EQ(said_of_node("{timeout: {then: {do: scan}}}"),
            "made-up.yaml:1: behaviour.timeout.after: missing; give it as 10min, or after_s");
}

TEST(ReadBehaviourTree, RefusesTimesThatAreNone) {
  const auto retry = [](const std::string& times) {
    return said_of_node("\n  retry:\n    times: " + times + "\n    then: {do: scan}");
  };
  EXPECT_EQ(retry("0"),
            "made-up.yaml:3: behaviour.retry.times: found 0, expected a value from 1 to 1000; "
            "check the unit in the key's name");
  EXPECT_NE(retry("-2").find("found -2"), std::string::npos);
  EXPECT_NE(retry("1.5").find("whole number"), std::string::npos);
  const auto timeout = [](const std::string& after) {
    return said_of_node("\n  timeout:\n    " + after + "\n    then: {do: scan}");
  };
  EXPECT_EQ(
      timeout("after: 0min"),
      "made-up.yaml:3: behaviour.timeout.after: found 0min, expected more than 0 and at most 30d");
  EXPECT_NE(timeout("after: 31d").find("at most 30d"), std::string::npos);
  EXPECT_EQ(timeout("after: -5min"),
            "made-up.yaml:3: behaviour.timeout.after: found '-5min' where a duration was expected; "
            "write it as 72h, 90min, 3d or 1h30min");
  EXPECT_NE(timeout("after_s: 0").find("found 0, expected a value from 0.001"), std::string::npos);
  EXPECT_EQ(said_of_node("{timeout: {after: 1min, after_s: 60, then: {do: scan}}}"),
            "made-up.yaml:1: behaviour.timeout.after_s: found beside after; give one of the two");
}

TEST(ReadBehaviourTree, RefusesTreesThatLeadBackToThemselves) {
  EXPECT_EQ(said_of("trees:\n  survey: {tree: survey}\nbehaviour: {do: scan}"),
            "made-up.yaml:2: trees.survey.tree: found 'survey', which leads back to itself: survey "
            "> survey; a tree cannot contain itself");
  EXPECT_EQ(said_of("trees:\n"
                    "  work: {sequence: [{do: transit}, {tree: survey}]}\n"
                    "  survey: {retry: {times: 2, then: {tree: dive}}}\n"
                    "  dive:\n"
                    "    fallback:\n"
                    "      - {tree: survey}\n"
                    "behaviour: {do: scan}"),
            "made-up.yaml:6: trees.dive.fallback[0].tree: found 'survey', which leads back to "
            "itself: survey > dive > survey; a tree cannot contain itself");
}

/// A chain of so many retries above an action.
std::string chain(std::size_t retries, const std::string& end) {
  std::string yaml = end;
  for (std::size_t i = 0; i < retries; ++i) yaml = "{retry: {times: 2, then: " + yaml + "}}";
  return yaml;
}

TEST(ReadBehaviourTree, TakesAsManyLevelsAsItSaysAndNoMore) {
  EXPECT_EQ(read("behaviour: " + chain(19, "{do: scan}")).depth(), Tree::deepest);
  const std::string too_deep = said_of_node(chain(20, "{do: scan}"));
  EXPECT_NE(too_deep.find(".do: found 21 levels of nodes, expected at most 20"), std::string::npos)
      << too_deep;
  // Through references, to a tree that was read before and to one that was not.
  const std::string head = "trees:\n  part: " + chain(9, "{do: scan}") + "\n";
  EXPECT_EQ(read(head + "behaviour: " + chain(10, "{tree: part}")).depth(), Tree::deepest);
  const std::string whole = said_of(head + "behaviour: " + chain(11, "{tree: part}"));
  EXPECT_NE(whole.find("made-up.yaml:3: "), std::string::npos) << whole;
  EXPECT_NE(whole.find(".tree: found 21 levels"), std::string::npos) << whole;
  const std::string later = said_of("trees:\n  all: " + chain(11, "{tree: part}") + "\n  part: " +
                                    chain(9, "{do: scan}") + "\nbehaviour: {do: scan}");
  EXPECT_NE(later.find("made-up.yaml:3: "), std::string::npos) << later;
  // The deepest of the widest kind is within the nesting that YAML is read to.
  std::string wide = "{do: scan}";
  for (int i = 0; i < 19; ++i) wide = "{parallel: {success_on: all, of: [" + wide + "]}}";
  EXPECT_EQ(read("behaviour: " + wide).depth(), Tree::deepest);
}

TEST(ReadBehaviourTree, TreesOfTreesDoNotGrowBeyondMeasure) {
  std::string yaml = "trees:\n  t0: {do: scan}\n";
  for (int i = 1; i < 18; ++i) {
    const std::string below = "{tree: t" + std::to_string(i - 1) + "}";
    yaml += "  t" + std::to_string(i) + ": {sequence: [" + below + ", " + below + "]}\n";
  }
  EXPECT_EQ(said_of(yaml + "behaviour: {tree: t17}"),
            "made-up.yaml:11: trees.t9.sequence: found a tree of 1023 nodes, expected at most "
            "1000; those of trees it refers to count each time");
  std::string many = "trees:\n";
  for (int i = 0; i < 101; ++i)
    many += "  t" + std::to_string(i) + ": {tree: t" + std::to_string(i + 1) + "}\n";
  EXPECT_EQ(said_of(many + "behaviour: {tree: t0}"),
            "made-up.yaml:2: trees: found 101 trees, expected at most 100");
}

}  // namespace
}  // namespace slackwater::twin::read_behaviour_tree_test
