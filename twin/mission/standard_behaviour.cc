#include "twin/mission/standard_behaviour.h"

namespace slackwater::twin {
namespace {

constexpr std::string_view yaml = R"(
trees:
  task:
    guard:
      while: within_limits
      then:
        guard:
          while: link_up
          then:
            guard:
              while: gnss_up
              then: {guard: {while: tether_free, then: {do: carry_on}}}
  mission:
    guard:
      while: reserve_holds
      then:
        guard:
          while: carrier_stays
          then:
            guard:
              while: thrusters_up
              then:
                reactive: true
                fallback:
                  - {tree: task}
                  - {timeout: {after: 30min, then: {do: hold}}}
behaviour:
  fallback:
    - {tree: mission}
    - {do: come_home}
)";

}  // namespace

const LeafNames& conduct_leaves() {
  static const LeafNames names{{"carry_on", "hold", "come_home"},
                               {"within_limits", "reserve_holds", "carrier_stays", "link_up",
                                "gnss_up", "thrusters_up", "tether_free"}};
  return names;
}

const BehaviourTree& standard_behaviour() {
  static const BehaviourTree tree =
      read_behaviour_tree(Config::parse(yaml, "standard behaviour"), conduct_leaves());
  return tree;
}

}  // namespace slackwater::twin
