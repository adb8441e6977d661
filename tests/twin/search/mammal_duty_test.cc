#include "twin/search/mammal_duty.h"

#include <gtest/gtest.h>

#include "tests/support/shared_data.h"

namespace slackwater::tests::mammal_duty_test {
namespace {

using twin::MammalDuty;
using twin::MammalDutyState;
using twin::NoiseRecord;
using twin::NoiseRule;

MammalDuty porpoises(std::size_t count) {
  MammalDuty duty;
  duty.animal = "harbour_porpoise";
  duty.watch = "observer";
  duty.count = count;
  duty.half_side_m = 1000;
  load(duty, source_folder() / "data");
  return duty;
}

MammalDutyState state_with(std::vector<double> sightings_s, std::vector<double> watched_s,
                           std::vector<double> inside_s = {}) {
  MammalDutyState state;
  state.sightings_s = std::move(sightings_s);
  state.watched_s = std::move(watched_s);
  state.inside_s = std::move(inside_s);
  state.until_s = 5400;
  return state;
}

TEST(NoiseUnderWatch, IsStoppedByWhoeverSeesSomething) {
  const MammalDutyState one = state_with({1000}, {0}), other = state_with({3500}, {0});
  const MammalDutyState* const both[] = {&one, &other};
  const NoiseRecord record = noise_under({500, 1800, 1e6}, both, 5400, 1);
  EXPECT_EQ(record.noisy_s, (std::vector<double>{2800, 3500, 5300}));
  EXPECT_EQ(record.noise_s, 800);
  EXPECT_EQ(record.stops, 1);
  EXPECT_EQ(record.exposed_s, 0);
}

TEST(NoiseUnderWatch, NeedsSomebodyWhoWatches) {
  // One watch goes home for its battery while the other stays out; then both go.
  const MammalDutyState one = state_with({}, {0, 1000, 1500, 3000});
  const MammalDutyState other = state_with({}, {500, 2000});
  const MammalDutyState* const both[] = {&one, &other};
  EXPECT_EQ(noise_under({500, 1800, 1e6}, both, 5400, 1).noise_s, 3001 - 1800);
  const MammalDutyState* const alone[] = {&one};
  EXPECT_EQ(noise_under({500, 1800, 1e6}, alone, 5400, 1).noise_s, 0);
}

TEST(NoiseUnderWatch, CountsWhatWasThereUnseen) {
  const MammalDutyState state = state_with({}, {0}, {100, 200, 2000, 2100, 5390});
  const MammalDutyState* const one[] = {&state};
  EXPECT_EQ(noise_under({500, 1800, 1e6}, one, 5400, 1).exposed_s, 110);
}

TEST(MammalDuty, CarriesTheSameAnimalsAboardEachVehicle) {
  const MammalDuty duty = porpoises(200);
  MammalDutyState a = begin_duty(duty, {100, 200, 0}, 5, "boat");
  MammalDutyState b = begin_duty(duty, {100, 200, 0}, 5, "drone");
  for (int t = 1; t <= 600; ++t) {
    watch_on(duty, 3, {100, 200, 0}, true, t, 1, a);
    watch_on(duty, 3, {400, 200, 0}, t > 300, t, 1, b);
  }
  EXPECT_EQ(a.inside_s, b.inside_s);
  EXPECT_EQ(a.mammals.animals[7].position_m.x, b.mammals.animals[7].position_m.x);
  EXPECT_NE(a.sightings_s, b.sightings_s);
  EXPECT_EQ(a.watched_s, std::vector<double>{0});
  EXPECT_EQ(b.watched_s, std::vector<double>{300});
  ASSERT_FALSE(b.sightings_s.empty());
  EXPECT_GT(b.sightings_s.front(), 300);
}

TEST(MammalDuty, SeesNothingInAStorm) {
  const MammalDuty duty = porpoises(200);
  MammalDutyState calm = begin_duty(duty, {}, 5, "boat"), storm = begin_duty(duty, {}, 5, "boat");
  for (int t = 1; t <= 600; ++t) {
    watch_on(duty, 1, {}, true, t, 1, calm);
    watch_on(duty, 25, {}, true, t, 1, storm);
  }
  EXPECT_GT(calm.sightings_s.size(), 10U);
  EXPECT_TRUE(storm.sightings_s.empty());
  EXPECT_EQ(calm.inside_s, storm.inside_s);
}

}  // namespace
}  // namespace slackwater::tests::mammal_duty_test
