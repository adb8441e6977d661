#include "api/perception/measured_pod.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/support/contains.h"

namespace slackwater::tests::measured_pod_test {
namespace {

using namespace api;

/// Looks at one defect each, labelled about its centre, and what was found in them.
struct Trial {
  LabelledPictures set;
  DetectorScore score;

  explicit Trial(const std::string& kind = "corrosion") {
    score.kinds.push_back({});
    score.kinds.back().of = kind;
  }
  /// @param find  of the box that is found; nothing: none
  void look(double size_m, double detail_m, std::optional<PixelBox> find, bool is_crowd = false) {
    LabelledPicture picture;
    picture.look = LookFacts{1, 5, 0.5, {}};
    picture.look->planted.push_back({score.kinds[0].of, size_m, detail_m, 0.002, 50, 40});
    picture.labels.push_back({score.kinds[0].of, {40, 30, 60, 50}, is_crowd, 0});
    ScoredPicture seen;
    seen.labels = picture.labels;
    if (find) seen.found.push_back({score.kinds[0].of, 0.9, *find});
    set.pictures.push_back(picture);
    score.pictures.push_back(seen);
  }
  [[nodiscard]] MeasuredPod pod() const { return measure_pod(score, set).at(0); }
};

TEST(MeasuredPodOfLooks, IsTheCurveThatTheDetectorHas) {
  // Found by a curve of the size as it is seen, a min(1, 2 mm/detail), half at 30 mm.
  const twin::LogLogisticPod truth{0.03, 2};
  Rng rng(4, "trial");
  Trial trial;
  for (int i = 0; i < 4000; ++i) {
    const double size_m = 0.01 * std::pow(40.0, rng.uniform());
    const double detail_m = 0.001 * std::pow(10.0, rng.uniform());
    const double seen_m = size_m * std::min(1.0, 0.002 / detail_m);
    const bool is_found = rng.uniform() < twin::pod_of(truth, seen_m);
    trial.look(size_m, detail_m,
               is_found ? std::optional<PixelBox>({41, 31, 61, 51}) : std::nullopt);
  }
  const MeasuredPod pod = trial.pod();
  EXPECT_EQ(pod.looked_for, 4000U);
  ASSERT_TRUE(pod.fit.has_value());
  // The tenth of the details is 1.26 mm: told at that, the same curve has x0 of 0.63 as much.
  EXPECT_NEAR(pod.at_detail_m, 0.00126, 0.0001);
  const double detail_m = 0.004;
  for (const double size_m : {0.03, 0.1, 0.3}) {
    const double shrunk_m = size_m * std::min(1.0, pod.at_detail_m / detail_m);
    // Three deviations of a share of some 4 000 looks, spread over the curve.
    EXPECT_NEAR(twin::pod_of(pod.fit->curve, shrunk_m), twin::pod_of(truth, size_m / 2), 0.04);
  }
}

TEST(MeasuredPodOfLooks, CountsAFindAtThePlaceAlone) {
  Trial trial;
  trial.look(0.1, 0.002, PixelBox{40, 30, 60, 50});
  trial.look(0.1, 0.002, PixelBox{0, 0, 20, 20});    // elsewhere: a false alarm
  trial.look(0.1, 0.002, PixelBox{0, 0, 640, 360});  // the picture: no find, and a false alarm
  trial.look(0.1, 0.002, PixelBox{52, 30, 72, 50});  // overlaps, but not the centre
  trial.look(0.1, 0.002, std::nullopt);
  const MeasuredPod pod = trial.pod();
  EXPECT_EQ(pod.looked_for, 5U);
  EXPECT_EQ(pod.found, 1U);
  EXPECT_EQ(pod.false_alarms, 2U);
  EXPECT_DOUBLE_EQ(pod.read_m2, 2.5);
  EXPECT_DOUBLE_EQ(false_alarms_per_100_m2(pod), 80);
  EXPECT_FALSE(pod.fit.has_value());
}

TEST(MeasuredPodOfLooks, LeavesOutWhatTheInspectionCouldNotSee) {
  Trial trial;
  trial.look(0.1, std::numeric_limits<double>::infinity(), std::nullopt);
  trial.look(0.1, 0.002, std::nullopt);
  EXPECT_EQ(trial.pod().looked_for, 1U);
  EXPECT_EQ(trial.pod().not_seen, 1U);
}

TEST(MeasuredPodOfLooks, AFindOfWhatIsTooSmallToTellIsNoFalseAlarm) {
  Trial trial;
  trial.look(0.1, 0.002, PixelBox{20, 10, 80, 70}, true);  // about it, nine times as large
  EXPECT_EQ(trial.pod().false_alarms, 0U);
}

TEST(MeasuredPodOfLooks, TellsHowFarSizesAreOff) {
  // 20 pixels of 2 mm: 40 mm, of a crack its diagonal, 56.6 mm.
  Trial rust, cracks("crack");
  for (const double size_m : {0.05, 0.04}) {
    rust.look(size_m, 0.002, PixelBox{40, 30, 60, 50});
    cracks.look(size_m, 0.002, PixelBox{40, 30, 60, 50});
  }
  EXPECT_NEAR(rust.pod().size_bias, (40.0 / 50 + 1) / 2 - 1, 1e-12);
  EXPECT_NEAR(rust.pod().size_sd, 0.2 / std::sqrt(2.0), 1e-12);
  const double diagonal_m = 0.04 * std::sqrt(2.0);
  EXPECT_NEAR(cracks.pod().size_bias, (diagonal_m / 0.05 + diagonal_m / 0.04) / 2 - 1, 1e-12);
}

TEST(MeasuredPodOfLooks, WantsLooksOfAStage) {
  Trial trial;
  trial.look(0.1, 0.002, std::nullopt);
  trial.set.pictures[0].look.reset();
  try {
    (void)trial.pod();
    FAIL() << "measured what nobody planted";
  } catch (const Error& error) {
    EXPECT_TRUE(contains(error.message(), "slackwater stage")) << error.message();
  }
}

}  // namespace
}  // namespace slackwater::tests::measured_pod_test
