#include "ingest/copernicus/product_catalogue.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "fields/base/error.h"
#include "ingest/cf/units.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::product_catalogue_test {
namespace {

std::filesystem::path products_folder() {
  return slackwater::tests::source_folder() / "data" / "products";
}

TEST(ProductCatalogue, EveryDescriptorOfTheRepositoryLoads) {
  const ProductCatalogue catalogue = ProductCatalogue::load(products_folder());
  EXPECT_GE(catalogue.products().size(), 10U);
  EXPECT_EQ(catalogue.products().back().id, "cf");
  for (const Product& product : catalogue.products()) {
    EXPECT_TRUE(product.id == "cf" || !product.match.empty()) << product.id;
    if (product.attribution.empty()) continue;
    for (const MatchRule& rule : product.match)
      EXPECT_FALSE(rule.attribute.empty()) << product.id << " credits by a file's layout alone";
  }
}

TEST(ProductCatalogue, CanonicalUnitsAreUnits) {
  const ProductCatalogue catalogue = ProductCatalogue::load(products_folder());
  for (const Quantity& quantity : catalogue.vocabulary().quantities()) {
    EXPECT_TRUE(
        unit_conversion(quantity.unit, quantity.unit, quantity.standard_name).is_identity());
    EXPECT_LT(quantity.gross.low, quantity.gross.high);
  }
}

TEST(ProductCatalogue, ShortNamesLeadToTheirStandardNames) {
  const ProductCatalogue catalogue = ProductCatalogue::load(products_folder());
  const Vocabulary& words = catalogue.vocabulary();
  EXPECT_EQ(words.by_alias("vozocrtx")->standard_name, "eastward_sea_water_velocity");
  EXPECT_EQ(words.by_alias("mwd")->standard_name, "sea_surface_wave_from_direction");
  EXPECT_EQ(words.by_alias("u100")->alias("u100")->height_m, 100.0);
  EXPECT_EQ(words.by_standard_name("direction_of_sea_water_velocity")->standard_name,
            "sea_water_velocity_to_direction");
  EXPECT_EQ(words.by_alias("so"), nullptr);
}

TEST(ProductCatalogue, DownloadsCoverCurrentLevelWaveWindAndBathymetry) {
  const std::vector<Download> downloads = ProductCatalogue::load(products_folder()).downloads();
  std::set<DownloadKind> kinds;
  int last = 0;
  for (const Download& download : downloads) {
    kinds.insert(download.kind);
    EXPECT_FALSE(download.variables.empty()) << download.dataset_id;
    EXPECT_LE(last, download.priority);
    last = download.priority;
  }
  EXPECT_EQ(kinds.size(), 5U);
}

class DescriptorFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::copy_file(products_folder() / "variables.yaml", folder_ / "variables.yaml");
    std::filesystem::copy_file(products_folder() / "cf.yaml", folder_ / "cf.yaml");
  }
  std::string refusal_with(const std::string& yaml) {
    std::ofstream(folder_ / "p.yaml") << yaml;
    try {
      (void)ProductCatalogue::load(folder_.path());
    } catch (const Error& error) {
      return error.message();
    }
    return "nothing was thrown";
  }
  slackwater::tests::TemporaryFolder folder_;
};

TEST_F(DescriptorFolder, UnknownKeysAndBadValuesAreRefusedWithFileAndLine) {
  const std::string head = "id: p\ntitle: t\nattribution: a\n";
  EXPECT_EQ(refusal_with(head), "nothing was thrown");
  EXPECT_NE(refusal_with(head + "tilte: x\n").find("p.yaml:4"), std::string::npos);
  EXPECT_NE(refusal_with(head + "current_depth_m: 47\n").find("current_depth_m"),
            std::string::npos);
  EXPECT_NE(
      refusal_with(head + "means: [{attribute: title, contains: x, step: 1h, label: middle}]\n")
          .find("expected centre"),
      std::string::npos);
  EXPECT_NE(refusal_with(head + "variables: {a: no_such_name}\n").find("not in variables.yaml"),
            std::string::npos);
  EXPECT_NE(refusal_with("id: cf\ntitle: t\nattribution: a\n").find("described twice"),
            std::string::npos);
}

TEST(ProductCatalogueLoad, AFolderThatIsNotThereIsNotFound) {
  try {
    (void)ProductCatalogue::load("/nonexistent");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
  }
}

}  // namespace
}  // namespace slackwater::ingest::product_catalogue_test
