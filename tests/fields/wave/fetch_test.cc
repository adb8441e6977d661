#include "fields/wave/fetch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/numbers/random.h"

namespace slackwater::fetch_test {
namespace {

TEST(Fetch, OfOneNumberIsTheSameFromAllSides) {
  const Fetch fetch(200e3);
  for (const double from : {-90.0, 0.0, 179.9, 359.999, 360.0, 725.0})
    EXPECT_EQ(fetch.at_m(from), 200e3) << from;
  EXPECT_EQ(fetch.text(), "200 km");
  EXPECT_EQ(fetch, Fetch({{0, 360, 200e3}}));
}

TEST(Fetch, ASectorHoldsFromItsFirstDirectionToJustBeforeItsLast) {
  const Fetch fetch({{200, 320, 400e3}, {320, 200, 5e3}});
  EXPECT_EQ(fetch.at_m(200), 400e3);
  EXPECT_EQ(fetch.at_m(319.999), 400e3);
  for (const double land : {320.0, 359.0, 0.0, 90.0, 199.999, 360.0, -1.0})
    EXPECT_EQ(fetch.at_m(land), 5e3) << land << ": through north";
  EXPECT_EQ(fetch.shortest_m(), 5e3);
  EXPECT_EQ(fetch.longest_m(), 400e3);
  EXPECT_EQ(fetch.text(), "5 to 400 km by the direction of the wind");
}

TEST(Fetch, TurningTheSectorsTurnsTheAnswer) {
  Rng random(4, "tests/fetch");
  for (int i = 0; i < 200; ++i) {
    const double turn = random.uniform(0, 360);
    const Fetch fetch({{10, 100, 1e3}, {100, 250, 2e3}, {250, 10, 3e3}});
    const Fetch turned({{10 + turn, 100 + turn, 1e3},
                        {100 + turn, 250 + turn, 2e3},
                        {250 + turn, 10 + turn, 3e3}});
    const double from = std::floor(random.uniform(0, 360)) + 0.5;  // never on an edge
    EXPECT_EQ(turned.at_m(from + turn), fetch.at_m(from)) << from << " by " << turn;
  }
}

TEST(Fetch, TwiceAsLongIsSoFromEverySide) {
  const Fetch fetch({{0, 180, 10e3}, {180, 360, 70e3}});
  EXPECT_EQ(fetch.times(2), Fetch({{0, 180, 20e3}, {180, 360, 140e3}}));
}

std::string refusal(std::vector<FetchSector> sectors) {
  try {
    (void)Fetch(std::move(sectors));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    return error.message();
  }
  return "accepted";
}

TEST(Fetch, EveryDirectionHasOneFetchElseItSaysWhichHasNot) {
  EXPECT_EQ(refusal({{200, 320, 1e3}}).find("found no fetch for wind from 320 to 200 degrees"), 0U)
      << refusal({{200, 320, 1e3}});
  EXPECT_EQ(refusal({{0, 90, 1e3}, {90, 180, 1e3}, {270, 360, 1e3}})
                .find("found no fetch for wind from 180 to 270 degrees"),
            0U);
  EXPECT_EQ(refusal({{0, 200, 1e3}, {180, 360, 1e3}})
                .find("found two fetches for wind from 180 to 200 degrees"),
            0U);
  EXPECT_EQ(refusal({{0, 360, 1e3}, {10, 20, 1e3}})
                .find("found two fetches for wind from 10 to 20 degrees"),
            0U);
  EXPECT_NE(refusal({{90, 90, 1e3}}).find("two different directions"), std::string::npos);
  EXPECT_NE(refusal({}).find("no sector"), std::string::npos);
}

TEST(Fetch, NothingIsNoFetch) {
  EXPECT_THROW((void)Fetch(0), ContractViolation);
  EXPECT_THROW((void)Fetch({{0, 360, -1}}), ContractViolation);
  EXPECT_THROW((void)Fetch(1e3).times(0), ContractViolation);
}

}  // namespace
}  // namespace slackwater::fetch_test
