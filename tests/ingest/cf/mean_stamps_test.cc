#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <numbers>

#include "fields/base/constants.h"
#include "ingest/cf/dataset_period.h"
#include "tests/ingest/cf/tiny_product.h"
#include "tests/support/contains.h"

namespace slackwater::ingest::mean_stamps_test {
namespace {

using netcdf::Writer;
using slackwater::ingest::tests::decode;
using slackwater::ingest::tests::Decoded;
using slackwater::ingest::tests::message_of;
using slackwater::ingest::tests::products;
using slackwater::ingest::tests::refusal_of;
using slackwater::ingest::tests::TinyProduct;
using slackwater::tests::contains;
using std::chrono::hours;

constexpr const char* east = "eastward_sea_water_velocity";
constexpr const char* ibi_title =
    "Atlantic-Iberian Biscay Irish- Ocean Physics Analysis and Forecast";
constexpr const char* med_title = "hourly mean fields MEDSEA_ANALYSISFORECAST_PHY_006_013";
constexpr const char* glo_title = "Global Ocean Physics Analysis and Forecast";

TimeCell cell(const char* start, const char* end) { return {parse_utc(start), parse_utc(end)}; }
const TimeCell first_hour = cell("2024-03-01T00:00:00Z", "2024-03-01T01:00:00Z");

TinyProduct titled(const std::string& title, std::vector<double> time) {
  TinyProduct product;
  product.global = {{"title", title}};
  product.time = std::move(time);
  return product;
}

TEST(DatasetPeriod, IsReadFromNamesOfCopernicusMarine) {
  const auto hourly = period_in("cmems_mod_ibi_phy_anfc_0.027deg-3D_PT1H-m");
  ASSERT_TRUE(hourly);
  EXPECT_TRUE(hourly->is_mean);
  EXPECT_EQ(hourly->step, hours(1));
  EXPECT_EQ(period_in("x/cmems_mod_med_phy-cur_anfc_4.2km_P1D-m_uo-vo_6.00W.nc")->step, hours(24));
  EXPECT_TRUE(period_in("cmems_mod_glo_phy_anfc_0.083deg_P1M-m_202311")->is_month);
  EXPECT_FALSE(period_in("cmems_mod_nws_phy-cur_anfc_1.5km-2D_PT15M-i")->is_mean);
  EXPECT_FALSE(period_in("cmems_mod_glo_phy_anfc_0.083deg_static"));
  EXPECT_FALSE(period_in("my_model_PT1H-m.nc"));
}

TEST(MeanStamps, OnTheHourAndAtTheHalfHourAreTheSameHourlyMean) {
  for (const char* title : {ibi_title, med_title}) {
    for (const double stamp : {0.0, 0.5}) {
      const Decoded found = decode(titled(title, {stamp, stamp + 1, stamp + 2}));
      EXPECT_EQ(found.granule().grid.time.front(), first_hour) << title << stamp;
      EXPECT_EQ(found.granule().grid.time.back(),
                cell("2024-03-01T02:00:00Z", "2024-03-01T03:00:00Z"));
    }
  }
  EXPECT_TRUE(contains(decode(titled(med_title, {0, 1})).warnings(),
                       "stamped at the start of their interval"));
  EXPECT_FALSE(contains(decode(titled(med_title, {0.5, 1.5})).warnings(), "stamped"));
  EXPECT_TRUE(contains(decode(titled(ibi_title, {0.5, 1.5})).warnings(), "the file does not say"));
}

TEST(MeanStamps, InSinglePrecisionStayInTheirHour) {
  // Half a minute early or late, as hours since 1950 in floats are.
  const Decoded found = decode(titled(med_title, {-0.008, 1.008, 1.992}));
  EXPECT_EQ(found.granule().grid.time.front(), first_hour);
  EXPECT_EQ(found.granule().grid.time.back(), cell("2024-03-01T02:00:00Z", "2024-03-01T03:00:00Z"));
}

TEST(MeanStamps, NeitherStartNorMiddleIsAQuestion) {
  EXPECT_TRUE(contains(refusal_of(titled(med_title, {0.25, 1.25})),
                       "expected the start or the middle of its interval"));
}

TEST(MeanStamps, DaysAndMonthsAreThoseOfTheCalendar) {
  const TimeCell day = cell("2024-03-01T00:00:00Z", "2024-03-02T00:00:00Z");
  const TimeCell march = cell("2024-03-01T00:00:00Z", "2024-04-01T00:00:00Z");
  const TimeCell april = cell("2024-04-01T00:00:00Z", "2024-05-01T00:00:00Z");
  for (const char* title :
       {ibi_title, glo_title, "MEDSEA_ANALYSISFORECAST_PHY_006_013",
        "NWSHELF_ANALYSISFORECAST_PHY_004_013", "BALTICSEA_ANALYSISFORECAST_PHY_003_006"}) {
    EXPECT_EQ(decode(titled(title, {0, 24, 48})).granule().grid.time.front(), day) << title;
    EXPECT_EQ(decode(titled(title, {12, 36})).granule().grid.time.front(), day) << title;
    const Decoded months = decode(titled(title, {0, 31 * 24.0, 61 * 24.0}));
    EXPECT_EQ(months.granule().grid.time.at(0), march) << title;
    EXPECT_EQ(months.granule().grid.time.at(1), april) << title;
    EXPECT_EQ(decode(titled(title, {15.5 * 24, 46 * 24.0})).granule().grid.time.at(1), april);
  }
}

TEST(MeanStamps, InstantsStayInstants) {
  for (const char* title :
       {"NWSHELF_ANALYSISFORECAST_PHY_004_013", "BALTICSEA_ANALYSISFORECAST_PHY_003_006"})
    EXPECT_FALSE(decode(titled(title, {0, 1, 2})).granule().grid.time.front().is_mean()) << title;
  EXPECT_FALSE(decode(titled(ibi_title, {0, 0.25, 0.5})).granule().grid.time.front().is_mean());
  TinyProduct total = titled(glo_title, {0, 1, 2});
  total.name = "utotal";
  EXPECT_FALSE(decode(total).granule().grid.time.front().is_mean());
  EXPECT_TRUE(decode(titled(glo_title, {0, 1, 2})).granule().grid.time.front().is_mean());
}

TEST(MeanStamps, TheNameOfTheDatasetSpeaksForAnyProductUnlessTheStampsBelieIt) {
  TinyProduct product;
  product.global = {{"comment", "cut of cmems_mod_arc_phy_anfc_6km_PT1H-m"}};
  EXPECT_EQ(decode(product).granule().grid.time.front(), first_hour);
  product.global = {{"subset:datasetId", "cmems_mod_arc_phy_anfc_6km_PT1H-i"}};
  EXPECT_FALSE(decode(product).granule().grid.time.front().is_mean());
  product.global = {{"history", "cdo seltimestep cmems_mod_arc_phy_anfc_6km_P1D-m.nc"}};
  EXPECT_FALSE(decode(product).granule().grid.time.front().is_mean());
}

TEST(MeanStamps, TheNameOfTheFileSpeaksWhereTheFileIsSilent) {
  const slackwater::tests::TemporaryFolder folder;
  const auto file = folder / "cmems_mod_ibi_phy_anfc_0.027deg-3D_PT1H-m_uo-vo_6.00W.nc";
  titled(ibi_title, {0}).write(file);
  const Ingested found = decode_gridded(netcdf::File::open(file), products(), {}, folder.path());
  EXPECT_EQ(found.granules.at(0).granule.grid.time.front(), first_hour);
}

TEST(MeanStamps, WhatTheOperatorsDescriptorSaysHolds) {
  // The product's own descriptor with another label, as the warning advises.
  const slackwater::tests::TemporaryFolder folder;
  std::ofstream(folder / "med.yaml")
      << "id: MEDSEA_ANALYSISFORECAST_PHY_006_013\ntitle: other stamps\nattribution: x\n"
         "means:\n  - {spacing: 1h, step: 1h, label: end}\n";
  IngestOptions options;
  options.product = std::make_shared<const Product>(products().describe(folder / "med.yaml"));
  const Decoded found = decode(titled(med_title, {1, 2, 3}), options);
  EXPECT_EQ(found.granule().grid.time.front(), first_hour);
}

TEST(MeanStamps, OneStampOfAProductWithMeansIsAQuestion) {
  const std::string why = refusal_of(titled(ibi_title, {0}));
  EXPECT_TRUE(contains(why, "has instants and means")) << why;
  EXPECT_TRUE(contains(why, "--product FILE.yaml")) << why;
}

TEST(MeanStamps, WhereOnlyTheCellMethodsSayMeanTheAssumptionIsStated) {
  TinyProduct product;
  product.more = [](Writer& writer, int variable, const std::map<std::string, int>&) {
    writer.attribute(variable, "cell_methods", "area: mean time:mean");
    return nullptr;
  };
  Decoded found = decode(product);
  EXPECT_EQ(found.granule().grid.time.front(),
            cell("2024-02-29T23:30:00Z", "2024-03-01T00:30:00Z"));
  EXPECT_TRUE(contains(found.warnings(), "--product FILE.yaml")) << found.warnings();
  product.global = {{"copernicusmarine_version", "2.1.1"}};
  EXPECT_EQ(decode(product).granule().grid.time.front(), first_hour);
  product.time = {0, 24};
  product.global.clear();
  EXPECT_EQ(decode(product).granule().grid.time.front(),
            cell("2024-03-01T00:00:00Z", "2024-03-02T00:00:00Z"));
}

/// The largest difference, m/s, of a tide of 1 m/s from the means of a file, each put in the middle
/// of its cell and freed of what the mean takes off (sinc of half the interval).
double worst_error_m_s(const Grid& grid, const std::vector<float>& values, double omega_rad_h,
                       UtcTime epoch, double amplitude_m_s, double phase_rad) {
  double worst = 0;
  const std::size_t cells = values.size() / grid.times();
  for (std::size_t t = 0; t < grid.times(); ++t) {
    const double middle_h = hours_of(grid.time[t].centre() - epoch);
    const double half = omega_rad_h * hours_of(grid.time[t].end - grid.time[t].start) / 2;
    const double damped = half > 0 ? std::sin(half) / half : 1;
    const double truth = amplitude_m_s * std::cos(omega_rad_h * middle_h - phase_rad);
    worst = std::max(worst, std::abs(static_cast<double>(values[t * cells]) / damped - truth));
  }
  return worst;
}

TEST(MeanStamps, ATideOfOneMetreASecondIsRecoveredFromToolboxFilesAndNativeOnes) {
  // The exact mean of cos(w t) over [t0, t0 + 1 h]; half an hour of delay would be 0.25 m/s.
  const double omega = 2 * std::numbers::pi / 12.4206;
  const auto mean = [&](std::size_t t) {
    const auto start = static_cast<double>(t);
    return (std::sin(omega * (start + 1)) - std::sin(omega * start)) / omega;
  };
  for (const char* title : {ibi_title, med_title}) {
    for (const double offset : {0.0, 0.5}) {
      TinyProduct product = titled(title, {});
      for (int t = 0; t < 48; ++t) product.time.push_back(t + offset);
      product.value = [&](std::size_t t, std::size_t, std::size_t, std::size_t) { return mean(t); };
      const Decoded found = decode(product);
      EXPECT_LT(worst_error_m_s(found.granule().grid, found.field(east).values, omega,
                                parse_utc("2024-03-01T00:00:00Z"), 1.0, 0.0),
                1e-6)
          << title << offset;
    }
  }
}

TEST(MeanStamps, TheCaseFilesOfTheToolboxHoldHourlyMeansFromTheirStamps) {
  SLACKWATER_NEEDS_SHARED(shared);
  const std::filesystem::path cases = shared / "data" / "cases" / "toolbox_stamps";
  if (!std::filesystem::is_directory(cases)) GTEST_SKIP() << "no case files in " << cases;
  for (const char* name : {"ibi_toolbox.nc", "ibi_toolbox_title.nc", "med_toolbox.nc"}) {
    const slackwater::tests::TemporaryFolder folder;
    const Ingested found =
        decode_gridded(netcdf::File::open(cases / name), products(), {}, folder.path());
    const Grid& grid = found.granules.at(0).granule.grid;
    EXPECT_EQ(grid.time.front(), cell("2025-03-08T00:00:00Z", "2025-03-08T01:00:00Z")) << name;
    EXPECT_EQ(grid.time.back(), cell("2025-03-09T23:00:00Z", "2025-03-10T00:00:00Z")) << name;
  }
}

}  // namespace
}  // namespace slackwater::ingest::mean_stamps_test
