#include "fields/wave/sea_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "fields/wave/growth.h"
#include "fields/wave/product_sea.h"
#include "fields/wave/scenario_sea.h"
#include "tests/support/contains.h"

namespace slackwater::sea_state_test {
namespace {

using tests::contains;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string refusal(const std::vector<WavePartition>& partitions) {
  try {
    (void)scenario_sea(partitions, "sea of scenario.yaml");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    return error.message();
  }
  return "nothing was refused";
}

TEST(ScenarioSea, RefusesThePublishedSeaStatesThatCannotExist) {
  // fields/docs/physics.md section 8: seas shipped with a public simulator.
  struct Row {
    double height, period;
    const char* steepness;
  };
  for (const Row& row :
       {Row{4, 4, "0.160"}, Row{8, 7, "0.105"}, Row{0.5, 2, "0.080"}, Row{1.5, 3, "0.107"}}) {
    const std::string message = refusal({{row.height, row.period}});
    EXPECT_TRUE(contains(message, row.steepness)) << message;
    EXPECT_TRUE(contains(message, "the limit is 0.067")) << message;
    EXPECT_TRUE(contains(message, "sea of scenario.yaml, partition 1")) << message;
  }
}

TEST(ScenarioSea, ItsAdviceIsGoodAdvice) {
  const std::string message = refusal({{8, 7}});
  const auto number_after = [&](const std::string& words) {
    return std::stod(message.substr(message.find(words) + words.size()));
  };
  const double height = number_after("lower Hs to ");
  const double period = number_after("lengthen Tp to ");
  EXPECT_NEAR(height, steepest_height_m(7), 0.01);
  EXPECT_EQ(refusal({{height, 7}}), "nothing was refused");
  EXPECT_EQ(refusal({{8, period}}), "nothing was refused");
  EXPECT_NE(refusal({{8, period - 0.1}}), "nothing was refused");
}

TEST(ScenarioSea, RefusesATotalThatIsTooSteepThoughItsPartsAreNot) {
  const WavePartition steep{0.95 * steepest_height_m(7), 7};
  EXPECT_EQ(refusal({steep}), "nothing was refused");
  EXPECT_TRUE(contains(refusal({steep, steep}), "in total"));
  // The limit of a total is that of its highest peak.
  EXPECT_EQ(refusal({{3.0, 12}, {1.0, 5}}), "nothing was refused");
}

TEST(ScenarioSea, RefusesWhatIsNoSea) {
  EXPECT_TRUE(contains(refusal({{-1, 8}}), "significant_height_m = -1"));
  EXPECT_TRUE(contains(refusal({{nan, 8}}), "significant_height_m = nan"));
  EXPECT_TRUE(contains(refusal({{1, 0}}), "peak_period_s = 0"));
  EXPECT_TRUE(
      contains(refusal({{1, std::numeric_limits<double>::infinity()}}), "peak_period_s = inf"));
  EXPECT_TRUE(contains(refusal({{1, 8, 900}}), "from_direction_deg = 900"));
  EXPECT_TRUE(contains(refusal({{1, 8, 0, 0.5}}), "gamma = 0.5"));
  EXPECT_TRUE(contains(refusal({{1, 8, 0, 3.3, -2}}), "spreading_s = -2"));
  EXPECT_EQ(refusal({}), "nothing was refused");  // calm
  EXPECT_EQ(refusal({{0, 8}}), "nothing was refused");
}

TEST(ProductSea, EnergiesAddUpToTheTotalAndNoPartBreaksIfTheTotalCanBeCarried) {
  Rng rng(4, "product_sea");
  int carried = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<WavePartition> parts(1 + static_cast<std::size_t>(rng.uniform(0, 3)));
    double most = 0;
    for (WavePartition& p : parts) {
      p.peak_period_s = rng.uniform(2, 16);
      p.significant_height_m = rng.uniform(0.05, 1.6) * steepest_height_m(p.peak_period_s);
      most += std::pow(steepest_height_m(p.peak_period_s), 2);
    }
    const double total = rng.uniform(0.1, 1.1) * std::sqrt(most);
    const ServedSea served = product_sea(total, parts);
    EXPECT_NEAR(served.sea.significant_height_m() / total, 1, 1e-12);
    if (total > std::sqrt(most)) {
      EXPECT_FALSE(served.warnings.empty());
      continue;
    }
    ++carried;
    for (const WavePartition& p : served.sea.partitions) {
      EXPECT_LE(p.significant_height_m, steepest_height_m(p.peak_period_s) * (1 + 1e-9));
    }
  }
  EXPECT_GT(carried, 1500);
}

TEST(ProductSea, ASoundSeaIsServedAsItIsWithoutAWord) {
  const std::vector<WavePartition> parts{{1.5, 6.5, 240}, {0.8, 12, 300}};
  for (const double total : {std::sqrt(1.5 * 1.5 + 0.8 * 0.8), nan}) {
    const ServedSea served = product_sea(total, parts);
    ASSERT_EQ(served.sea.partitions.size(), 2u);
    EXPECT_NEAR(served.sea.partitions[0].significant_height_m, 1.5, 1e-12);
    EXPECT_NEAR(served.sea.partitions[1].significant_height_m, 0.8, 1e-12);
    EXPECT_TRUE(served.warnings.empty());
  }
  EXPECT_EQ(product_sea(nan, parts).sea.peak_period_s(), 6.5);  // 1.5^2 6.5 > 0.8^2 12
  EXPECT_EQ(product_sea(nan, parts).sea.from_direction_deg(), 240);
}

TEST(ProductSea, ATooSteepPartitionIsLoweredAndItsEnergyGoesToTheOthers) {
  const ServedSea served = product_sea(2.5, std::vector<WavePartition>{{2.0, 4.0}, {1.5, 10.0}});
  EXPECT_NEAR(served.sea.partitions[0].significant_height_m, steepest_height_m(4), 1e-12);
  EXPECT_NEAR(served.sea.partitions[1].significant_height_m,
              std::sqrt(2.5 * 2.5 - std::pow(steepest_height_m(4), 2)), 1e-12);
  ASSERT_EQ(served.warnings.size(), 2u);
  EXPECT_TRUE(contains(served.warnings[0], "wave partition 1: Hs 2 m with Tp 4 s is steeper"));
  EXPECT_TRUE(contains(served.warnings[1], "scaled to the total of 2.5 m"));
}

TEST(ProductSea, ATotalBeyondTheLimitIsServedWithAWarning) {
  const ServedSea served = product_sea(4.0, std::vector<WavePartition>{{4.0, 4.0}});
  EXPECT_NEAR(served.sea.significant_height_m(), 4.0, 1e-12);
  ASSERT_FALSE(served.warnings.empty());
  EXPECT_TRUE(contains(served.warnings.back(), "has a steepness of 0.160"))
      << served.warnings.back();
}

TEST(ProductSea, AbsentPartitionsAreLeftOutAndBrokenOnesTold) {
  const ServedSea absent =
      product_sea(1, std::vector<WavePartition>{{1, 8}, {nan, nan, nan}, {0, 0}});
  EXPECT_EQ(absent.sea.partitions.size(), 1u);
  EXPECT_TRUE(absent.warnings.empty());
  const ServedSea broken = product_sea(1, std::vector<WavePartition>{{1, 8}, {0.5, nan, 20}});
  EXPECT_EQ(broken.sea.partitions.size(), 1u);
  EXPECT_TRUE(contains(broken.warnings.at(0), "partition 2 left out"));
  const ServedSea none = product_sea(1, {});
  EXPECT_TRUE(none.sea.partitions.empty());
  EXPECT_TRUE(contains(none.warnings.at(0), "has no usable partition"));
  EXPECT_TRUE(product_sea(0, {}).warnings.empty());
}

TEST(WavePartition, TakesGammaByTheRuleWhereItIsNotGiven) {
  EXPECT_EQ((WavePartition{4, 8.6}).spectrum().gamma, dnv_gamma(4, 8.6));
  EXPECT_EQ((WavePartition{4, 8.6, 0, 2.0}).spectrum().gamma, 2.0);
}

}  // namespace
}  // namespace slackwater::sea_state_test
