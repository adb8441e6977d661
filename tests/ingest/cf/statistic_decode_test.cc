#include <gtest/gtest.h>

#include "ingest/cf/cell_methods.h"
#include "tests/ingest/cf/tiny_product.h"
#include "tests/support/contains.h"

namespace slackwater::ingest::statistic_decode_test {
namespace {

using netcdf::Type;
using netcdf::Writer;
using slackwater::ingest::tests::decode;
using slackwater::ingest::tests::Decoded;
using slackwater::ingest::tests::refusal_of;
using slackwater::ingest::tests::TinyProduct;
using slackwater::tests::contains;

TinyProduct that_says(const std::string& attribute, const std::string& text) {
  TinyProduct product;
  product.more = [=](Writer& writer, int variable, const std::map<std::string, int>&) {
    writer.attribute(variable, attribute, text);
    return nullptr;
  };
  return product;
}

TEST(CellMethods, AreReadAsCfWritesThem) {
  const auto entries = cell_methods_of(
      "area: mean where sea time:maximum within days (interval: 1 hour comment: a: b) time: mean "
      "over days lat: lon: Standard_Deviation");
  ASSERT_EQ(entries.size(), 4U);
  EXPECT_EQ(entries[0].method, "mean");
  EXPECT_FALSE(entries[0].is_climatology);
  EXPECT_EQ(entries[1].axes, std::vector<std::string>{"time"});
  EXPECT_EQ(entries[1].method, "maximum");
  EXPECT_TRUE(entries[1].is_climatology);
  EXPECT_TRUE(entries[2].is_climatology);
  EXPECT_EQ(entries[3].axes, (std::vector<std::string>{"lat", "lon"}));
  EXPECT_EQ(entries[3].method, "standard_deviation");
}

TEST(StatisticOfAQuantity, IsRefusedByItsCellMethods) {
  const std::map<std::string, std::string> refused{
      {"time: maximum", "maximum over time"},
      {"time: minimum (interval: 1 hour)", "minimum over time"},
      {"time:standard_deviation", "standard deviation over time"},
      {"realization: standard_deviation", "standard deviation over the members"},
      {"realization: percentile", "percentile over the members"},
      {"realization: variance time: mean", "variance over the members"},
      {"time: root_mean_square", "root mean square over time"},
      {"area: maximum time: mean", "maximum over area"},
      {"time: mean within years time: mean over years", "climatology"},
      {"time: sum", "sum over time"}};
  for (const auto& [methods, words] : refused) {
    const std::string why = refusal_of(that_says("cell_methods", methods));
    EXPECT_TRUE(contains(why, "'uo' (eastward_sea_water_velocity): " + words)) << why;
    EXPECT_TRUE(contains(why, "expected instants or means")) << why;
  }
  for (const char* methods : {"time: point", "area: mean", "area: mean where sea time: mean",
                              "time: mean (interval: 300 s)", "depth: point time: instantaneous"})
    EXPECT_EQ(refusal_of(that_says("cell_methods", methods)), "nothing was thrown") << methods;
}

TEST(StatisticOfAQuantity, IsRefusedByNamesThatSaySo) {
  for (const char* name : {"uo_std", "uo_spread", "max_uo", "uo_p90", "uo_error", "uo_min"}) {
    TinyProduct product;
    product.name = name;
    EXPECT_TRUE(contains(refusal_of(product), "its name is '" + std::string(name))) << name;
  }
  TinyProduct product;
  product.standard_name = "eastward_sea_water_velocity standard_error";
  EXPECT_TRUE(contains(refusal_of(product), "standard_error")) << refusal_of(product);
  EXPECT_TRUE(contains(refusal_of(that_says("long_name", "Ensemble spread of eastward current")),
                       "spread"));
  EXPECT_TRUE(contains(refusal_of(that_says("GRIB_dataType", "es")), "GRIB_dataType"));
  EXPECT_TRUE(contains(refusal_of(that_says("GRIB_stepType", "max")), "GRIB_stepType"));
  // Words of wave spectra are no statistics.
  TinyProduct waves =
      that_says("long_name", "Sea surface wave period at variance spectral density maximum (Tp)");
  waves.name = "VTPK";
  waves.standard_name = "sea_surface_wave_period_at_variance_spectral_density_maximum";
  waves.unit = "s";
  waves.depth.clear();
  waves.order = {"time", "latitude", "longitude"};
  EXPECT_EQ(refusal_of(waves), "nothing was thrown");
}

TEST(StatisticOfAQuantity, AGustIsAMaximumByNature) {
  TinyProduct gust = that_says("cell_methods", "time: maximum");
  gust.name = "fg10";
  gust.standard_name = "wind_speed_of_gust";
  gust.depth.clear();
  gust.order = {"time", "latitude", "longitude"};
  EXPECT_EQ(refusal_of(gust), "nothing was thrown");
}

TEST(StatisticOfAQuantity, BesideTheQuantityItIsLeftOutAndTold) {
  TinyProduct product;
  product.more = [](Writer& writer, int, const std::map<std::string, int>& d) {
    const int spread =
        writer.variable("uo_std", Type::float32,
                        {d.at("time"), d.at("depth"), d.at("latitude"), d.at("longitude")});
    writer.attribute(spread, "units", "m s-1");
    writer.attribute(spread, "standard_name", "eastward_sea_water_velocity");
    return nullptr;
  };
  const Decoded decoded = decode(product);
  EXPECT_EQ(decoded.granule().variables.size(), 1U);
  EXPECT_TRUE(contains(decoded.warnings(), "left out 1 variable that is a statistic"))
      << decoded.warnings();
  EXPECT_TRUE(contains(decoded.warnings(), "'uo_std'"));
}

TEST(StatisticOfAQuantity, TheMeanOverMembersIsADatasetOfItsOwn) {
  const Decoded decoded = decode(that_says("cell_methods", "realization: mean"));
  EXPECT_EQ(decoded.granule().dataset_id, "ensemble_mean");
  EXPECT_TRUE(contains(decoded.warnings(), "mean over the members")) << decoded.warnings();
  EXPECT_EQ(decode(TinyProduct{}).granule().dataset_id, "");
}

}  // namespace
}  // namespace slackwater::ingest::statistic_decode_test
