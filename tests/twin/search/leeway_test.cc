#include "twin/search/leeway.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/support/shared_data.h"
#include "twin/search/drifter.h"

namespace slackwater::tests::leeway_test {
namespace {

using namespace twin;

const std::filesystem::path data_folder = source_folder() / "data";

LeewayObject object_named(const std::string& name) { return read_leeway(name, data_folder); }

/// Towards `course_deg`.
Triple<double> wind_towards(double speed_m_s, double course_deg) {
  const double course = course_deg * constants::pi / 180;
  return {speed_m_s * std::cos(course), speed_m_s * std::sin(course), 0};
}

TEST(Leeway, HasTheNumbersOfTheSheet) {
  // Class PIW-4 at 10 m/s: 17.1 + 1.12 cm/s downwind; 13.6 - 3.30 to the right, or
  // -1.3 - 2.65, that is to the left.
  const LeewayDraw suit = mean_leeway(object_named("person_survival_suit"));
  const Triple<double> right = leeway_velocity(suit, false, wind_towards(10, 0));
  EXPECT_NEAR(right.x, 0.1822, 1e-12);
  EXPECT_NEAR(right.y, 0.1030, 1e-12);
  EXPECT_NEAR(leeway_velocity(suit, true, wind_towards(10, 0)).y, -0.0395, 1e-12);
  // PIW-1 at 20 m/s: 19.2 and 10.8 cm/s.
  const LeewayDraw person = mean_leeway(object_named("person_unknown"));
  EXPECT_NEAR(leeway_velocity(person, false, wind_towards(20, 0)).x, 0.192, 1e-12);
  EXPECT_NEAR(leeway_velocity(person, true, wind_towards(20, 0)).y, -0.108, 1e-12);
}

TEST(Leeway, TurnsWithTheWind) {
  Rng rng(3, "leeway");
  const LeewayDraw drawn = draw_leeway(object_named("life_raft_deep_ballast"), rng);
  const Triple<double> north = leeway_velocity(drawn, false, wind_towards(8, 0));
  for (const double course_deg : {30.0, 90.0, 200.0, 315.0}) {
    const Triple<double> v = leeway_velocity(drawn, false, wind_towards(8, course_deg));
    const double c = std::cos(course_deg * constants::pi / 180);
    const double s = std::sin(course_deg * constants::pi / 180);
    EXPECT_NEAR(v.x, c * north.x - s * north.y, 1e-14);
    EXPECT_NEAR(v.y, s * north.x + c * north.y, 1e-14);
  }
}

TEST(Leeway, OfABuoyWithoutWindageIsNone) {
  Rng rng(4, "leeway");
  const LeewayDraw drawn = draw_leeway(object_named("drift_buoy"), rng);
  const Triple<double> v = leeway_velocity(drawn, true, wind_towards(20, 77));
  EXPECT_EQ(v.x, 0);
  EXPECT_EQ(v.y, 0);
}

TEST(Leeway, SpreadsAtTenMetresPerSecondAsTheSheetSays) {
  const LeewayObject object = object_named("person_survival_suit");
  Rng rng(5, "leeway");
  constexpr int draws = 20000;
  double sum = 0, squares = 0, right = 0, right_squares = 0, left = 0, left_squares = 0;
  for (int i = 0; i < draws; ++i) {
    const LeewayDraw drawn = draw_leeway(object, rng);
    const Triple<double> r = leeway_velocity(drawn, false, wind_towards(10, 0));
    const double l = leeway_velocity(drawn, true, wind_towards(10, 0)).y;
    sum += r.x;
    squares += r.x * r.x;
    right += r.y;
    right_squares += r.y * r.y;
    left += l;
    left_squares += l * l;
  }
  const auto std_of = [](double total, double of_squares) {
    const double mean = total / draws;
    return std::sqrt(of_squares / draws - mean * mean);
  };
  // Of n draws the standard deviation has a relative one of 1/sqrt(2 n): four of them.
  const double tolerance = 4 / std::sqrt(2.0 * draws);
  EXPECT_NEAR(std_of(sum, squares) / 0.0393, 1, tolerance);
  EXPECT_NEAR(std_of(right, right_squares) / 0.0171, 1, tolerance);
  EXPECT_NEAR(std_of(left, left_squares) / 0.0162, 1, tolerance);
  EXPECT_NEAR(sum / draws, 0.1822, 4 * 0.0393 / std::sqrt(draws));
  EXPECT_NEAR(right / draws, 0.1030, 4 * 0.0171 / std::sqrt(draws));
}

TEST(Leeway, NeverRunsFasterIntoAStrongerWind) {
  // The deviation of PIW-1 is so wide that its normal lies below 0 at one draw in eighteen. What is
  // left is a normal cut at -a: its mean is phi(a)/Phi(a) deviations higher.
  const LeewayObject object = object_named("person_unknown");
  Rng rng(6, "leeway");
  constexpr int draws = 20000;
  double sum = 0;
  for (int i = 0; i < draws; ++i) {
    const LeewayDraw drawn = draw_leeway(object, rng);
    ASSERT_GE(drawn.downwind.slope, 0);
    sum += drawn.downwind.slope;
  }
  const double std_slope = 0.12 / 20, a = 0.0096 / std_slope;
  const double above =
      std::exp(-a * a / 2) / std::sqrt(2 * constants::pi) / (0.5 * std::erfc(-a / std::sqrt(2.0)));
  EXPECT_NEAR(sum / draws, 0.0096 + above * std_slope, 4 * std_slope / std::sqrt(draws));
}

TEST(Leeway, NamesWhatThereIsWhereAnObjectIsUnknown) {
  try {
    (void)object_named("person_asleep");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(std::string(error.what()).find("person_survival_suit"), std::string::npos);
  }
}

TEST(Leeway, OfEveryFileIsOneThatDrifts) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder / "leeway")) {
    const LeewayObject object = object_named(entry.path().stem().string());
    // Right goes right and left goes left, on the mean over both sides and winds of 20 m/s.
    const LeewayDraw mean = mean_leeway(object);
    EXPECT_GE(leeway_velocity(mean, false, wind_towards(20, 0)).y,
              leeway_velocity(mean, true, wind_towards(20, 0)).y)
        << object.name;
    ++files;
  }
  EXPECT_GE(files, 12);
}

TEST(Drifter, GoesWithTheWaterAndItsLeeway) {
  const Drifter drifter{mean_leeway(object_named("person_survival_suit")), 0, 0};
  DrifterState state;
  for (int i = 0; i < 600; ++i) drift(drifter, {0.2, -0.1, 0}, wind_towards(10, 0), 1, state);
  EXPECT_NEAR(state.position_m.x, 600 * (0.2 + 0.1822), 1e-9);
  EXPECT_NEAR(state.position_m.y, 600 * (-0.1 + 0.1030), 1e-9);
}

TEST(Drifter, SpreadsByTwoKTOnEachAxis) {
  const Drifter drifter{{}, 0, 0.5};
  constexpr int drifters = 4000;
  double north = 0, east = 0, both = 0;
  for (int i = 0; i < drifters; ++i) {
    DrifterState state;
    state.rng = Rng(static_cast<std::uint64_t>(i), "drifter");
    for (int k = 0; k < 20; ++k) drift(drifter, {}, {}, 5, state);
    north += state.position_m.x * state.position_m.x;
    east += state.position_m.y * state.position_m.y;
    both += state.position_m.x * state.position_m.y;
  }
  const double wanted = 2 * 0.5 * 100;
  // A variance of n normals has a relative standard deviation of sqrt(2/n).
  EXPECT_NEAR(north / drifters / wanted, 1, 4 * std::sqrt(2.0 / drifters));
  EXPECT_NEAR(east / drifters / wanted, 1, 4 * std::sqrt(2.0 / drifters));
  EXPECT_NEAR(both / drifters / wanted, 0, 4 / std::sqrt(drifters));
}

TEST(Drifter, StartsWithinItsRadiusEveryOtherTime) {
  constexpr int drifters = 4000;
  int within = 0, left = 0;
  for (int i = 0; i < drifters; ++i) {
    const DrifterState state =
        begin_drift({100, 50, 0}, 30, Rng(static_cast<std::uint64_t>(i), "drifter"));
    within += std::hypot(state.position_m.x - 100, state.position_m.y - 50) < 30 ? 1 : 0;
    left += state.is_left ? 1 : 0;
  }
  EXPECT_NEAR(within, drifters / 2.0, 4 * std::sqrt(drifters / 4.0));
  EXPECT_NEAR(left, drifters / 2.0, 4 * std::sqrt(drifters / 4.0));
}

TEST(Drifter, JibesAsOftenAsStatedWhateverTheStep) {
  // At a rate r sides differ after t with probability (1 - exp(-2 r t))/2.
  const double rate = 0.04 / 3600, t_s = 6 * 3600;
  const double wanted = 0.5 * (1 - std::exp(-2 * rate * t_s));
  for (const int steps : {6, 72}) {
    constexpr int drifters = 4000;
    int changed = 0;
    for (int i = 0; i < drifters; ++i) {
      DrifterState state;
      state.rng = Rng(static_cast<std::uint64_t>(i), "jibe");
      for (int k = 0; k < steps; ++k) drift({{}, rate, 0}, {}, {}, t_s / steps, state);
      changed += state.is_left ? 1 : 0;
    }
    EXPECT_NEAR(changed, wanted * drifters, 4 * std::sqrt(drifters * wanted)) << steps;
  }
}

TEST(Drifter, IsTheSameOfTheSameSeedAndName) {
  const Drifter drifter{mean_leeway(object_named("person_unknown")), 1e-3, 0.3};
  DrifterState a = begin_drift({}, 20, Rng(9, "person")), b = begin_drift({}, 20, Rng(9, "person"));
  DrifterState other = begin_drift({}, 20, Rng(10, "person"));
  for (int i = 0; i < 100; ++i)
    for (DrifterState* state : {&a, &b, &other})
      drift(drifter, {0.1, 0, 0}, wind_towards(7, 40), 1, *state);
  EXPECT_EQ(a.position_m.x, b.position_m.x);
  EXPECT_EQ(a.is_left, b.is_left);
  EXPECT_NE(a.position_m.x, other.position_m.x);
}

}  // namespace
}  // namespace slackwater::tests::leeway_test
