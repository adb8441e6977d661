#include <gtest/gtest.h>

#include "tests/ingest/cf/tiny_product.h"
#include "tests/support/contains.h"

namespace slackwater::ingest::valid_range_test {
namespace {

using netcdf::Type;
using netcdf::Writer;
using slackwater::ingest::tests::decode;
using slackwater::ingest::tests::Decoded;
using slackwater::ingest::tests::products;
using slackwater::ingest::tests::refusal_of;
using slackwater::ingest::tests::TinyProduct;
using slackwater::tests::contains;

constexpr const char* east = "eastward_sea_water_velocity";

/// Shorts of a millimetre a second, -1.1 to 1.1 m/s, with limits of any type.
TinyProduct millimetres(const std::string& limit_type, double low, double high, Type type) {
  TinyProduct product;
  product.type = Type::int16;
  product.fill = -32768;
  product.value = [](std::size_t t, std::size_t k, std::size_t j, std::size_t i) {
    return -1100.0 + 100.0 * static_cast<double>(t * 8 + k * 4 + j + i % 2);
  };
  product.more = [=](Writer& writer, int variable, const std::map<std::string, int>&) {
    writer.attribute(variable, "scale_factor", 0.001);
    if (limit_type == "valid_range") {
      writer.attribute(variable, "valid_range", std::vector<double>{low, high}, type);
    } else {
      writer.attribute(variable, "valid_min", std::vector<double>{low}, type);
      writer.attribute(variable, "valid_max", std::vector<double>{high}, type);
    }
    return nullptr;
  };
  return product;
}

std::size_t missing_in(const Decoded& decoded, const std::string& name = east) {
  const std::vector<float> values = decoded.field(name).values;
  return static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](float v) { return std::isnan(v); }));
}

TEST(ValidRange, InTheUnitOfTheVariableOnPackedNumbersKeepsTheValues) {
  for (const char* name : {"valid_min", "valid_range"}) {
    for (const Type type : {Type::int16, Type::int32, Type::float32, Type::float64}) {
      const Decoded decoded = decode(millimetres(name, -5, 5, type));
      EXPECT_EQ(missing_in(decoded), 0U) << name;
      if (type == Type::int16)
        EXPECT_TRUE(contains(decoded.warnings(), "values in the unit of the variable"))
            << decoded.warnings();
      if (type == Type::float64) EXPECT_EQ(decoded.warnings(), "");
    }
  }
}

TEST(ValidRange, InPackedNumbersIsReadSoWhateverItsType) {
  for (const Type type : {Type::int16, Type::int32, Type::float32, Type::float64}) {
    const Decoded decoded = decode(millimetres("valid_range", -5000, 5000, type));
    EXPECT_EQ(missing_in(decoded), 0U);
  }
}

TEST(ValidRange, WhatItDropsIsTold) {
  // -1.1, -1.0 … : below -1.05 only the first value of each row 0, level 0, time 0.
  const Decoded decoded = decode(millimetres("valid_min", -1050, 5000, Type::int16));
  const std::size_t lost = missing_in(decoded);
  EXPECT_GT(lost, 0U);
  EXPECT_TRUE(contains(decoded.warnings(), "'uo': " + std::to_string(lost) + " of 72 values"))
      << decoded.warnings();
}

TEST(ValidRange, AVariableThatLosesAllByItIsRefusedWithTheReason) {
  TinyProduct product;
  product.more = [](Writer& writer, int variable, const std::map<std::string, int>&) {
    writer.attribute(variable, "valid_range", std::vector<double>{5, 6}, Type::float32);
    return nullptr;
  };
  EXPECT_TRUE(contains(refusal_of(product), "outside the valid range that the file states"))
      << refusal_of(product);
}

/// Both components, 0 on the two western columns and below the first level in the next.
TinyProduct without_mask(std::vector<double> time, bool zero_everywhere = false) {
  TinyProduct product;
  product.time = std::move(time);
  const auto is_land = [=](std::size_t k, std::size_t i) {
    return zero_everywhere || i < 2 || (i == 2 && k > 0);
  };
  product.value = [=](std::size_t t, std::size_t k, std::size_t, std::size_t i) {
    return is_land(k, i) ? 0.0 : 0.1 + 0.1 * static_cast<double>(t);
  };
  product.more = [=, n = product.time.size()](Writer& writer, int,
                                              const std::map<std::string, int>& d) {
    const int north = writer.variable(
        "vo", Type::float32, {d.at("time"), d.at("depth"), d.at("latitude"), d.at("longitude")});
    writer.attribute(north, "units", "m s-1");
    return [=](Writer& w) {
      std::vector<double> values;
      for (std::size_t c = 0; c < n * 2 * 3 * 4; ++c)  // 0 in the east at all times: no land
        values.push_back(is_land(c / 12 % 2, c % 4) || c % 4 == 3 ? 0.0 : -0.2);
      w.write_all(north, values);
    };
  };
  return product;
}

TEST(ZerosForLand, AreMissingWhereBothComponentsAreExactlyZeroAllTheTime) {
  const Decoded decoded = decode(without_mask({0, 1, 2}));
  const std::size_t land = 3 * (2 * 3 * 2 + 3);  // times, two columns on both levels, one below
  EXPECT_EQ(missing_in(decoded), land);
  EXPECT_EQ(missing_in(decoded, "northward_sea_water_velocity"), land);
  EXPECT_TRUE(contains(decoded.warnings(), "in 15 of 24 cells")) << decoded.warnings();
  EXPECT_TRUE(contains(decoded.warnings(), "not as calm"));
}

TEST(ZerosForLand, OfOneTimeNeedAnArea) {
  EXPECT_EQ(missing_in(decode(without_mask({0}))), 15U);
  TinyProduct lone;
  lone.time = {0};
  lone.value = [](std::size_t, std::size_t k, std::size_t j, std::size_t i) {
    return k + j + i == 0 ? 0.0 : 0.25;
  };
  EXPECT_EQ(missing_in(decode(lone)), 0U);
  lone.time = {0, 1, 2};
  EXPECT_EQ(missing_in(decode(lone)), 3U);
}

TEST(ZerosForLand, AFieldWithAMaskKeepsItsZeros) {
  TinyProduct product = without_mask({0, 1, 2});
  const auto inner = product.value;
  product.fill = -999;
  product.value = [=](std::size_t t, std::size_t k, std::size_t j, std::size_t i) {
    return j == 2 && i == 3 ? -999.0 : inner(t, k, j, i);
  };
  EXPECT_EQ(missing_in(decode(product)), 6U);
}

TEST(ZerosForLand, AFieldOfNothingButZerosIsTold) {
  const Decoded decoded = decode(without_mask({0, 1, 2}, true));
  EXPECT_EQ(missing_in(decoded), 0U);
  EXPECT_TRUE(contains(decoded.warnings(), "exactly 0 everywhere")) << decoded.warnings();
}

TEST(ValidRange, TheCaseFilesKeepTheirValuesAndLoseTheirZeros) {
  SLACKWATER_NEEDS_SHARED(shared);
  const std::filesystem::path cases = shared / "data" / "cases" / "valid_range";
  if (!std::filesystem::is_directory(cases)) GTEST_SKIP() << "no case files in " << cases;
  const auto read = [&](const char* name) {
    Decoded decoded{std::make_unique<slackwater::tests::TemporaryFolder>(), {}};
    decoded.ingested =
        decode_gridded(netcdf::File::open(cases / name), products(), {}, decoded.folder->path());
    return decoded;
  };
  EXPECT_EQ(missing_in(read("short_limits.nc")), 0U);
  const Decoded zeros = read("zeros.nc");
  EXPECT_EQ(missing_in(zeros), 24U * 3U * 5U * 2U);
  EXPECT_TRUE(contains(zeros.warnings(), "30 of 75 cells")) << zeros.warnings();
}

}  // namespace
}  // namespace slackwater::ingest::valid_range_test
