#include "twin/search/search_lookout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::search_lookout_test {
namespace {

using twin::DetectionLaw;
using twin::SearchLookout;
using twin::SightConditions;
using twin::Triple;

constexpr double pi = constants::pi;

SearchLookout lookout_named(const std::string& name, const std::string& object) {
  return twin::read_search_lookout(name, object, source_folder() / "data");
}

/// Of a straight pass along x at a lateral range, `reach_m` to both sides in steps.
double pass_exposure(DetectionLaw law, double width_m, double lateral_m, double reach_m,
                     int steps) {
  double sum = 0;
  const double step_m = 2 * reach_m / steps;
  for (int i = 0; i < steps; ++i) {
    const Triple<double> from{-reach_m + i * step_m, lateral_m, 0};
    sum += twin::look_exposure(law, width_m, from, {from.x + step_m, lateral_m, 0}, 1);
  }
  return sum;
}

TEST(SearchLookout, PassesByTheInverseCubeLawAddUpToItsSweepWidth) {
  // Lateral ranges far beyond W by the tail 1 - exp(-c) = c with c = W^2/(4 pi x^2).
  const double width_m = 500, last_m = 20 * width_m, step_m = 0.5;
  double area_m = 0;
  for (double x = step_m / 2; x < last_m; x += step_m)
    area_m +=
        2 * step_m * -std::expm1(-pass_exposure(DetectionLaw::inverse_cube, width_m, x, 4e5, 4));
  area_m += 2 * width_m * width_m / (4 * pi * last_m);
  EXPECT_NEAR(area_m / width_m, 1, 1e-4);
}

TEST(SearchLookout, StretchesAddUpHoweverTheyAreCut) {
  for (const double lateral_m : {0.01, 3.0, 250.0}) {
    const double whole = pass_exposure(DetectionLaw::inverse_cube, 300, lateral_m, 1000, 1);
    for (const int steps : {2, 7, 1000})
      EXPECT_NEAR(pass_exposure(DetectionLaw::inverse_cube, 300, lateral_m, 1000, steps) / whole, 1,
                  1e-9)
          << lateral_m;
  }
  // Straight ahead it never passes: the integral of 1/s^3.
  const double m = 300.0 * 300.0 / (8 * pi);
  EXPECT_NEAR(twin::look_exposure(DetectionLaw::inverse_cube, 300, {200, 0, 0}, {100, 0, 0}, 1),
              m * 0.5 * (1 / 1e4 - 1 / 4e4), 1e-9);
}

TEST(SearchLookout, LooksOutWhereItStaysAndHoweverItLies) {
  const double stays =
      twin::look_exposure(DetectionLaw::inverse_cube, 300, {80, 60, 0}, {80, 60, 0}, 2);
  EXPECT_NEAR(stays, 300.0 * 300.0 / (8 * pi) * 0.5 * 2 / 1e6, 1e-12);
  // As much as one who creeps.
  EXPECT_NEAR(
      twin::look_exposure(DetectionLaw::inverse_cube, 300, {80, 60, 0}, {80.001, 60.001, 0}, 2) /
          stays,
      1, 1e-3);
  const double a =
      twin::look_exposure(DetectionLaw::inverse_cube, 300, {80, 60, 0}, {70, 65, 0}, 1);
  EXPECT_NEAR(twin::look_exposure(DetectionLaw::inverse_cube, 300, {-60, 80, 0}, {-65, 70, 0}, 1),
              a, 1e-12);
  EXPECT_NEAR(twin::look_exposure(DetectionLaw::inverse_cube, 300, {70, 65, 0}, {80, 60, 0}, 1), a,
              1e-12);
}

/// P of a target between two of many parallel lines, by the exposure of all of them.
double parallel_sweeps(DetectionLaw law, double width_m, double spacing_m) {
  constexpr int places = 200, lines = 200;
  double sum = 0;
  for (int i = 0; i < places; ++i) {
    const double x = spacing_m * (i + 0.5) / places;
    double exposure = 0;
    for (int k = -lines; k <= lines; ++k)
      exposure += pass_exposure(law, width_m, x + k * spacing_m, 1e6, 1);
    sum += -std::expm1(-exposure) / places;
  }
  return sum;
}

TEST(SearchLookout, FindsInParallelSweepsWhatTheInverseCubeLawSays) {
  // Koopman: P = erf(sqrt(pi)/2 W/S). Lines left out take W^2/(4 pi S^2) 2/201 of the exposure.
  for (const double coverage : {0.25, 0.5, 1.0, 1.5})
    EXPECT_NEAR(parallel_sweeps(DetectionLaw::inverse_cube, coverage * 400, 400),
                std::erf(std::sqrt(pi) / 2 * coverage), 2e-3)
        << coverage;
}

TEST(SearchLookout, FindsInParallelSweepsAllWithinADefiniteRange) {
  for (const double coverage : {0.25, 0.5, 1.0, 1.5})
    EXPECT_NEAR(parallel_sweeps(DetectionLaw::definite_range, coverage * 400, 400),
                std::min(1.0, coverage), 0.5 / 200 + 1e-12)
        << coverage;
}

TEST(SearchLookout, FindsInARandomSearchWhatKoopmanSays) {
  // Straight stretches anywhere in any direction in an area that goes on on the other side: P = 1 -
  // exp(-W L/A). The ends of a stretch of length l add pi W/(4 l) to what it covers by a definite
  // range.
  constexpr double area_m = 1000, width_m = 20, stretch_m = 500;
  constexpr int trials = 1500;
  for (const auto law : {DetectionLaw::definite_range, DetectionLaw::inverse_cube}) {
    for (const double coverage : {0.5, 1.0}) {
      const int stretches = static_cast<int>(coverage * area_m * area_m / (width_m * stretch_m));
      Rng rng(21, "random search");
      int found = 0;
      for (int i = 0; i < trials; ++i) {
        bool is_found = false;
        for (int k = 0; k < stretches && !is_found; ++k) {
          const double north = rng.uniform(0, area_m), east = rng.uniform(0, area_m);
          const double course = rng.uniform(0, 2 * pi);
          double exposure = 0;
          for (int copy = 0; copy < 9; ++copy) {
            const Triple<double> from{north + area_m * (copy / 3 - 1),
                                      east + area_m * (copy % 3 - 1), 0};
            exposure += twin::look_exposure(
                law, width_m, from,
                {from.x + stretch_m * std::cos(course), from.y + stretch_m * std::sin(course), 0},
                100);
          }
          is_found = twin::detected(exposure, rng);
        }
        found += is_found ? 1 : 0;
      }
      const double ends = law == DetectionLaw::definite_range ? pi * width_m / (4 * stretch_m) : 0;
      const double wanted = 1 - std::exp(-coverage * (1 + ends));
      EXPECT_NEAR(found, trials * wanted, 4 * std::sqrt(trials * wanted * (1 - wanted)))
          << coverage;
    }
  }
}

TEST(SearchLookout, HasTheWidthsOfTheTable) {
  // Eyes at 8 ft, a person at 5 nautical miles of visibility: 0.3; a raft of four at 10: 3.1; at 14
  // ft 0.5 and 4.0.
  constexpr double mile_m = 1852;
  EXPECT_NEAR(sweep_width_m(lookout_named("small_boat", "person"), {2, 0.3, 5 * mile_m}),
              0.3 * mile_m, 1);
  EXPECT_NEAR(sweep_width_m(lookout_named("small_boat", "life_raft"), {2, 0.3, 10 * mile_m}),
              3.1 * mile_m, 1);
  EXPECT_NEAR(sweep_width_m(lookout_named("crew_vessel", "person"), {2, 0.3, 5 * mile_m}),
              0.5 * mile_m, 1);
  EXPECT_NEAR(sweep_width_m(lookout_named("crew_vessel", "life_raft"), {2, 0.3, 10 * mile_m}),
              4.0 * mile_m, 1);
  // Halved from 15 knots on, again from 25.
  EXPECT_NEAR(sweep_width_m(lookout_named("small_boat", "person"), {10, 0.3, 5 * mile_m}),
              0.15 * mile_m, 1);
  EXPECT_NEAR(sweep_width_m(lookout_named("small_boat", "person"), {2, 2.0, 5 * mile_m}),
              0.075 * mile_m, 1);
}

TEST(SearchLookout, NeverSeesFartherInWorseWeather) {
  for (const char* name : {"small_boat", "crew_vessel", "usv_camera", "drone_camera"})
    for (const char* object : {"person", "life_raft", "boat"}) {
      const SearchLookout lookout = lookout_named(name, object);
      for (double wind = 0; wind < 20; wind += 1.7)
        for (double waves = 0; waves < 4; waves += 0.37)
          for (double visibility = 100; visibility < 5e4; visibility *= 1.5) {
            const double width_m = sweep_width_m(lookout, {wind, waves, visibility});
            EXPECT_GT(width_m, 0);
            EXPECT_LE(sweep_width_m(lookout, {wind + 0.9, waves, visibility}), width_m);
            EXPECT_LE(sweep_width_m(lookout, {wind, waves + 0.2, visibility}), width_m);
            EXPECT_LE(sweep_width_m(lookout, {wind, waves, visibility * 0.9}), width_m);
          }
      EXPECT_EQ(sweep_width_m(lookout, {0, 0, 0}), 0);
    }
}

TEST(SearchLookout, SaysWhatItCanLookFor) {
  try {
    (void)lookout_named("small_boat", "whale");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(std::string(error.what()).find("person"), std::string::npos);
  }
}

}  // namespace
}  // namespace slackwater::tests::search_lookout_test
