// AP50 by cases that can be worked out by hand; beside pycocotools: tests/strangers/detect.py.
#include "api/perception/average_precision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::tests::average_precision_test {
namespace {

using api::Detection;
using api::KindScore;
using api::Label;
using api::overlap;
using api::PixelBox;
using api::score_of_kind;
using api::ScoredPicture;

PixelBox box_at(double left) { return {left, 10, left + 10, 20}; }
Label label_at(double left) { return {"crack", box_at(left), false, {}}; }
Detection find_at(double left, double confidence) { return {"crack", confidence, box_at(left)}; }
double ap(const std::vector<ScoredPicture>& pictures) {
  return score_of_kind(pictures, "crack").average_precision->share;
}

TEST(Overlap, IsTheSharedAreaOfBoth) {
  EXPECT_EQ(overlap(box_at(0), box_at(0)), 1);
  EXPECT_EQ(overlap(box_at(0), box_at(10)), 0) << "an edge has no area";
  EXPECT_DOUBLE_EQ(overlap(box_at(0), box_at(5)), 50.0 / 150);
  EXPECT_DOUBLE_EQ(overlap({0, 0, 10, 10}, {2, 3, 4, 5}), 4.0 / 100);
  EXPECT_EQ(overlap({5, 5, 5, 9}, {5, 5, 5, 9}), 0) << "of nothing";
}

TEST(WithoutDoubles, KeepsTheSurestOfEachKind) {
  const auto kept = api::without_doubles(
      {find_at(0, 0.5), find_at(1, 0.9), {"corrosion", 0.4, box_at(0)}, find_at(30, 0.3)}, 0.5, 10);
  ASSERT_EQ(kept.size(), 3U);
  EXPECT_EQ(kept[0].confidence, 0.9);
  EXPECT_EQ(kept[1].of, "corrosion");
  EXPECT_EQ(kept[2].box, box_at(30));
  EXPECT_EQ(api::without_doubles({find_at(0, 0.5), find_at(30, 0.9)}, 0.5, 1).size(), 1U);
}

TEST(AveragePrecision, IsOneWhereAllIsFoundAndNothingElse) {
  const std::vector<ScoredPicture> pictures{
      {{label_at(0), label_at(50)}, {find_at(0, 0.9), find_at(50, 0.2)}},
      {{label_at(7)}, {find_at(7, 0.5)}}};
  const KindScore score = score_of_kind(pictures, "crack");
  EXPECT_DOUBLE_EQ(score.average_precision->share, 1);
  EXPECT_EQ(score.average_precision->low, 1) << "any pictures drawn say the same";
  EXPECT_EQ(*score.recall, 1);
  EXPECT_EQ(*score.precision, 1);
  EXPECT_FALSE(score.false_alarms_per_100) << "no picture is without a label";
}

TEST(AveragePrecision, OfHalfFoundCountsTheRecallsUpToAHalf) {
  // Recalls 0, 0.01 ... 0.50 at precision 1, above none.
  EXPECT_DOUBLE_EQ(ap({{{label_at(0), label_at(50)}, {find_at(0, 0.9)}}}), 51.0 / 101);
}

TEST(AveragePrecision, FallsByASurerFalseAlarmAndNotByALessSureOne) {
  EXPECT_DOUBLE_EQ(ap({{{label_at(0)}, {find_at(0, 0.5), find_at(90, 0.9)}}}), 0.5);
  EXPECT_DOUBLE_EQ(ap({{{label_at(0)}, {find_at(0, 0.5), find_at(90, 0.1)}}}), 1);
}

TEST(AveragePrecision, TakesTheBestPrecisionAtThatRecallOrAHigherOne) {
  // right, wrong, right of two labels: precision 1 at recall 1/2; 2/3 at 1.
  EXPECT_NEAR(
      ap({{{label_at(0), label_at(50)}, {find_at(0, 0.9), find_at(90, 0.8), find_at(50, 0.7)}}}),
      (51 * 1.0 + 50 * 2.0 / 3) / 101, 1e-12);
}

// What a detector would not tell counts for the precision at recalls beyond its own, there alone.
TEST(AveragePrecision, AsksOfUnsureFindsToo) {
  std::vector<ScoredPicture> pictures{{{label_at(0), label_at(50)}, {find_at(0, 0.9)}},
                                      {{}, {find_at(7, 0.8)}}};
  const KindScore told = score_of_kind(pictures, "crack");
  pictures[0].unsure = {find_at(50, 0.3)};
  pictures[1].unsure = {find_at(70, 0.2)};
  const KindScore with_unsure = score_of_kind(pictures, "crack");
  EXPECT_DOUBLE_EQ(told.average_precision->share, 51.0 / 101);
  EXPECT_NEAR(with_unsure.average_precision->share, (51 + 50 * 2.0 / 3) / 101, 1e-12);
  EXPECT_EQ(told.found, 2U);
  EXPECT_EQ(with_unsure.found, 2U);
  EXPECT_EQ(*with_unsure.recall, 0.5);
  EXPECT_EQ(*with_unsure.precision, 0.5);
  EXPECT_EQ(*with_unsure.false_alarms_per_100, 100);
  EXPECT_EQ(with_unsure.false_alarms_per_100, told.false_alarms_per_100);
}

TEST(AveragePrecision, CountsASecondFindOfALabelAsFalse) {
  const KindScore score = score_of_kind(
      std::vector<ScoredPicture>{{{label_at(0)}, {find_at(0, 0.9), find_at(1, 0.8)}}}, "crack");
  EXPECT_EQ(*score.precision, 0.5);
  EXPECT_EQ(score.average_precision->share, 1);
}

TEST(AveragePrecision, AsksForHalfOfBothInCommon) {
  EXPECT_EQ(ap({{{label_at(0)}, {{"crack", 0.9, {0, 10, 20, 20}}}}}), 1) << "just a half";
  EXPECT_EQ(ap({{{label_at(0)}, {{"crack", 0.9, {0, 10, 20.1, 20}}}}}), 0);
}

TEST(AveragePrecision, LeavesCrowdsOutOfBothCounts) {
  const Label crowd{"crack", {0, 0, 100, 100}, true, {}};
  const KindScore score = score_of_kind(
      std::vector<ScoredPicture>{
          {{crowd, label_at(200)}, {find_at(0, 0.9), find_at(40, 0.8), find_at(200, 0.1)}}},
      "crack");
  EXPECT_EQ(score.labels, 1U);
  EXPECT_EQ(score.found, 1U);
  EXPECT_EQ(score.average_precision->share, 1);
}

TEST(AveragePrecision, IsNothingWithoutLabelsAndZeroWithoutFinds) {
  const KindScore none =
      score_of_kind(std::vector<ScoredPicture>{{{}, {find_at(0, 0.9)}}, {}}, "crack");
  EXPECT_FALSE(none.average_precision);
  EXPECT_FALSE(none.recall);
  EXPECT_EQ(none.false_alarms_per_100, 50) << "one find in two pictures without a label";
  const KindScore blind = score_of_kind(std::vector<ScoredPicture>{{{label_at(0)}, {}}}, "crack");
  EXPECT_EQ(blind.average_precision->share, 0);
  EXPECT_FALSE(blind.precision);
}

TEST(AveragePrecision, HasARangeThatNarrowsWithThePictures) {
  Rng rng(3, "pictures");
  const auto width = [&](int many) {
    std::vector<ScoredPicture> pictures;
    for (int i = 0; i < many; ++i) {
      ScoredPicture one{{label_at(0)}, {}};
      if (rng.uniform() < 0.7) one.found.push_back(find_at(0, rng.uniform()));
      pictures.push_back(one);
    }
    const KindScore score = score_of_kind(pictures, "crack");
    EXPECT_LE(score.average_precision->low, score.average_precision->share);
    EXPECT_GE(score.average_precision->high, score.average_precision->share);
    return score.average_precision->high - score.average_precision->low;
  };
  // A share of 0.7 found at precision 1: AP is that share, its range 2 * 1.96 (0.21 / n)^(1/2).
  EXPECT_NEAR(width(100), 2 * 1.96 * std::sqrt(0.21 / 100), 0.05);
  EXPECT_NEAR(width(1600), 2 * 1.96 * std::sqrt(0.21 / 1600), 0.015);
}

}  // namespace
}  // namespace slackwater::tests::average_precision_test
