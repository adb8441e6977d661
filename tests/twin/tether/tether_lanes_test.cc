// Eight lines at once are the same bits as eight lines one by one.
#define SLACKWATER_KERNEL tether_in_tests
#include "fields/base/numbers/lanes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "fields/base/numbers/random.h"
#include "tests/twin/tether/tether_for_tests.h"

namespace slackwater::twin::tether_lanes_test {
namespace {

using tether_in_tests::Lanes;

/// Every number of `one` goes into a lane of `eight`: both are made of nothing but such.
template <typename Of>
std::size_t numbers_in() {
  return sizeof(Of) / sizeof(double);
}
template <typename Eight, typename One>
Eight gather(const std::vector<One>& ones) {
  static_assert(sizeof(Eight) == Lanes::count * sizeof(One));
  std::vector<double> numbers(Lanes::count * numbers_in<One>());
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    std::vector<double> own(numbers_in<One>());
    std::memcpy(own.data(), &ones[lane], sizeof(One));
    for (std::size_t i = 0; i < own.size(); ++i) numbers[i * Lanes::count + lane] = own[i];
  }
  Eight eight;
  std::memcpy(static_cast<void*>(&eight), numbers.data(), sizeof eight);
  return eight;
}
template <typename One, typename Eight>
std::vector<One> scatter(const Eight& eight) {
  std::vector<double> numbers(Lanes::count * numbers_in<One>());
  std::memcpy(numbers.data(), &eight, sizeof eight);
  std::vector<One> ones(Lanes::count);
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    std::vector<double> own(numbers_in<One>());
    for (std::size_t i = 0; i < own.size(); ++i) own[i] = numbers[i * Lanes::count + lane];
    std::memcpy(static_cast<void*>(&ones[lane]), own.data(), sizeof(One));
  }
  return ones;
}

TEST(TetherLanes, GiveTheBitsOfASingleLine) {
  const Tether tether = tests::fathom();
  Rng random(5, "tests/tether_lanes");
  std::vector<TetherState<double>> states;
  std::vector<TetherEnds<double>> ends;
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    const Triple<double> top{random.normal(), random.normal(), 0.5};
    const Triple<double> at{10 * random.normal(), 10 * random.normal(), 25};
    ends.push_back({top, {0.1 * random.normal(), 0, 0}, at, {0, 0.2 * random.normal(), 0}});
    // One has too little line and parts.
    states.push_back(laid_out(tether, top, at, 60, {1, 0, 0}));
    if (lane == 3) states.back().length_m = 20;
  }
  auto eight = gather<TetherState<Lanes>>(states);
  for (int step = 0; step < 200; ++step) {
    std::vector<WaterAtNodes<double>> water(Lanes::count);
    for (auto& one : water)
      for (auto& v : one.velocity_m_s) v = {random.normal(), random.normal(), 0.1};
    const auto together = pull(tether, eight, gather<TetherEnds<Lanes>>(ends),
                               gather<WaterAtNodes<Lanes>>(water), 0.02);
    const auto pulls = scatter<TetherPull<double>>(together);
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      const auto alone = pull(tether, states[lane], ends[lane], water[lane], 0.02);
      ASSERT_EQ(std::memcmp(&alone, &pulls[lane], sizeof alone), 0) << step << ", lane " << lane;
    }
  }
  EXPECT_EQ(states[3].whole, 0);
  const auto left = scatter<TetherState<double>>(eight);
  EXPECT_EQ(std::memcmp(left.data(), states.data(), left.size() * sizeof left[0]), 0);
}

}  // namespace
}  // namespace slackwater::twin::tether_lanes_test
