#include "twin/traffic/laid_track.h"

#include <gtest/gtest.h>

#include "fields/base/check.h"

namespace slackwater::tests::laid_track_test {
namespace {

using namespace twin;

TEST(LaidTrack, GoesFromPlaceToPlaceAtItsSpeed) {
  const std::vector<Triple<double>> places{{0, 0, 0}, {3000, 4000, 0}, {3000, 5000, 0}};
  const Track track = laid_track(places, 5, 100, 0);
  EXPECT_EQ(track.points().front().t_s, 100);
  EXPECT_DOUBLE_EQ(track.points().back().t_s, 100 + 6000.0 / 5);
  for (double t = 100; t <= 1300; t += 7) {
    const TrackState state = track.at(t);
    ASSERT_TRUE(state.is_known()) << t << ": no rule sees a gap";
    const double along = 5 * (t - 100);
    const bool is_second = along >= 5000;
    EXPECT_NEAR(state.position_m.x, is_second ? 3000 : 0.6 * along, 1e-9);
    EXPECT_NEAR(state.position_m.y, is_second ? along - 1000 : 0.8 * along, 1e-9);
    EXPECT_NEAR(std::hypot(state.velocity_m_s.x, state.velocity_m_s.y), 5, 1e-9);
  }
  EXPECT_EQ(track.at(99).status, TrackStatus::before_start);
  EXPECT_EQ(track.at(1301).status, TrackStatus::after_end);
}

TEST(LaidTrack, OnePlaceIsAnAnchorage) {
  const std::vector<Triple<double>> place{{10, -20, 0}};
  const Track track = laid_track(place, 0, 0, 5000);
  for (double t = 0; t <= 5000; t += 50) {
    const TrackState state = track.at(t);
    ASSERT_TRUE(state.is_known()) << t;
    EXPECT_EQ(state.position_m.y, -20);
    EXPECT_EQ(state.velocity_m_s.x, 0);
  }
  EXPECT_EQ(laid_track(place, 0, 100, 50).points().size(), 1U) << "anchors after the end";
}

TEST(LaidTrack, ASpeedIsNeededAndAPlace) {
  const std::vector<Triple<double>> places{{0, 0, 0}, {1, 0, 0}};
  EXPECT_THROW((void)laid_track(places, 0, 0, 0), ContractViolation);
  EXPECT_THROW((void)laid_track({}, 1, 0, 0), ContractViolation);
}

}  // namespace
}  // namespace slackwater::tests::laid_track_test
