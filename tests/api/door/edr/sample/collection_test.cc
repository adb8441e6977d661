#include "api/door/edr/sample/collection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <set>

#include "tests/support/made_up_forecast.h"

namespace slackwater::api::edr::collection_test {
namespace {

constexpr std::size_t members = 3;

Field made_up_field() {
  tests::MadeUpForecast size;
  size.members = members;
  Snapshot made = tests::made_up_forecast(size);
  tests::add_made_up_level(made);
  return Field(std::make_shared<const Snapshot>(std::move(made)));
}

/// In the water, at each stamp of the forecast.
std::vector<Place> places_in(const Field& field) {
  const GeoPoint& point = field.snapshot().columns.front().point;
  std::vector<Place> places;
  for (const UtcTime time : field.snapshot().time)
    places.push_back({point.longitude_deg(), point.latitude_deg(), 10, time});
  return places;
}

std::vector<std::size_t> all_of(const Collection& collection) {
  std::vector<std::size_t> all(parameters_of(collection, members).size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::vector<std::vector<double>> sampled(const std::string& id,
                                         const std::vector<std::size_t>& selected) {
  const Field field = made_up_field();
  std::vector<std::vector<double>> values;
  Absences absences;
  sample(collection_named(id), field, selected, places_in(field), values, absences);
  return values;
}

TEST(Collection, EveryParameterIsNamedOnceAndWhole) {
  for (const Collection& collection : collections()) {
    std::set<std::string> names;
    for (const Parameter& p : parameters_of(collection, members)) {
      EXPECT_TRUE(names.insert(p.name).second) << p.name;
      EXPECT_TRUE(p.name.starts_with(p.standard_name)) << p.name;
      EXPECT_TRUE(!p.label.empty() && !p.unit.empty() && !p.unit_label.empty()) << p.name;
      EXPECT_EQ(p.name.find("_member_") != std::string::npos, collection.is_of_members) << p.name;
    }
    EXPECT_FALSE(names.empty()) << collection.id;
  }
}

TEST(Collection, SpeedAndDirectionAreThoseOfTheComponents) {
  const double degrees = 180 / std::acos(-1.0);
  for (const auto& [id, turn_deg] : {std::pair{"currents", 0.0}, {"wind", 180.0}}) {
    const auto values = sampled(id, {0, 1, 2, 3});
    for (std::size_t i = 0; i < values[0].size(); ++i) {
      const double east = values[0][i];
      const double north = values[1][i];
      EXPECT_DOUBLE_EQ(values[2][i], std::hypot(east, north)) << id;
      const double off_deg = values[3][i] - turn_deg - std::atan2(east, north) * degrees;
      EXPECT_NEAR(std::remainder(off_deg, 360), 0, 1e-9) << id << ": to, or from, north by east";
      EXPECT_TRUE(values[3][i] >= 0 && values[3][i] <= 360) << id << " " << values[3][i];
    }
  }
}

TEST(Collection, TheFirstMemberIsTheCentralForecast) {
  EXPECT_EQ(sampled("currents-members", {0, 1}), sampled("currents", {0, 1}));
  EXPECT_EQ(sampled("wind-members", {0, 1}), sampled("wind", {0, 1}));
  EXPECT_NE(sampled("currents-members", {2, 3}), sampled("currents", {0, 1}));
}

TEST(Collection, AnyChoiceInAnyOrderHasTheValuesOfTheWhole) {
  for (const Collection& collection : collections()) {
    const std::vector<std::size_t> all = all_of(collection);
    const auto whole = sampled(collection.id, all);
    const auto turned = sampled(collection.id, {all.rbegin(), all.rend()});
    for (const std::size_t i : all) {
      EXPECT_EQ(turned[all.size() - 1 - i], whole[i]) << collection.id << " " << i;
      EXPECT_EQ(sampled(collection.id, {i}).front(), whole[i]) << collection.id << " " << i;
    }
  }
}

TEST(Collection, APlaceWithoutValuesIsNaNInAllAndCountedOnce) {
  const Field field = made_up_field();
  std::vector<Place> places = places_in(field);
  places.resize(2);
  places[1].latitude_deg += 40;
  for (const Collection& collection : collections()) {
    const std::vector<std::size_t> all = all_of(collection);
    std::vector<std::vector<double>> values;
    Absences absences;
    sample(collection, field, all, places, values, absences);
    for (const auto& series : values) {
      EXPECT_FALSE(std::isnan(series[0])) << collection.id;
      EXPECT_TRUE(std::isnan(series[1])) << collection.id;
    }
    EXPECT_EQ(absences.count[static_cast<std::size_t>(SampleStatus::outside_area)],
              collection.is_of_members ? all.size() : 1)
        << collection.id << ": of members once a value";
  }
}

}  // namespace
}  // namespace slackwater::api::edr::collection_test
