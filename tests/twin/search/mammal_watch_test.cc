#include "twin/search/mammal_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::mammal_watch_test {
namespace {

using namespace twin;

constexpr double pi = constants::pi;

MammalWatch watch_named(const std::string& name) {
  return read_mammal_watch(name, source_folder() / "data");
}
MammalKind mammal_named(const std::string& name) {
  return read_mammal(name, source_folder() / "data");
}

TEST(Beaufort, IsThatOfTheScale) {
  // Equivalent speeds of forces 1 to 8, in m/s (WMO scale: 0.8, 2.4, 4.3, 6.7, 9.4, 12.3, 15.5,
  // 18.9).
  const double equivalent[] = {0.8, 2.4, 4.3, 6.7, 9.4, 12.3, 15.5, 18.9};
  for (int force = 1; force <= 8; ++force)
    EXPECT_NEAR(beaufort_force(equivalent[force - 1]), force, 0.04);
  EXPECT_EQ(beaufort_force(0), 0);
}

TEST(MammalWatch, HasTheStatedEffectiveHalfWidth) {
  const CueSight sight{270, 0.4};
  double integral_m = 0;
  for (double r = 0.5; r < 3000; r += 1) integral_m += chance_of_cue(sight, r) / 0.4;
  EXPECT_NEAR(integral_m, 270, 1e-6);
  EXPECT_EQ(chance_of_cue(sight, 0), 0.4);
}

TEST(MammalWatch, NeverSeesFartherInARougherSea) {
  for (const char* name : {"observer", "infrared_camera", "passive_acoustics"}) {
    const MammalWatch watch = watch_named(name);
    EXPECT_EQ(sight_at(watch, 0).half_width_m, watch.by_force[0].half_width_m);
    for (double wind = 0; wind < 25; wind += 0.1)
      for (const double r : {0.0, 50.0, 200.0, 500.0, 1500.0})
        EXPECT_LE(chance_of_cue(sight_at(watch, wind + 0.1), r),
                  chance_of_cue(sight_at(watch, wind), r))
            << name << " " << wind;
    EXPECT_EQ(chance_of_cue(sight_at(watch, 25), 1), 0);
  }
}

TEST(MammalWatch, IsLikelierToNoticeWhatIsNearerForLonger) {
  const CueSight sight{200, 0.25};
  EXPECT_GT(chance_in_watch(sight, 300, 1800, 70), chance_in_watch(sight, 500, 1800, 70));
  EXPECT_GT(chance_in_watch(sight, 500, 3600, 70), chance_in_watch(sight, 500, 1800, 70));
  EXPECT_GT(chance_in_watch(sight, 500, 1800, 40), chance_in_watch(sight, 500, 1800, 70));
  // Everywhere alike it is the Poisson process itself; with few cues, the mean of g over the disc.
  EXPECT_NEAR(chance_in_watch({1e9, 0.3}, 500, 600, 100), 1 - std::exp(-0.3 * 6), 1e-9);
  const double k = pi / 4 / (200.0 * 200.0);
  EXPECT_NEAR(chance_in_watch(sight, 500, 1e-3, 1) / 1e-3,
              0.25 * (1 - std::exp(-k * 250000)) / (k * 250000), 1e-4);
}

TEST(MammalWatch, NoticesAsManyAsItsChanceSays) {
  // Animals that stay where they are, so that the closed form holds: five minutes at force 3.
  Mammals mammals{mammal_named("harbour_porpoise"), 0, 0, 500, 4000};
  mammals.kind.speed_m_s = 0;
  const CueSight sight = watch_named("observer").by_force[3];
  const MammalWatch watch = watch_named("observer");
  MammalsState state = begin_swim(mammals, Rng(5, "mammals"));
  std::vector<char> is_noticed(mammals.count, 0);
  Rng rng(6, "observer");
  for (int t = 0; t < 300; ++t) {
    swim(mammals, 1, state);
    look_for_mammals(watch, sight, {}, state.animals, rng, [&](const Mammal& animal) {
      is_noticed[static_cast<std::size_t>(&animal - state.animals.data())] = 1;
    });
  }
  double within = 0, noticed = 0;
  for (std::size_t i = 0; i < mammals.count; ++i) {
    const Triple<double>& at = state.animals[i].position_m;
    if (std::hypot(at.x, at.y) > 500) continue;
    within += 1;
    noticed += is_noticed[i];
  }
  const double wanted = chance_in_watch(sight, 500, 300, mammals.kind.surfaces_every_s);
  // Within a second there is one surfacing at most: 70 s become 70.5.
  EXPECT_NEAR(noticed / within, wanted, 4 * std::sqrt(wanted * (1 - wanted) / within) + 0.005);
}

TEST(Mammals, StayAsDenseAsTheyWere) {
  const Mammals mammals{mammal_named("harbour_porpoise"), 300, -200, 1000, 2000};
  MammalsState state = begin_swim(mammals, Rng(7, "mammals"));
  double within = 0;
  for (int t = 0; t < 100; ++t) {
    swim(mammals, 20, state);
    within += static_cast<double>(count_within(state, {500, 0, 0}, 400)) / 100;
  }
  // pi 400^2/2000^2 of them; looks twenty seconds apart are nearly one look.
  const double share = pi * 0.16 / 4;
  EXPECT_NEAR(within / 2000, share, 4 * std::sqrt(share / 2000));
}

TEST(Mammals, SurfaceAsOftenAsStatedAndSwimAsFast) {
  Mammals mammals{mammal_named("harbour_porpoise"), 0, 0, 1e6, 500};
  mammals.kind.turns_every_s = 1e6;
  MammalsState state = begin_swim(mammals, Rng(8, "mammals"));
  const MammalsState before = state;
  double surfaced = 0;
  for (int t = 0; t < 200; ++t) {
    swim(mammals, 1, state);
    for (const Mammal& animal : state.animals) surfaced += animal.surfaced;
  }
  const double wanted = 500 * 200 * -std::expm1(-1 / 70.0);
  EXPECT_NEAR(surfaced, wanted, 4 * std::sqrt(wanted));
  const Triple<double> way = state.animals[3].position_m - before.animals[3].position_m;
  EXPECT_NEAR(length_of(way), 0.9 * 200, 1e-6);
}

/// Runs a gate for an hour and a half, with sightings at these seconds.
NoiseGate run_gate(const NoiseRule& rule, const std::vector<int>& seen_s,
                   std::vector<int>* on_s = nullptr) {
  NoiseGate gate;
  for (int t = 1; t <= 5400; ++t) {
    const bool is_seen = std::find(seen_s.begin(), seen_s.end(), t) != seen_s.end();
    const bool was_on = gate.is_on != 0;
    step_noise(rule, t, 1, is_seen, true, gate);
    if (on_s && !was_on && gate.is_on != 0) on_s->push_back(t);
  }
  return gate;
}

TEST(NoiseGate, StartsAfterAWatchWithoutASightingAndNotBefore) {
  std::vector<int> on_s;
  const NoiseGate gate = run_gate({500, 1800, 1e6}, {}, &on_s);
  EXPECT_EQ(on_s, std::vector<int>{1800});
  EXPECT_EQ(gate.noise_s, 3600);
  EXPECT_EQ(gate.stops, 0);
}

TEST(NoiseGate, StopsAtOnceForASightingAndWatchesAnew) {
  std::vector<int> on_s;
  const NoiseGate gate = run_gate({500, 1800, 1e6}, {1000, 3500}, &on_s);
  // A sighting in the first watch puts it off; the second stops the noise.
  EXPECT_EQ(on_s, (std::vector<int>{2800, 5300}));
  EXPECT_EQ(gate.noise_s, 700 + 100);
  EXPECT_EQ(gate.stops, 1);
}

TEST(NoiseGate, EndsWithAsMuchNoiseAsWanted) {
  const NoiseGate gate = run_gate({500, 1800, 600}, {2000});
  EXPECT_EQ(gate.noise_s, 600);
  EXPECT_EQ(gate.is_on, 0);
  EXPECT_EQ(gate.stops, 1);
}

TEST(NoiseGate, DoesNotCountTimeThatNobodyWatches) {
  NoiseGate gate;
  for (int t = 1; t <= 4000; ++t) step_noise({500, 1800, 1e6}, t, 1, false, t > 2100, gate);
  EXPECT_EQ(gate.noise_s, 4000 - 2100 - 1800);
}

}  // namespace
}  // namespace slackwater::tests::mammal_watch_test
