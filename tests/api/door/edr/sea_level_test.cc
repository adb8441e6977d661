// The collection `sea-level`: the level of the forecasts, as the field has it.
#include <cmath>

#include "tests/api/door/edr/edr_service_for_tests.h"
#include "tests/support/made_up_forecast.h"

namespace slackwater::tests::edr_sea_level_test {
namespace {

using nlohmann::json;

constexpr const char* level = "sea_surface_height_above_geoid";

Place column_of(const Field& field, UtcTime time) {
  const GeoPoint& point = field.snapshot().columns.front().point;
  return {point.longitude_deg(), point.latitude_deg(), 0, time};
}

std::string point_text(const Place& place) {
  return "POINT(" + std::to_string(place.longitude_deg) + " " + std::to_string(place.latitude_deg) +
         ")";
}

TEST(EdrSeaLevel, IsTheFieldsOwnAtStampsAndBetween) {
  const auto field = edr_service().in_force("lone");
  for (const auto after : {std::chrono::minutes(0), std::chrono::minutes(150)}) {
    const Place place = column_of(*field, field->snapshot().time.front() + after);
    SeaLevelSample expected;
    field->sample_sea_level({&place, 1}, {&expected, 1});
    const json answer = edr_service().document(
        "/collections/sea-level/position",
        {{"coords", point_text(place)}, {"datetime", format_utc(place.time)}});
    const double rounding_m = 6e-6;  // six digits of about a metre
    EXPECT_NEAR(values_of(answer, level).front(), expected.level_m, rounding_m);
    const SeaLevelQuantiles band = quantiles_of(expected);
    EXPECT_NEAR(values_of(answer, std::string(level) + "_p10").front(), band.p10_m, rounding_m);
    EXPECT_NEAR(values_of(answer, std::string(level) + "_p90").front(), band.p90_m, rounding_m);
    EXPECT_LT(band.p10_m, band.p90_m);
  }
}

TEST(EdrSeaLevel, SaysItsDatumUnitAndSource) {
  const json collection = edr_service().document("/collections/sea-level");
  EXPECT_NE(collection.at("description").get<std::string>().find("mean sea level (the geoid)"),
            std::string::npos);
  const json& parameter = collection.at("parameter_names").at(level);
  EXPECT_EQ(parameter.at("unit").at("symbol").at("value"), "m");
  const auto field = edr_service().in_force("lone");
  const json answer =
      edr_service().document("/collections/sea-level/locations/lone",
                             {{"datetime", format_utc(field->snapshot().time.front())}});
  EXPECT_NE(answer.at("slackwater:provenance").at("notes").dump().find("harmonic tide"),
            std::string::npos);
}

TEST(EdrSeaLevel, HasNoVertical) {
  EXPECT_NE(edr_service()
                .refusal(400, "/collections/sea-level/locations/lone", {{"z", "10"}})
                .find("no vertical"),
            std::string::npos);
}

TEST(EdrSeaLevel, OutsideTheTimeAndThePlaceIsRefusedWithTheRange) {
  const auto field = edr_service().in_force("lone");
  const Place place = column_of(*field, {});
  EXPECT_NE(edr_service()
                .refusal(404, "/collections/sea-level/position",
                         {{"coords", point_text(place)}, {"datetime", "2031-01-01T00:00:00Z"}})
                .find(format_utc(field->snapshot().time.front())),
            std::string::npos);
  EXPECT_NE(edr_service()
                .refusal(404, "/collections/sea-level/position", {{"coords", "POINT(100 0)"}})
                .find("no forecast reaches"),
            std::string::npos);
}

TEST(EdrSeaLevel, AForecastWithoutOneIsRefusedInWords) {
  EdrServiceForTests service;
  MadeUpForecast size;
  size.hours = 6;
  size.members = 2;
  Snapshot dry = made_up_forecast(size);
  dry.site_id = "unlevelled";
  service.issue(dry);
  EXPECT_NE(service.refusal(404, "/collections/sea-level/locations/unlevelled")
                .find("found no sea level in the forecast unlevelled_"),
            std::string::npos);
  EXPECT_EQ(service.get("/collections/currents/locations/unlevelled").status, 200);
}

TEST(EdrSeaLevel, EveryExampleIsAnswered) {
  const json queries = edr_service().document("/collections/sea-level").at("data_queries");
  std::size_t tried = 0;
  for (const auto& [name, query] : queries.items()) {
    const json& link = query.at("link");
    if (!link.contains("slackwater:example")) continue;
    const std::string path = link.at("slackwater:example")
                                 .get<std::string>()
                                 .substr(std::string(edr_service().base).size());
    const std::size_t mark = path.find('?');
    const auto answer = edr_service().get_raw(path.substr(0, mark), path.substr(mark + 1));
    EXPECT_EQ(answer.status, 200) << path << ": " << answer.body.substr(0, 300);
    ++tried;
  }
  EXPECT_EQ(tried, 6U);
}

}  // namespace
}  // namespace slackwater::tests::edr_sea_level_test
