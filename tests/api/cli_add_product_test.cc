// The page api/docs/adding_a_product.md, as its reader walks it: the file is refused, the
// descriptor is copied out of the page, the file is read; and a descriptor that the file
// contradicts is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ingest/netcdf/file.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_add_product_test {
namespace {

using ingest::netcdf::Type;
using ingest::netcdf::Writer;
using nlohmann::json;

/// What the page says that the file holds, and what it forgets.
struct BayModel {
  std::vector<double> depth{0, 5, 10, 30};
  std::string depth_units;
  std::string depth_positive;
  std::string east_standard_name;
  std::string title;

  void write(const std::filesystem::path& path) const {
    Writer out = Writer::create(path);
    const int time = out.dimension("time", 24);
    const int z = out.dimension("z", depth.size());
    const int lat = out.dimension("lat", 5);
    const int lon = out.dimension("lon", 5);
    const int time_id = out.variable("time", Type::float64, {time});
    out.attribute(time_id, "units", "hours since 2025-03-06 00:00:00");
    const int z_id = out.variable("z", Type::float32, {z});
    if (!depth_units.empty()) out.attribute(z_id, "units", depth_units);
    if (!depth_positive.empty()) out.attribute(z_id, "positive", depth_positive);
    const int lat_id = out.variable("lat", Type::float64, {lat});
    out.attribute(lat_id, "units", "degrees_north");
    const int lon_id = out.variable("lon", Type::float64, {lon});
    out.attribute(lon_id, "units", "degrees_east");
    const int east = out.variable("u_east", Type::float32, {time, z, lat, lon});
    out.attribute(east, "units", "m s-1");
    if (!east_standard_name.empty()) out.attribute(east, "standard_name", east_standard_name);
    const int north = out.variable("v_north", Type::float32, {time, z, lat, lon});
    out.attribute(north, "units", "m s-1");
    if (!title.empty()) out.attribute(Writer::global, "title", title);
    out.end_definitions();
    std::vector<double> hours(24);
    for (std::size_t t = 0; t < hours.size(); ++t) hours[t] = static_cast<double>(t);
    out.write_all(time_id, hours);
    out.write_all(z_id, depth);
    out.write_all(lat_id, std::vector{53.8, 53.9, 54.0, 54.1, 54.2});
    out.write_all(lon_id, std::vector{6.3, 6.4, 6.5, 6.6, 6.7});
    const std::vector<double> values(24 * depth.size() * 25, 0.25);
    out.write_all(east, values);
    out.write_all(north, values);
    out.close();
  }
};

/// The n-th block of the page that is marked as YAML.
std::string yaml_of_the_page(std::size_t n) {
  const std::string page = read_bytes(source_folder() / "api/docs/adding_a_product.md");
  const std::string fence = "```yaml\n";
  std::size_t from = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    from = page.find(fence, from);
    EXPECT_NE(from, std::string::npos);
    from += fence.size();
  }
  return page.substr(from, page.find("```", from) - from);
}

class AddedProduct : public ::testing::Test {
 protected:
  AddedProduct() { write_bytes(descriptor(), yaml_of_the_page(0)); }
  [[nodiscard]] std::string file() const { return store_.file("bay_model.nc").string(); }
  [[nodiscard]] std::string descriptor() const { return store_.file("bay_model.yaml").string(); }

  [[nodiscard]] ProgramResult ingest(const BayModel& model,
                                     const std::vector<std::string>& more = {}) const {
    model.write(file());
    std::vector<std::string> arguments{"ingest", file()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return store_.run(arguments);
  }
  void expect_refused(const BayModel& model, const std::vector<std::string>& words) const {
    const ProgramResult result = ingest(model, {"--product", descriptor()});
    EXPECT_EQ(result.exit_code, 3) << result.out;
    for (const std::string& word : words)
      EXPECT_NE(result.err.find(word), std::string::npos) << word << " in: " << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(json::parse(store_.listing()).at("sources").empty());
  }

  StoreForTests store_;
};

TEST_F(AddedProduct, IsReadWithTheDescriptorOfThePageAndRefusedWithout) {
  const ProgramResult without = ingest({});
  EXPECT_EQ(without.exit_code, 3);
  EXPECT_NE(without.err.find("no velocity, wave or wind variable; found u_east, v_north"),
            std::string::npos)
      << without.err;

  const ProgramResult with = ingest({}, {"--product", descriptor()});
  ASSERT_EQ(with.exit_code, 0) << with.err;
  EXPECT_NE(with.out.find("bay_model.nc: BAY_MODEL, analysis, 24 times: "
                          "eastward_sea_water_velocity, northward_sea_water_velocity"),
            std::string::npos)
      << with.out;
  const json listing = json::parse(store_.listing());
  ASSERT_EQ(listing.at("granules").size(), 1U);
  const json& granule = listing["granules"][0];
  EXPECT_EQ(granule.at("product"), "BAY_MODEL") << granule;
  const ProgramResult again = ingest({}, {"--product", descriptor()});
  EXPECT_NE(again.out.find("already in the store"), std::string::npos) << again.out;
}

TEST_F(AddedProduct, ADepthWithoutUnitsIsRefusedWithTheWayOut) {
  write_bytes(descriptor(),
              "id: BAY_MODEL\ntitle: t\nattribution: a\n"
              "variables: {u_east: eastward_sea_water_velocity}\n"
              "settles: [{variable: z, standard_name: depth}]\n");
  expect_refused({}, {"'z'", "has no units", "expected 'm'", "ingest --product FILE.yaml"});
}

TEST_F(AddedProduct, IsRecognisedByItselfFromTheUsersFolder) {
  const auto folder = store_.file("config") / "slackwater/products";
  std::filesystem::create_directories(folder);
  write_bytes(folder / "bay_model.yaml", yaml_of_the_page(0) + yaml_of_the_page(1));
  BayModel().write(file());
  const auto in_store = [&](const std::map<std::string, std::string>& environment) {
    return run_program({"--store", store_.store().string(), "ingest", file()}, environment);
  };
  EXPECT_EQ(in_store({{"XDG_CONFIG_HOME", "relative/is/none"}, {"HOME", "/nonexistent"}}).exit_code,
            3);
  const ProgramResult named = in_store({{"XDG_CONFIG_HOME", store_.file("config").string()}});
  ASSERT_EQ(named.exit_code, 0) << named.err;
  EXPECT_NE(named.out.find("BAY_MODEL"), std::string::npos) << named.out;

  std::filesystem::create_directories(store_.file("home"));
  std::filesystem::rename(store_.file("config"), store_.file("home") / ".config");
  const ProgramResult home =
      in_store({{"XDG_CONFIG_HOME", ""}, {"HOME", store_.file("home").string()}});
  EXPECT_EQ(home.exit_code, 0) << home.err;
}

TEST_F(AddedProduct, TheUsersFolderHoldsNoSecondListOfQuantitiesAndNoSecondProductOfOneName) {
  const auto folder = store_.file("config") / "slackwater/products";
  std::filesystem::create_directories(folder);
  BayModel().write(file());
  const auto refusal = [&] {
    const ProgramResult result = run_program({"--store", store_.store().string(), "ingest", file()},
                                             {{"XDG_CONFIG_HOME", store_.file("config").string()}});
    EXPECT_EQ(result.exit_code, 3) << result.out;
    return result.err;
  };
  write_bytes(folder / "variables.yaml", "{}\n");
  EXPECT_NE(refusal().find("the list of quantities is that of"), std::string::npos);
  std::filesystem::remove(folder / "variables.yaml");
  write_bytes(folder / "mine.yaml", "id: cf\ntitle: t\nattribution: a\n");
  EXPECT_NE(refusal().find("described twice"), std::string::npos);
  write_bytes(folder / "mine.yaml", "id: mine\ntitel: t\nattribution: a\n");
  EXPECT_NE(refusal().find("mine.yaml"), std::string::npos);
}

TEST_F(AddedProduct, WhatTheFileItselfSaysOtherwiseIsAnError) {
  BayModel units;
  units.depth_units = "cm";
  expect_refused(units, {"'z'", "the file says units 'cm'", "'BAY_MODEL' says 'm'"});
  BayModel positive;
  positive.depth_positive = "up";
  expect_refused(positive, {"the file says positive 'up'", "says 'down'"});
  BayModel name;
  name.east_standard_name = "northward_sea_water_velocity";
  expect_refused(name, {"'u_east'", "the file says standard_name 'northward_sea_water_velocity'"});
  BayModel product;
  product.title = "NWSHELF_ANALYSISFORECAST_PHY_004_013";
  expect_refused(product, {"of product 'NWSHELF_ANALYSISFORECAST_PHY_004_013'", "'BAY_MODEL'"});
}

TEST_F(AddedProduct, TheSameSaidInOtherWordsIsNoContradiction) {
  BayModel model;
  model.depth_units = "metres";
  model.depth_positive = "Down";
  model.east_standard_name = "eastward_sea_water_velocity";
  EXPECT_EQ(ingest(model, {"--product", descriptor()}).exit_code, 0);
}

TEST_F(AddedProduct, ADescriptorThatIsNotThereOrNotOneIsToldBeforeAnythingIsStored) {
  EXPECT_EQ(ingest({}, {"--product", store_.file("none.yaml").string()}).exit_code, 4);
  write_bytes(descriptor(), "id: x\ntitle: t\nattribution: a\nsetles: []\n");
  const ProgramResult typo = ingest({}, {"--product", descriptor()});
  EXPECT_EQ(typo.exit_code, 3);
  EXPECT_NE(typo.err.find("bay_model.yaml:4"), std::string::npos) << typo.err;
  EXPECT_NE(typo.err.find("settles"), std::string::npos) << "the nearest key: " << typo.err;
}

}  // namespace
}  // namespace slackwater::tests::cli_add_product_test
