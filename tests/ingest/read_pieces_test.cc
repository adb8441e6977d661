#include "ingest/read_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "fields/record/choose.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::read_pieces_test {
namespace {

using slackwater::tests::ProductCell;
using slackwater::tests::ProductForTests;
using slackwater::tests::WaterForTests;
using std::chrono::days;

const UtcDay day = parse_day("2025-03-10");

Site site_at(double longitude_deg) {
  Site site;
  site.id = "test_site";
  site.point = GeoPoint::from_degrees(WaterForTests::site_latitude_deg, longitude_deg);
  return site;
}

/// Product files in a folder, read in the order in which they were added.
class ReadPiecesTest : public ::testing::Test {
 protected:
  void add(const ProductForTests& product, const IngestOptions& options = {}) {
    const auto path = folder_ / ("product-" + std::to_string(files_.size()) + ".nc");
    files_.push_back({slackwater::tests::write_product(path, product), options});
  }
  [[nodiscard]] SitePieces read(
      const Site& site = site_at(WaterForTests::site_longitude_deg)) const {
    const auto products =
        ProductCatalogue::load(slackwater::tests::source_folder() / "data" / "products");
    return read_pieces(files_, products, site, UtcTime(day), UtcTime(day) + days(1)).pieces;
  }
  slackwater::tests::TemporaryFolder folder_;
  std::vector<FileToRead> files_;
};

/// The first value at the site's cell.
float first_value(const GriddedField& field) {
  const Grid& grid = field.grid;
  return field.values[grid.offset(0, 0, grid.rows() / 2, grid.columns() / 2)];
}

TEST_F(ReadPiecesTest, CurrentsWindWavesAndBedComeEachToItsPlace) {
  add(slackwater::tests::current_product(day));
  add(slackwater::tests::wind_product(day));
  add(slackwater::tests::wave_product(day));
  add(slackwater::tests::bathymetry_product());
  const SitePieces pieces = read();
  ASSERT_EQ(pieces.current.size(), 1U);
  EXPECT_EQ(pieces.current[0].east.grid.times(), 24U);
  EXPECT_EQ(pieces.current[0].north.grid, pieces.current[0].east.grid);
  EXPECT_EQ(pieces.wind.size(), 1U);
  EXPECT_EQ(pieces.significant_height.size(), 1U);
  EXPECT_EQ(pieces.peak_period.size(), 1U);
  EXPECT_EQ(pieces.wave_direction.size(), 1U);
  EXPECT_EQ(pieces.water_depth.size(), 1U);
  EXPECT_TRUE(pieces.mixed_layer_depth.empty());
}

TEST_F(ReadPiecesTest, TheLaterFileHasTheLargerNumberAndWins) {
  add(slackwater::tests::current_product(day));
  ProductForTests later = slackwater::tests::current_product(day);
  later.quantity("uo").value = [](const ProductCell&) { return 0.25; };
  add(later);
  const SiteData data = site_data_of(site_at(WaterForTests::site_longitude_deg), read());
  const auto chosen = choose(data.columns[0].current, {}, {});
  ASSERT_EQ(chosen.column.times(), 24U);
  for (const Horizontal& current : chosen.column.value)
    EXPECT_NEAR(current.real(), 0.25, 1e-6);  // a float
}

TEST_F(ReadPiecesTest, ARunOfAProductIsPublishedWhenTheProductIs) {
  ProductForTests run = slackwater::tests::current_product(day);
  run.title = "NWSHELF_ANALYSISFORECAST_PHY_004_013";
  const UtcTime reference = UtcTime(day) - std::chrono::hours(1);
  run.reference_time = reference;
  add(run);
  IngestOptions by_hand;
  by_hand.as = DataStatus::forecast;
  by_hand.issued = UtcTime(day) - days(1);
  add(run, by_hand);
  const SitePieces pieces = read();
  ASSERT_EQ(pieces.current.size(), 2U);
  for (const VectorPiece& piece : pieces.current) {
    const bool is_said_by_hand = *piece.origin.reference_time < reference;
    EXPECT_EQ(piece.origin.published_after, std::chrono::hours(is_said_by_hand ? 0 : 12));
    const UtcTime published =
        is_said_by_hand ? *by_hand.issued : reference + std::chrono::hours(12);
    EXPECT_FALSE(is_published_by(piece.origin, published - Duration(1)));
    EXPECT_TRUE(is_published_by(piece.origin, published));
  }
}

TEST_F(ReadPiecesTest, AFileGivenTwiceCountsOnceUnlessItIsReadOtherwise) {
  add(slackwater::tests::current_product(day));
  files_.push_back(files_.front());
  EXPECT_EQ(read().current.size(), 1U);
  files_.push_back(files_.front());
  files_.back().options.as = DataStatus::forecast;
  files_.back().options.issued = UtcTime(day) - days(1);
  const SitePieces pieces = read();
  ASSERT_EQ(pieces.current.size(), 2U);
  // Of equal first times the analysis stands first: "analysis" < "forecast".
  EXPECT_EQ(pieces.current[0].origin.status, DataStatus::analysis);
  EXPECT_EQ(pieces.current[1].origin.status, DataStatus::forecast);
  EXPECT_EQ(pieces.current[0].origin.sources, pieces.current[1].origin.sources);
}

TEST_F(ReadPiecesTest, EastAndNorthOfTwoFilesArePaired) {
  ProductForTests east = slackwater::tests::current_product(day);
  ProductForTests north = east;
  std::erase_if(east.quantities, [](const auto& quantity) { return quantity.name == "vo"; });
  std::erase_if(north.quantities, [](const auto& quantity) { return quantity.name == "uo"; });
  add(north);
  add(east);
  const SitePieces pieces = read();
  ASSERT_EQ(pieces.current.size(), 1U);
  EXPECT_EQ(pieces.current[0].origin.granules, (std::vector<std::int64_t>{2, 1}));
  EXPECT_EQ(pieces.current[0].origin.sources.size(), 2U);
  const ProductCell cell{UtcTime(day), 0, WaterForTests::site_latitude_deg,
                         WaterForTests::site_longitude_deg};
  EXPECT_NEAR(first_value(pieces.current[0].east), WaterForTests::eastward_m_s(cell), 1e-6);
  EXPECT_NEAR(first_value(pieces.current[0].north), WaterForTests::northward_m_s(cell), 1e-6);
}

TEST_F(ReadPiecesTest, WhatIsFarOffInSpaceOrTimeIsLeftOut) {
  add(slackwater::tests::current_product(day - days(3)));
  EXPECT_TRUE(read().current.empty());
  add(slackwater::tests::current_product(day));
  EXPECT_EQ(read().current.size(), 1U);
  EXPECT_TRUE(read(site_at(-30)).current.empty());
}

TEST_F(ReadPiecesTest, APieceKnowsWhenItWasPublishedAndAPairIsAsYoungAsItsLaterFile) {
  ProductForTests east = slackwater::tests::current_product(day);
  ProductForTests north = east;
  std::erase_if(east.quantities, [](const auto& quantity) { return quantity.name == "vo"; });
  std::erase_if(north.quantities, [](const auto& quantity) { return quantity.name == "uo"; });
  east.global = {{"date_created", "2025-03-11T06:00:00Z"}};
  north.global = {{"date_created", "2025-03-11T07:00:00Z"}};
  add(east);
  add(north);
  EXPECT_EQ(read().current[0].origin.published, parse_utc("2025-03-11T07:00:00Z"));
  files_[1].received = parse_utc("2025-03-11T06:30:00Z");  // so it was out by then
  EXPECT_EQ(read().current[0].origin.published, parse_utc("2025-03-11T06:30:00Z"));
  files_.clear();
  add(slackwater::tests::current_product(day));
  EXPECT_EQ(read().current[0].origin.published, std::nullopt);
}

/// Linear between any two whole degrees.
double wind_of_longitude(double longitude_deg) {
  return 0.1 * std::abs(std::remainder(longitude_deg, 360.0));
}

/// A wind round the Earth, cells a degree apart.
ProductForTests global_wind(int west_deg, int columns) {
  ProductForTests product = slackwater::tests::wind_product(day, 1);
  product.latitude_deg = {52, 53, 54, 55, 56};
  product.longitude_deg.clear();
  for (int i = 0; i < columns; ++i) product.longitude_deg.push_back(west_deg + i);
  product.quantity("eastward_wind").value = [](const ProductCell& cell) {
    return wind_of_longitude(cell.longitude_deg);
  };
  return product;
}

TEST_F(ReadPiecesTest, ASiteAwayFromTheSeamHasTheCellsThatAGridWithoutSeamGives) {
  for (const double longitude_deg : {-179.5, -100.3, -0.5, 0.0, 6.5, 120.25, 177.5}) {
    const Site site = site_at(longitude_deg);
    files_.clear();
    add(global_wind(-180, 360));
    const SitePieces round = read(site);
    files_.clear();
    add(global_wind(-180, 359));  // without its last column: a gap, and no seam
    const SitePieces gap = read(site);
    ASSERT_EQ(round.wind.size(), 1U);
    ASSERT_EQ(gap.wind.size(), 1U);
    EXPECT_EQ(round.wind[0].east.grid, gap.wind[0].east.grid) << longitude_deg;
    const auto value = [&](const SitePieces& pieces) {
      return choose(record_at(pieces.wind, site.point), {}, {}).column.value;
    };
    EXPECT_EQ(value(round), value(gap)) << longitude_deg;
    EXPECT_NEAR(value(round).front().real(), wind_of_longitude(longitude_deg), 1e-5) << "float";
  }
}

TEST_F(ReadPiecesTest, ASiteAtTheSeamHasTheCellsOnBothSides) {
  for (const int west_deg : {-180, 0}) {
    files_.clear();
    add(global_wind(west_deg, 360));
    for (const double longitude_deg : {-180.0, -0.5, -0.2, 0.0, 0.3, 179.5, 179.8}) {
      const Site site = site_at(longitude_deg);
      const SitePieces pieces = read(site);
      ASSERT_EQ(pieces.wind.size(), 1U);
      const Grid& grid = pieces.wind[0].east.grid;
      EXPECT_LE(grid.columns(), 4U) << "no more than around the site";
      const auto chosen = choose(record_at(pieces.wind, site.point), {}, {});
      ASSERT_EQ(chosen.column.times(), 1U) << west_deg << " " << longitude_deg;
      EXPECT_NEAR(chosen.column.value.front().real(), wind_of_longitude(longitude_deg), 1e-5)
          << west_deg << " " << longitude_deg;
    }
  }
}

TEST_F(ReadPiecesTest, AFileThatIsNotThereIsNamed) {
  files_.push_back({folder_ / "nowhere.nc", {}});
  try {
    (void)read();
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
    EXPECT_NE(error.message().find("nowhere.nc"), std::string::npos) << error.message();
  }
}

}  // namespace
}  // namespace slackwater::ingest::read_pieces_test
