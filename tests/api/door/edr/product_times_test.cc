// Which time of a stored product answers, and of which run.
#include <array>
#include <fstream>

#include "data/store/layout.h"
#include "ingest/grib/grib_writer.h"
#include "tests/api/door/edr/stored_products_for_tests.h"

namespace slackwater::tests::edr_products {
namespace {

TEST(EdrProductTimes, AnalysesAndRunsAreToldApart) {
  ProductServiceForTests service;
  service.with(current_product(day));
  service.with(forecast_of(day, midnight - std::chrono::hours(12), 0.33));  // its time is analysed
  service.with(forecast_of(day + std::chrono::days(1), midnight, 0.11));
  service.with(forecast_of(day + std::chrono::days(1), midnight + std::chrono::hours(12), 0.22));
  const json answer = service.document(std::string(currents) + "/position",
                                       {{"coords", "POINT(6.5 54)"}, {"z", "5"}});
  const auto period = values_of(answer, "forecast_period");
  const auto east = values_of(answer, east_current);
  ASSERT_EQ(period.size(), 48U);
  for (int hour = 0; hour < 24; ++hour) {
    EXPECT_EQ(period[hour], 0) << "analysed";
    EXPECT_NEAR(east[hour],
                WaterForTests::eastward_m_s({midnight + std::chrono::hours(hour), 5, 54, 6.5}),
                rounding);
  }
  EXPECT_EQ(period[24], 12) << "of the newer run";
  EXPECT_EQ(period[47], 35);
  EXPECT_NEAR(east[30], 0.22, rounding);
  EXPECT_EQ(answer.at("slackwater:provenance").at("runs"),
            json::array({"analysis", "forecast of 2025-03-10T12:00:00Z"}));
}

TEST(EdrProductTimes, MeansSaySo) {
  ProductServiceForTests service;
  service.with(mean_current_product(day, 2, 24));
  const std::string id = service.catalogue()->products->front().id;
  const json answer = service.document("/collections/" + id + "/position",
                                       {{"coords", "POINT(6.5 54)"}, {"z", "0"}});
  EXPECT_EQ(answer.at("domain").at("axes").at("t").at("values"),
            json::array({"2025-03-10T12:00:00Z", "2025-03-11T12:00:00Z"}));
  EXPECT_NE(notes_of(answer).find("means over 24 h"), std::string::npos);
}

TEST(EdrProductTimes, AMeanAnswersForAllOfItsTime) {
  ProductServiceForTests service;
  service.with(monthly_means());
  const std::string path =
      "/collections/" + service.catalogue()->products->front().id + "/position";
  const auto times_of = [&](const std::string& datetime) {
    return service.document(path, {{"coords", "POINT(6.5 54)"}, {"z", "0"}, {"datetime", datetime}})
        .at("domain")
        .at("axes")
        .at("t")
        .at("values");
  };
  const json january = json::array({"2025-01-16T12:00:00Z"});
  const json february = json::array({"2025-02-15T00:00:00Z"});
  EXPECT_EQ(times_of("2025-01-01T00:00:00Z"), january);
  EXPECT_EQ(times_of("2025-01-31T23:00:00Z"), january);
  EXPECT_EQ(times_of("2025-02-01T00:00:00Z"), february) << "of two that meet the later";
  EXPECT_EQ(times_of("2025-02-02T00:00:00Z/2025-02-03T00:00:00Z"), february);
  EXPECT_EQ(times_of("2025-02-01T00:00:00Z/2025-03-01T00:00:00Z"), february);
  EXPECT_EQ(times_of("2025-01-31T00:00:00Z/2025-02-02T00:00:00Z"),
            json::array({january[0], february[0]}));
}

TEST(EdrProductTimes, InAGapNothingIsMadeUp) {
  ProductServiceForTests service;
  ProductForTests product = current_product(day, 48);
  product.time.erase(product.time.begin() + 3, product.time.begin() + 23);
  service.with(product);
  const std::string path = std::string(currents) + "/position";
  const auto at = [](const char* datetime) {
    return QueryPairs{{"coords", "POINT(6.5 54)"}, {"z", "5"}, {"datetime", datetime}};
  };
  for (const char* datetime : {"2025-03-10T02:10:00Z", "2025-03-10T12:00:00Z"}) {
    const std::string refused = service.refusal(404, path, at(datetime));
    EXPECT_NE(refused.find("after 2025-03-10T02:00:00Z and before 2025-03-10T23:00:00Z"),
              std::string::npos)
        << refused;
  }
  EXPECT_EQ(service.get(path, at("2025-03-10T02:00:00Z")).status, 200);
  EXPECT_EQ(service.get(path, at("2025-03-10T23:20:00Z")).status, 200);
}

TEST(EdrProductTimes, DailyInstantsHangTogetherThoughEachHasItsFile) {
  ProductServiceForTests service;
  for (const int i : {0, 1, 2, 3, 4, 9, 10, 11})
    service.with(current_product(day + std::chrono::days(i), 1));
  const std::string path = std::string(currents) + "/position";
  const auto at = [](const char* datetime) {
    return QueryPairs{{"coords", "POINT(6.5 54)"}, {"z", "5"}, {"datetime", datetime}};
  };
  for (const auto& [asked, given] : {std::pair{"2025-03-12T07:00:00Z", "2025-03-12T00:00:00Z"},
                                     std::pair{"2025-03-12T17:00:00Z", "2025-03-13T00:00:00Z"},
                                     std::pair{"2025-03-10T01:00:00Z", "2025-03-10T00:00:00Z"},
                                     std::pair{"2025-03-20T23:00:00Z", "2025-03-21T00:00:00Z"}}) {
    const json answer = service.document(path, at(asked));
    EXPECT_EQ(answer.at("domain").at("axes").at("t").at("values"), json::array({given})) << asked;
    EXPECT_NE(notes_of(answer).find("between the product's times"), std::string::npos);
  }
  for (const char* asked : {"2025-03-14T03:00:00Z", "2025-03-18T20:00:00Z"}) {
    EXPECT_NE(service.refusal(404, path, at(asked))
                  .find("after 2025-03-14T00:00:00Z and before 2025-03-19T00:00:00Z"),
              std::string::npos)
        << asked;
  }
}

TEST(EdrProductTimes, ADamagedDayHasNoValuesOfTheNext) {
  ProductServiceForTests service;
  for (int i = 0; i < 3; ++i) service.with(current_product(day + std::chrono::days(i)));
  for (const auto& row : service.catalogue()->products->front().granules) {
    if (*row.first_time != midnight + std::chrono::days(1)) continue;
    std::ofstream(store::content_file(service.store(), row.content_sha256), std::ios::app) << "x";
  }
  const std::string refused = service.refusal(
      404, std::string(currents) + "/position",
      {{"coords", "POINT(6.5 54)"}, {"z", "5"}, {"datetime", "2025-03-11T13:00:00Z"}});
  EXPECT_NE(refused.find("after 2025-03-10T23:00:00Z and before 2025-03-12T00:00:00Z"),
            std::string::npos)
      << refused;
  EXPECT_NE(refused.find("1 stored file, damaged"), std::string::npos) << refused;
}

TEST(EdrProductTimes, OfAnEnsembleTheMeanIsGivenAndSaysSo) {
  constexpr std::array<double, 3> member_m_s{1, 2, 6};
  std::vector<ingest::GribField> fields;
  for (std::size_t member = 0; member < member_m_s.size(); ++member) {
    for (const int step : {0, 3, 6}) {
      for (const char* name : {"10u", "10v"}) {
        ingest::GribField field{
            name, midnight, step, static_cast<int>(member + 1), {53.5, 54, 54.5}, {6, 6.5, 7}, {}};
        field.values.assign(9, member_m_s[member] + step);
        fields.push_back(std::move(field));
      }
    }
  }
  const TemporaryFolder folder;
  ingest::write_grib(folder / "ensemble.grib2", fields, 2, true);
  ProductServiceForTests service;
  service.with_file(folder / "ensemble.grib2");
  ASSERT_EQ(service.catalogue()->products->size(), 1U);
  const json answer =
      service.document("/collections/" + service.catalogue()->products->front().id + "/position",
                       {{"coords", "POINT(6.5 54)"}});
  const auto east = values_of(answer, "eastward_wind");
  ASSERT_EQ(east.size(), 3U);
  for (std::size_t i = 0; i < east.size(); ++i)
    EXPECT_NEAR(east[i], 3 + 3 * static_cast<double>(i), rounding) << i;
  EXPECT_EQ(values_of(answer, "forecast_period"), (std::vector<double>{0, 3, 6}));
  EXPECT_NE(notes_of(answer).find("means of 3 members of an ensemble"), std::string::npos);
}

TEST(EdrProductTimes, ManyRunsAreCountedInTheHeader) {
  ProductServiceForTests service;
  service.with(current_product(day));
  for (int i = 1; i < 10; ++i) {
    const UtcTime run = midnight + std::chrono::days(i) - std::chrono::hours(12);
    service.with(forecast_of(day + std::chrono::days(i), run, 0.1));
  }
  const auto csv = service.get(std::string(currents) + "/position",
                               {{"coords", "POINT(6.5 54)"}, {"z", "5"}, {"f", "CSV"}});
  ASSERT_EQ(csv.status, 200) << csv.body;
  const auto runs = std::find_if(csv.headers.begin(), csv.headers.end(), [](const auto& header) {
    return header.first == "Slackwater-Runs";
  });
  ASSERT_NE(runs, csv.headers.end());
  EXPECT_EQ(runs->second, "analysis; 9 forecasts, 2025-03-10T12:00:00Z to 2025-03-18T12:00:00Z");
}

}  // namespace
}  // namespace slackwater::tests::edr_products
