#include "twin/search/datum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shared_data.h"
#include "twin/search/drifter.h"

namespace slackwater::tests::datum_test {
namespace {

using twin::Triple;

twin::LeewayObject object_named(const std::string& name) {
  return twin::read_leeway(name, source_folder() / "data");
}

TEST(Datum, IsWhereAThousandOfThemAreInTheMean) {
  // Half an hour in a current of 0.3 m/s and a wind of 10 m/s. Draws that would drift into the wind
  // are drawn anew, which takes the mean of an upright person downwind a little.
  const Triple<double> current{0.1, 0.3, 0}, wind{6, -8, 0};
  for (const char* name : {"drift_buoy", "life_raft_deep_ballast", "skiff_v_hull"}) {
    const twin::LeewayObject object = object_named(name);
    Rng rng(5, name);
    constexpr int count = 2000;
    double north = 0, east = 0, squares = 0;
    for (int i = 0; i < count; ++i) {
      const twin::Drifter drifter{draw_leeway(object, rng), object.jibe_rate_per_s, 0};
      twin::DrifterState state = twin::begin_drift({}, 0, Rng(static_cast<std::uint64_t>(i), name));
      for (int t = 0; t < 180; ++t) drift(drifter, current, wind, 10, state);
      north += state.position_m.x / count;
      east += state.position_m.y / count;
      squares += dot(state.position_m, state.position_m) / count;
    }
    twin::DatumState datum;
    turn_datum(expected_drift(object, current, wind), 0, datum);
    const Triple<double> mean = datum.drifted_at(1800);
    const double spread_m = std::sqrt(std::max(squares - north * north - east * east, 0.0));
    EXPECT_NEAR(north, mean.x, 4 * spread_m / std::sqrt(count) + 1e-6) << name;
    EXPECT_NEAR(east, mean.y, 4 * spread_m / std::sqrt(count) + 1e-6) << name;
  }
}

TEST(Datum, GoesOnFromWhereItIsWithAnotherDrift) {
  twin::DatumState datum;
  datum.drifted_m = {10, 20, 0};
  turn_datum({1, 0, 0}, 0, datum);
  turn_datum({0, 2, 0}, 30, datum);
  const Triple<double> at = datum.drifted_at(40);
  EXPECT_EQ(at.x, 40);
  EXPECT_EQ(at.y, 40);
}

}  // namespace
}  // namespace slackwater::tests::datum_test
