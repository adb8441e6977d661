// What instruments measured as collections: where they stand, at their own times and depths, good
// values alone.
#include <cmath>
#include <fstream>

#include "tests/api/door/edr/stored_products_for_tests.h"
#include "tests/support/point_series_for_tests.h"

namespace slackwater::tests::edr_instruments {
namespace {

using edr_products::day;
using edr_products::midnight;
using edr_products::notes_of;
using edr_products::rounding;
using nlohmann::json;

constexpr const char* mooring = "/collections/instrument-currents-M1";

Horizontal current_at(UtcTime time, double depth_m) {
  const double hour = hours_between(midnight, time);
  return {0.3 + 0.01 * hour, 0.2 - 0.005 * depth_m};
}

/// A profiler at 54 N 6.5 E, every ten minutes of a day. At 02:00 everything at 10 m is bad, at
/// 03:00 nobody checked, at 04:00 it is missing.
PointSeriesForTests profiler() {
  PointSeriesForTests series;
  series.time = stepping_times(day, 1, 10);
  series.depth_m = {4.25, 10, 15.5};
  series.value = [](UtcTime time, double depth_m) {
    const bool is_lost = time == midnight + std::chrono::hours(4) && depth_m == 10;
    return is_lost ? Horizontal(std::nan(""), std::nan("")) : current_at(time, depth_m);
  };
  series.flag = [](UtcTime time, double depth_m) {
    if (depth_m != 10) return 1;
    if (time == midnight + std::chrono::hours(2)) return 4;
    return time == midnight + std::chrono::hours(3) ? 0 : 1;
  };
  return series;
}

class EdrInstruments : public testing::Test {
 protected:
  void with(const PointSeriesForTests& series) {
    service_.with_file(
        write_point_series(folder_ / ("series-" + std::to_string(++files_) + ".nc"), series));
  }
  [[nodiscard]] json asked(const QueryPairs& query, const std::string& of = mooring) const {
    return service_.document(of + "/position", query);
  }
  [[nodiscard]] std::vector<std::string> ids() const {
    std::vector<std::string> ids;
    for (const auto& product : *service_.catalogue()->products) ids.push_back(product.id);
    return ids;
  }
  TemporaryFolder folder_;
  ProductServiceForTests service_;
  int files_ = 0;
};

TEST_F(EdrInstruments, GiveWhatWasMeasuredAtTheirOwnTimesDepthsAndPlace) {
  with(profiler());
  const json answer = asked({{"coords", "POINT(6.51 54.005)"},
                             {"datetime", "2025-03-10T05:00:00Z/2025-03-10T06:00:00Z"}});
  const json& axes = answer.at("domain").at("axes");
  EXPECT_EQ(axes.at("z").at("values"), json::array({4.25, 10.0, 15.5}));
  ASSERT_EQ(axes.at("t").at("values").size(), 7U) << "every ten minutes, both ends";
  EXPECT_EQ(axes.at("x").at("values"), json::array({6.5})) << "where it hangs, not where asked";
  EXPECT_EQ(axes.at("y").at("values"), json::array({54.0}));
  const auto east = values_of(answer, east_current);
  const auto north = values_of(answer, north_current);
  const auto speed = values_of(answer, "sea_water_speed");
  std::size_t i = 0;
  for (int t = 0; t < 7; ++t) {
    for (const double depth_m : {4.25, 10.0, 15.5}) {
      const Horizontal truth = current_at(midnight + std::chrono::minutes(300 + 10 * t), depth_m);
      EXPECT_NEAR(east[i], truth.real(), rounding);
      EXPECT_NEAR(north[i], truth.imag(), rounding);
      EXPECT_NEAR(speed[i], std::abs(truth), rounding);
      ++i;
    }
  }
  EXPECT_FALSE(answer.at("parameters").contains("forecast_period")) << "nothing is forecast";
  const json& from = answer.at("slackwater:provenance");
  EXPECT_EQ(from.at("runs"), json::array({"observation"}));
  const double far_m =
      distance_m(GeoPoint::from_degrees(54.005, 6.51), GeoPoint::from_degrees(54, 6.5));
  EXPECT_NEAR(from.at("distance_m").get<double>(), far_m, 0.5);
  EXPECT_NE(notes_of(answer).find("from the place that was asked about"), std::string::npos);
}

TEST_F(EdrInstruments, OnlyGoodValuesAreGivenAndItIsSaidWhatIsLeftOut) {
  with(profiler());
  const json answer = asked({{"coords", "POINT(6.5 54)"},
                             {"z", "10"},
                             {"datetime", "2025-03-10T01:50:00Z/2025-03-10T04:10:00Z"}});
  const json& east = answer.at("ranges").at(east_current).at("values");
  const json& times = answer.at("domain").at("axes").at("t").at("values");
  ASSERT_EQ(east.size(), times.size());
  for (std::size_t t = 0; t < times.size(); ++t) {
    const std::string time = times[t];
    const bool is_gap = time == "2025-03-10T02:00:00Z" || time == "2025-03-10T03:00:00Z" ||
                        time == "2025-03-10T04:00:00Z";
    EXPECT_EQ(east[t].is_null(), is_gap) << time;
    EXPECT_EQ(answer.at("ranges").at("sea_water_speed").at("values")[t].is_null(), is_gap) << time;
  }
  EXPECT_NE(
      notes_of(answer).find("values of good quality alone; not given: 1 that nobody checked, 1 "
                            "that were rejected, 1 missing"),
      std::string::npos)
      << notes_of(answer);
}

TEST_F(EdrInstruments, ADepthIsAnsweredAtTheNearestOfTheirOwnAndNothingIsMadeUpBetween) {
  with(profiler());
  const QueryPairs at{{"coords", "POINT(6.5 54)"}, {"datetime", "2025-03-10T12:00:00Z"}};
  const auto levels = [&](const std::string& z) {
    QueryPairs query = at;
    query.emplace_back("z", z);
    const json answer = asked(query);
    const json& axes = answer.at("domain").at("axes");
    return std::pair(axes.at("z").at("values"), notes_of(answer));
  };
  EXPECT_EQ(levels("10").first, json::array({10.0}));
  EXPECT_EQ(levels("10").second.find("nearest"), std::string::npos);
  EXPECT_EQ(levels("12").first, json::array({10.0})) << "no mean of 10 and 15.5 m";
  EXPECT_NE(levels("12").second.find("nearest to z"), std::string::npos);
  EXPECT_EQ(levels("9.5,10.5,15").first, json::array({10.0, 15.5})) << "each once";
  EXPECT_EQ(levels("3").first, json::array({4.25}));
  EXPECT_EQ(levels("0/20").first, json::array({4.25, 10.0, 15.5}));
  QueryPairs deep = at;
  deep.emplace_back("z", "60");
  EXPECT_NE(service_.refusal(404, std::string(mooring) + "/position", deep).find("4.25 to 15.5 m"),
            std::string::npos);
}

TEST_F(EdrInstruments, AnInstantInAGapIsRefusedAndOneBetweenTwoIsTheNearest) {
  PointSeriesForTests series = profiler();
  std::erase_if(series.time, [](UtcTime time) {
    return time > midnight + std::chrono::hours(8) && time < midnight + std::chrono::hours(12);
  });
  with(series);
  const std::string in_gap =
      service_.refusal(404, std::string(mooring) + "/position",
                       {{"coords", "POINT(6.5 54)"}, {"datetime", "2025-03-10T10:00:00Z"}});
  EXPECT_NE(in_gap.find("in a gap of the instrument's times, after 2025-03-10T08:00:00Z and before "
                        "2025-03-10T12:00:00Z"),
            std::string::npos)
      << in_gap;
  const json near = asked({{"coords", "POINT(6.5 54)"}, {"datetime", "2025-03-10T06:04:00Z"}});
  EXPECT_EQ(near.at("domain").at("axes").at("t").at("values"),
            json::array({"2025-03-10T06:00:00Z"}));
}

TEST_F(EdrInstruments, AreAskedWithinFiveKilometresAndByTheirName) {
  with(profiler());
  const std::string far =
      service_.refusal(404, std::string(mooring) + "/position", {{"coords", "POINT(7.5 54)"}});
  EXPECT_NE(far.find("too far from the instrument"), std::string::npos) << far;
  EXPECT_NE(far.find("M1 measures at 54.0000 N 6.5000 E"), std::string::npos) << far;
  const json list = service_.document(std::string(mooring) + "/locations");
  ASSERT_EQ(list.at("features").size(), 1U);
  EXPECT_EQ(list.at("features")[0].at("id"), "M1");
  const QueryPairs then{{"datetime", "2025-03-10T05:00:00Z"}};
  const json by_name = service_.document(std::string(mooring) + "/locations/M1", then);
  const json by_place = asked({{"coords", "POINT(6.5 54)"}, {"datetime", "2025-03-10T05:00:00Z"}});
  EXPECT_EQ(by_name.at("ranges"), by_place.at("ranges"));
  // An area holds it or does not: nothing is measured anywhere else.
  const auto area = [](const std::string& west) {
    return QueryPairs{{"coords", "POLYGON((" + west + " 53.9,6.6 53.9,6.6 54.1," + west + " 54.1," +
                                     west + " 53.9))"},
                      {"datetime", "2025-03-10T05:00:00Z"}};
  };
  EXPECT_EQ(service_.document(std::string(mooring) + "/area", area("6.4")).at("ranges"),
            by_place.at("ranges"));
  EXPECT_NE(service_.refusal(404, std::string(mooring) + "/area", area("6.55"))
                .find("an area without the instrument"),
            std::string::npos);
}

TEST_F(EdrInstruments, OfTwoFilesTheLaterIngestedCountsAndWhatItRejectsIsLeftToTheFirst) {
  with(profiler());
  PointSeriesForTests again = profiler();
  again.value = [](UtcTime time, double depth_m) { return 2.0 * current_at(time, depth_m); };
  again.flag = [](UtcTime time, double) { return time < midnight + std::chrono::hours(6) ? 4 : 1; };
  with(again);
  ASSERT_EQ(ids(), std::vector<std::string>{"instrument-currents-M1"}) << "one platform";
  const json answer = asked({{"coords", "POINT(6.5 54)"},
                             {"z", "4.25"},
                             {"datetime", "2025-03-10T05:50:00Z/2025-03-10T06:00:00Z"}});
  const auto east = values_of(answer, east_current);
  EXPECT_NEAR(east.at(0), current_at(midnight + std::chrono::minutes(350), 4.25).real(), rounding);
  EXPECT_NEAR(east.at(1), 2 * current_at(midnight + std::chrono::hours(6), 4.25).real(), rounding);
  EXPECT_EQ(answer.at("slackwater:provenance").at("sources_sha256").size(), 2U);
}

TEST_F(EdrInstruments, KeepTheirNamesWhateverComesLater) {
  with(profiler());
  PointSeriesForTests elsewhere = profiler();
  elsewhere.latitude_deg = 53.5;
  with(elsewhere);
  PointSeriesForTests mast = profiler();
  mast.depth_m.clear();
  with(mast);
  const std::vector<std::string> all = ids();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0], "instrument-currents-M1");
  EXPECT_EQ(all[1].size(), all[0].size() + 7) << "the same name elsewhere: " << all[1];
  EXPECT_EQ(all[2], "instrument-wind-M1");
  EXPECT_EQ(asked({{"coords", "POINT(6.5 54)"}, {"datetime", "2025-03-10T05:00:00Z"}})
                .at("domain")
                .at("axes")
                .at("y")
                .at("values"),
            json::array({54.0}));
  const json document = service_.document("/collections/" + all[2]);
  EXPECT_NE(document.at("description").get<std::string>().find("checked and found good"),
            std::string::npos);
  EXPECT_TRUE(document.at("parameter_names").contains("wind_from_direction"));
}

TEST_F(EdrInstruments, TooMuchAtOnceIsRefusedWithTheLimit) {
  PointSeriesForTests series = profiler();
  series.time = stepping_times(day, 240, 1);
  with(series);
  const std::string said =
      service_.refusal(400, std::string(mooring) + "/position", {{"coords", "POINT(6.5 54)"}});
  EXPECT_NE(said.find("2000000"), std::string::npos) << said;
}

}  // namespace
}  // namespace slackwater::tests::edr_instruments
