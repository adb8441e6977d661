#pragma once
// Eight lanes of the instruction set that the tests are built for, for formulas written over
// `Real`.
#define SLACKWATER_KERNEL lanes_of_tests
#include "fields/base/numbers/lanes.h"

namespace slackwater::tests {

using Lanes = slackwater::lanes_of_tests::Lanes;

[[nodiscard]] inline Lanes lanes_of(const double (&value)[Lanes::count]) {
  return Lanes::load(value);
}
[[nodiscard]] inline double lane_of(const Lanes& lanes, std::size_t i) {
  double value[Lanes::count];
  lanes.store(value);
  return value[i];
}

}  // namespace slackwater::tests
