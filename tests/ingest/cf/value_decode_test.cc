#include <gtest/gtest.h>

#include "tests/ingest/cf/tiny_product.h"
#include "tests/support/contains.h"

namespace slackwater::ingest::value_decode_test {
namespace {

using netcdf::Type;
using netcdf::Writer;
using slackwater::ingest::tests::decode;
using slackwater::ingest::tests::Decoded;
using slackwater::ingest::tests::refusal_of;
using slackwater::ingest::tests::TinyProduct;
using slackwater::tests::contains;

constexpr const char* east = "eastward_sea_water_velocity";

/// One column of raw values along longitude; the rest of the grid has length 1.
TinyProduct row_of(std::vector<double> raw, Type type) {
  TinyProduct product;
  product.time = {0};
  product.depth = {1};
  product.latitude = {50};
  product.longitude.clear();
  for (std::size_t i = 0; i < raw.size(); ++i) product.longitude.push_back(static_cast<double>(i));
  product.type = type;
  product.value = [raw](std::size_t, std::size_t, std::size_t, std::size_t i) { return raw[i]; };
  return product;
}

auto with_numbers(std::vector<std::tuple<std::string, std::vector<double>, Type>> attributes) {
  return [attributes](Writer& writer, int variable, const std::map<std::string, int>&) {
    for (const auto& [name, values, type] : attributes)
      writer.attribute(variable, name, values, type);
    return nullptr;
  };
}

TEST(ValueDecode, PackedIntegersUnpackInDoublePrecision) {
  TinyProduct product = row_of({-32767, -1000, 0, 1234}, Type::int16);
  product.fill = -32767;
  product.more = with_numbers(
      {{"scale_factor", {0.00061037}, Type::float64}, {"add_offset", {0.5}, Type::float64}});
  const std::vector<float> values = decode(product).field(east).values;
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_EQ(values[1], static_cast<float>(-1000 * 0.00061037 + 0.5));
  EXPECT_EQ(values[2], 0.5F);
  EXPECT_EQ(values[3], static_cast<float>(1234 * 0.00061037 + 0.5));
}

TEST(ValueDecode, UnsignedBytesCountFrom0To255) {
  TinyProduct product = row_of({1, 127, -56, -1}, Type::int8);  // -56 is 200, -1 is 255
  product.more = [](Writer& writer, int variable, const std::map<std::string, int>&) {
    writer.attribute(variable, "_Unsigned", "true");
    writer.attribute(variable, "scale_factor", 0.01);
    writer.attribute(variable, "missing_value", std::vector<double>{-1}, Type::int8);
    return nullptr;
  };
  const std::vector<float> values = decode(product).field(east).values;
  EXPECT_EQ(values[1], 1.27F);
  EXPECT_EQ(values[2], 2.0F);
  EXPECT_TRUE(std::isnan(values[3]));
}

TEST(ValueDecode, FillAndMissingValueBothCount) {
  TinyProduct product = row_of({0.5, 1e20, -999, 0.25}, Type::float32);
  product.fill = static_cast<double>(1e20F);
  product.more = with_numbers({{"missing_value", {-999}, Type::float32}});
  const std::vector<float> values = decode(product).field(east).values;
  EXPECT_EQ(values[0], 0.5F);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_TRUE(std::isnan(values[2]));
  EXPECT_EQ(values[3], 0.25F);
}

TEST(ValueDecode, TheLibrarysOwnFillCountsWhereTheFileNamesNone) {
  const std::vector<float> values =
      decode(row_of({0.5, 9.9692099683868690e+36, std::numeric_limits<double>::quiet_NaN()},
                    Type::float32))
          .field(east)
          .values;
  EXPECT_EQ(values[0], 0.5F);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_TRUE(std::isnan(values[2]));
}

TEST(ValueDecode, ValidRangeOfPackedDataIsPackedUnlessItsTypeSaysOtherwise) {
  TinyProduct product = row_of({-150, -50, 50, 150}, Type::int16);
  product.more = with_numbers(
      {{"scale_factor", {0.01}, Type::float32}, {"valid_range", {-100, 100}, Type::int16}});
  std::vector<float> values = decode(product).field(east).values;
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_FALSE(std::isnan(values[1]));
  EXPECT_TRUE(std::isnan(values[3]));
  product.more = with_numbers({{"scale_factor", {0.01}, Type::float32},
                               {"valid_min", {-1.0}, Type::float32},
                               {"valid_max", {2.0}, Type::float32}});
  values = decode(product).field(east).values;
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_FALSE(std::isnan(values[3]));
}

TEST(ValueDecode, UnitsAreConverted) {
  TinyProduct product = row_of({50, 100}, Type::float32);
  product.unit = "cm/s";
  EXPECT_EQ(decode(product).field(east).values, (std::vector<float>{0.5F, 1.0F}));
  product = row_of({10, 20}, Type::float32);
  product.name = "thetao";
  product.standard_name = "sea_water_potential_temperature";
  product.unit = "degrees_C";
  const GriddedField field = decode(product).field("sea_water_potential_temperature");
  EXPECT_EQ(field.unit, "K");
  EXPECT_EQ(field.values, (std::vector<float>{283.15F, 293.15F}));
}

TEST(ValueDecode, AWrongUnitIsRefusedWithBothUnits) {
  TinyProduct product = row_of({0.1, 0.2}, Type::float32);
  product.unit = "K";
  const std::string message = refusal_of(product);
  EXPECT_TRUE(contains(message, "found unit 'K'")) << message;
  EXPECT_TRUE(contains(message, "converts to 'm s-1'")) << message;
  product.unit.reset();
  EXPECT_TRUE(contains(refusal_of(product), "has no units"));
}

TEST(ValueDecode, MostValuesOutOfBeliefMeanAWrongUnit) {
  TinyProduct product = row_of({50, 60, 70, 0.1}, Type::float32);  // cm/s that say m/s
  EXPECT_TRUE(contains(refusal_of(product), "check the units"));
}

TEST(ValueDecode, AFewValuesOutOfBeliefAreMissingAndTold) {
  std::vector<double> raw(20, 0.1);
  raw[7] = 45.0;
  const Decoded decoded = decode(row_of(raw, Type::float32));
  EXPECT_TRUE(std::isnan(decoded.field(east).values[7]));
  EXPECT_TRUE(contains(decoded.warnings(), "1 of 20 values lie outside the believable range"))
      << decoded.warnings();
}

TEST(ValueDecode, AllFillIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(refusal_of(row_of({nan, nan}, Type::float32)),
                       "all values of 'uo' are missing (fill)"));
}

TEST(ValueDecode, AnEmptyVariableBesideAFullOneIsAWarning) {
  TinyProduct product = row_of({0.1, 0.2}, Type::float32);
  product.more = [](Writer& writer, int, const std::map<std::string, int>& d) {
    const int vo = writer.variable(
        "vo", Type::float32, {d.at("time"), d.at("depth"), d.at("latitude"), d.at("longitude")});
    writer.attribute(vo, "units", "m s-1");
    return nullptr;
  };
  EXPECT_TRUE(contains(decode(product).warnings(), "all values of 'vo' are missing"));
}

TEST(ValueDecode, AKnownShortNameDoesNotHideAForeignQuantity) {
  TinyProduct product = row_of({0.1, 0.2}, Type::float32);
  product.standard_name = "eastward_sea_ice_velocity";
  EXPECT_TRUE(contains(refusal_of(product),
                       "no velocity, wave or wind variable; found uo (eastward_sea_ice_velocity)"));
  product.standard_name = "";
  EXPECT_EQ(decode(product).granule().variables[0].standard_name, east);
}

TEST(ValueDecode, StokesDriftIsTakenOffWhereTheFileHoldsIt) {
  TinyProduct product = row_of({0.5, 0.6}, Type::float32);
  product.name = "utotal";
  Decoded decoded = decode(product);
  EXPECT_TRUE(decoded.granule().variables[0].contains_stokes);
  product.more = [](Writer& writer, int, const std::map<std::string, int>& d) {
    const int stokes =
        writer.variable("vsdx", Type::float32, {d.at("time"), d.at("latitude"), d.at("longitude")});
    writer.attribute(stokes, "units", "m s-1");
    return [stokes](Writer& w) { w.write_all(stokes, std::vector<double>{0.125, 0.25}); };
  };
  decoded = decode(product);
  EXPECT_FALSE(decoded.granule().variables[0].contains_stokes);
  EXPECT_EQ(decoded.field(east).values, (std::vector<float>{0.5F - 0.125F, 0.6F - 0.25F}));
}

TEST(ValueDecode, TheTotalCurrentIsPreferredToTheTidelessOne) {
  TinyProduct product = row_of({0.1, 0.2}, Type::float32);
  product.more = [](Writer& writer, int, const std::map<std::string, int>& d) {
    const int total =
        writer.variable("utotal", Type::float32,
                        {d.at("time"), d.at("depth"), d.at("latitude"), d.at("longitude")});
    writer.attribute(total, "units", "m s-1");
    return [total](Writer& w) { w.write_all(total, std::vector<double>{0.75, 0.5}); };
  };
  const Decoded decoded = decode(product);
  EXPECT_EQ(decoded.field(east).values, (std::vector<float>{0.75F, 0.5F}));
  EXPECT_TRUE(contains(decoded.warnings(), "'uo' is left out"));
}

TEST(ValueDecode, WindsOf10And100MetresAreTwoGranules) {
  TinyProduct product = row_of({5, 6}, Type::float32);
  product.name = "u10";
  product.standard_name = "";
  product.depth.clear();
  product.order = {"time", "latitude", "longitude"};
  product.more = [](Writer& writer, int, const std::map<std::string, int>& d) {
    const int high =
        writer.variable("u100", Type::float32, {d.at("time"), d.at("latitude"), d.at("longitude")});
    writer.attribute(high, "units", "m s**-1");
    return [high](Writer& w) { w.write_all(high, std::vector<double>{8, 9}); };
  };
  const Decoded decoded = decode(product);
  ASSERT_EQ(decoded.ingested.granules.size(), 2U);
  EXPECT_EQ(decoded.granule(0).grid.levels_m, std::vector<double>{10.0});
  EXPECT_EQ(decoded.granule(1).grid.levels_m, std::vector<double>{100.0});
  EXPECT_EQ(decoded.field("eastward_wind", 1).values, (std::vector<float>{8.0F, 9.0F}));
}

}  // namespace
}  // namespace slackwater::ingest::value_decode_test
