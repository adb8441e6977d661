#include "ingest/copernicus/product_catalogue.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
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

TEST_F(DescriptorFolder, AWaterThatIsNoneIsRefusedWithFileLineAndWhatWasExpected) {
  const auto refusal = [&](const std::string& waters, const std::string& water = "bay") {
    return refusal_with(
        "id: p\ntitle: t\nwaters:\n" + waters +
        "downloads:\n  - {dataset: d, kind: wave, variables: [VHM0], domain: [0, 40, "
        "10, 50], water: " +
        water + "}\n");
  };
  const auto says = [](const std::string& message, const std::string& words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  EXPECT_EQ(refusal("  bay: [2, 42,  6, 42,  4, 46]\n"), "nothing was thrown");
  EXPECT_EQ(
      refusal("  bay: [2, 42,  6, 42,  4, 46]\n  gulf: [0, 40,  1, 40,  1, 41]\n", "[bay, gulf]"),
      "nothing was thrown");
  says(refusal("  bay: [2, 42,  6, 42,  4]\n"), "p.yaml:4: waters.bay: found 5 numbers");
  says(refusal("  bay: [2, 42,  6, 42]\n"), "found 2 corners, expected three");
  says(refusal("  bay: [2, 42,  6, 42,  6, 42,  4, 46]\n"), "found a corner twice");
  says(refusal("  bay: [2, 42,  6, 46,  6, 42,  2, 46]\n"), "its sides cross");
  says(refusal("  bay: [2, 142,  6, 42,  4, 46]\n"), "found latitude 142");
  says(refusal("  bay: [2, 42,  6, 42,  4, deep]\n"), "waters.bay");
  says(refusal("  bay: [42, 2,  42, 6,  46, 4]\n"), "'bay' lies outside the domain");
  says(refusal("  bay: [2, 42,  6, 42,  4, 46]\n", "gulf"),
       "found 'gulf'; expected a name of `waters`: bay");
  says(refusal_with(
           "id: p\ntitle: t\ndownloads: [{dataset: d, kind: wave, variables: [VHM0], domain: "
           "[0, 40, 10, 50], water: bay}]\n"),
       "the product lists none");
  says(refusal_with(
           "id: p\ntitle: t\ndownloads: [{dataset: d, kind: wave, variables: [VHM0], domain: "
           "[0, 40, 10, 50], since: soon}]\n"),
       "since: found 'soon' where a UTC day was expected");
}

TEST(Download, CoversThePlacesOfItsDomainThatLieInOneOfItsWaters) {
  Download download;
  download.domain = BoundingBox::from_degrees(170, -20, -170, 0);
  const auto covers = [&](double latitude_deg, double longitude_deg) {
    return download.covers(GeoPoint::from_degrees(latitude_deg, longitude_deg));
  };
  EXPECT_TRUE(covers(-19, 171));
  // A triangle across the antimeridian, whose foot leaves the domain.
  download.water = {{"strait",
                     {GeoPoint::from_degrees(-30, 175), GeoPoint::from_degrees(-30, -175),
                      GeoPoint::from_degrees(-10, 180)}}};
  EXPECT_FALSE(covers(-19, 171));
  EXPECT_TRUE(covers(-19, 179));
  EXPECT_TRUE(covers(-19, -179));
  EXPECT_FALSE(covers(-29, 179)) << "outside the domain";
  EXPECT_FALSE(covers(-9, 180));
  EXPECT_FALSE(covers(-19, 0)) << "the other side of the Earth";
}

TEST(ProductCatalogueLoad, AFolderThatIsNotThereIsNotFound) {
  try {
    (void)ProductCatalogue::load("/nonexistent");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
  }
}

std::string refusal_of_means(const std::string& rule) {
  const slackwater::tests::TemporaryFolder folder;
  std::ofstream(folder / "bay.yaml") << "id: BAY\ntitle: bay\nmeans:\n  - " << rule << "\n";
  try {
    static_cast<void>(Product::load(folder / "bay.yaml"));
  } catch (const Error& error) {
    return error.message();
  }
  return "nothing was refused";
}

TEST(ProductCatalogue, RulesOfMeansAreWholeOrRefused) {
  const std::string sound = "nothing was refused";
  EXPECT_EQ(refusal_of_means("{spacing: 1h, step: 1h, label: utc_step}"), sound);
  EXPECT_EQ(refusal_of_means("{spacing: month, label: utc_month, variables: [uo]}"), sound);
  EXPECT_EQ(refusal_of_means("{attribute: title, contains: mean, step: 1h, label: start}"), sound);
  for (const auto& [rule, words] : std::map<std::string, std::string>{
           {"{spacing: 1h, attribute: title, step: 1h, label: start}", "either what an attribute"},
           {"{spacing: 1h, step: 5h, label: utc_step}", "divides a day"},
           {"{spacing: month, step: 24h, label: utc_month}", "no fixed length"},
           {"{spacing: 1h, step: 1h, label: middle}", "utc_step, utc_day or utc_month"},
           {"{spacing: 1h, step: 2h, label: utc_day}", "needs step 24h"}}) {
    EXPECT_NE(refusal_of_means(rule).find(words), std::string::npos) << refusal_of_means(rule);
  }
}

}  // namespace
}  // namespace slackwater::ingest::product_catalogue_test
