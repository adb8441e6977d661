#pragma once
#include <array>
#include <string>
#include <vector>

#include "twin/mission/tick.h"

namespace slackwater::tests {

/// Leaves that answer what they are told to, and write down what they were asked: "+a" started,
/// "=a" goes on, "-a" halted, "?a" a condition.
struct ScriptedLeaves {
  std::array<twin::NodeStatus, 8> answers{};  ///< of action a, b, ...
  std::array<bool, 8> truths{};               ///< of condition p, q, ...
  std::string calls;

  twin::NodeStatus start(const twin::Leaf& leaf) { return asked('+', 'a', leaf); }
  twin::NodeStatus go_on(const twin::Leaf& leaf) { return asked('=', 'a', leaf); }
  void halt(const twin::Leaf& leaf) { (void)asked('-', 'a', leaf); }
  bool holds(const twin::Leaf& leaf) {
    write('?', 'p', leaf);
    return truths.at(leaf.number);
  }

 private:
  void write(char what, char first, const twin::Leaf& leaf) {
    if (!calls.empty()) calls += ' ';
    calls += what;
    calls += static_cast<char>(first + static_cast<char>(leaf.number));
  }
  twin::NodeStatus asked(char what, char first, const twin::Leaf& leaf) {
    write(what, first, leaf);
    return answers.at(leaf.number);
  }
};

}  // namespace slackwater::tests
