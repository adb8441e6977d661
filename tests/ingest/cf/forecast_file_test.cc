#include "ingest/cf/forecast/forecast_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "ingest/netcdf/file.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::forecast_file_test {
namespace {

using std::chrono::hours;

/// A forecast with everything but an ensemble (see forecast_members_test.cc) in it: several
/// statuses, a column below the bed, waves without a period.
Snapshot full_snapshot(std::size_t columns) {
  Rng random(11, "tests/forecast_file");
  Snapshot s;
  s.site_id = "test_site";
  s.site_name = "Test site";
  s.day = parse_day("2025-03-09");
  s.issued = parse_utc("2025-03-10T05:00:00Z");
  s.wind_policy = WindPolicy::best;
  s.seed = 0xfedcba9876543210;  // more than a double holds
  s.degraded = true;
  s.contains_stokes = true;
  s.hindsight = true;
  s.simulated_wind = true;
  s.averaged = {hours(24), true, 0.1 + 0.2, "med_currents"};
  s.headline = "No wind is stored: the wind-driven part is left out.";
  s.attributions = {"first sentence", "second sentence"};
  s.provenance.site = "otranto";
  s.provenance.issued = s.issued;
  s.provenance.inputs = {{"med_currents", {"0a", "0b"}}, {"wind", {}}};
  s.provenance.code_version = "0.1.0";
  s.provenance.calibration = {"finite_depth", 0.1 + 0.2, "converged", {{"viscosity", 1e-3 / 3}}};
  s.depth_m = {0.494025, 5.078224, 29.44473};
  for (int t = 0; t <= 24; ++t) s.time.push_back(UtcTime(s.day) + hours(24 + t));
  s.columns.resize(columns);
  for (std::size_t c = 0; c < columns; ++c) {
    ForecastColumn& column = s.columns[c];
    column.point = GeoPoint::from_degrees(48.85 + 0.01 * static_cast<double>(c), -2.55);
    column.water_depth_m = 12.5;
    column.water_depth_source = c == 0 ? "site" : "bathymetry";
    for (std::size_t t = 0; t < s.time.size(); ++t) {
      for (std::size_t k = 0; k < s.depth_m.size(); ++k) {
        const bool there = k < 2;
        column.current_status.push_back(there ? SampleStatus::ok : SampleStatus::below_bed);
        column.current_m_s.push_back(there ? Horizontal(random.normal(), random.normal())
                                           : Horizontal{});
        column.current_sigma_m_s.push_back(there ? random.uniform() : 0);
      }
      column.wind_m_s.emplace_back(random.normal(), random.normal());
      column.wind_source.push_back(t < 5 ? DataStatus::forecast : DataStatus::persisted);
      column.sea.push_back(
          {random.uniform(), t == 3 ? std::numeric_limits<double>::quiet_NaN() : 8.0, 240.0});
      column.sea_source.push_back(DataStatus::modelled);
      column.height_spread.push_back(0.1 + 0.01 * static_cast<double>(t + c));
    }
  }
  return s;
}

void expect_same(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.site_id, b.site_id);
  EXPECT_EQ(a.site_name, b.site_name);
  EXPECT_EQ(a.day, b.day);
  EXPECT_EQ(a.issued, b.issued);
  EXPECT_EQ(a.wind_policy, b.wind_policy);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.members, b.members);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.depth_m, b.depth_m);
  EXPECT_EQ(a.degraded, b.degraded);
  EXPECT_EQ(a.contains_stokes, b.contains_stokes);
  EXPECT_EQ(a.hindsight, b.hindsight);
  EXPECT_EQ(a.simulated_wind, b.simulated_wind);
  EXPECT_EQ(a.averaged, b.averaged);
  EXPECT_EQ(a.headline, b.headline);
  EXPECT_EQ(a.attributions, b.attributions);
  EXPECT_EQ(a.provenance, b.provenance);
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t c = 0; c < a.columns.size(); ++c) {
    EXPECT_NEAR(a.columns[c].point.latitude_deg(), b.columns[c].point.latitude_deg(), 1e-13);
    EXPECT_EQ(a.columns[c].water_depth_m, b.columns[c].water_depth_m);
    EXPECT_EQ(a.columns[c].water_depth_source, b.columns[c].water_depth_source);
    EXPECT_EQ(a.columns[c].current_m_s, b.columns[c].current_m_s);
    EXPECT_EQ(a.columns[c].current_sigma_m_s, b.columns[c].current_sigma_m_s);
    EXPECT_EQ(a.columns[c].current_status, b.columns[c].current_status);
    EXPECT_EQ(a.columns[c].wind_m_s, b.columns[c].wind_m_s);
    EXPECT_EQ(a.columns[c].wind_source, b.columns[c].wind_source);
    EXPECT_EQ(a.columns[c].sea_source, b.columns[c].sea_source);
    EXPECT_EQ(a.columns[c].height_spread, b.columns[c].height_spread);
    for (std::size_t t = 0; t < a.columns[c].sea.size(); ++t) {
      EXPECT_EQ(a.columns[c].sea[t].significant_height_m, b.columns[c].sea[t].significant_height_m);
      EXPECT_EQ(std::isnan(a.columns[c].sea[t].peak_period_s),
                std::isnan(b.columns[c].sea[t].peak_period_s));
    }
  }
}

TEST(ForecastFile, ReturnsEveryBitOfASingleColumn) {
  const slackwater::tests::TemporaryFolder folder;
  const Snapshot written = full_snapshot(1);
  write_forecast(folder / "f.nc", written);
  expect_same(written, read_forecast(folder / "f.nc"));
}

TEST(ForecastFile, ReturnsEveryBitOfSeveralColumns) {
  const slackwater::tests::TemporaryFolder folder;
  const Snapshot written = full_snapshot(3);
  write_forecast(folder / "f.nc", written);
  expect_same(written, read_forecast(folder / "f.nc"));
}

TEST(ForecastFile, WithoutWindWavesOrCurrentsStaysWithout) {
  const slackwater::tests::TemporaryFolder folder;
  Snapshot written = full_snapshot(1);
  written.depth_m.clear();
  ForecastColumn& column = written.columns[0];
  column.current_m_s.clear();
  column.current_sigma_m_s.clear();
  column.current_status.clear();
  column.wind_m_s.clear();
  column.wind_source.clear();
  write_forecast(folder / "f.nc", written);
  expect_same(written, read_forecast(folder / "f.nc"));
}

TEST(ForecastFile, AColumnWithoutWindAndWavesDoesNotCostTheOthersTheirs) {
  const slackwater::tests::TemporaryFolder folder;
  Snapshot written = full_snapshot(3);
  for (const std::size_t poor : {std::size_t{0}, std::size_t{2}}) {
    written.columns[poor].wind_m_s.clear();
    written.columns[poor].wind_source.clear();
    written.columns[poor].wind_member_m_s.clear();
    written.columns[poor].sea.clear();
    written.columns[poor].sea_source.clear();
    written.columns[poor].height_spread.clear();
  }
  write_forecast(folder / "f.nc", written);
  const Snapshot read = read_forecast(folder / "f.nc");
  expect_same(written, read);
  EXPECT_FALSE(read.columns[1].wind_m_s.empty());
  EXPECT_FALSE(read.columns[1].sea.empty());
  EXPECT_TRUE(read.columns[0].sea.empty()) << "no waves, not waves that were analysed";
}

TEST(ForecastFile, SaysOfItsWavesWhereTheyComeFrom) {
  const slackwater::tests::TemporaryFolder folder;
  Snapshot written = full_snapshot(1);
  ForecastColumn& column = written.columns[0];
  column.sea_source.assign(column.sea.size(), DataStatus::modelled);
  write_forecast(folder / "f.nc", written);
  const auto file = netcdf::File::open(folder / "f.nc");
  const netcdf::Variable* height = file.find("sea_surface_wave_significant_height");
  ASSERT_NE(height, nullptr);
  EXPECT_EQ(height->text("comment"), "computed from the wind");
}

TEST(ForecastFile, HasTheBandOfItsWaveHeightsOrNoneWhereItSaysNone) {
  const slackwater::tests::TemporaryFolder folder;
  Snapshot written = full_snapshot(1);
  write_forecast(folder / "f.nc", written);
  const auto file = netcdf::File::open(folder / "f.nc");
  const auto of = [&](const char* name) {
    return file.read_all(*file.find(std::string("sea_surface_wave_significant_height") + name));
  };
  const std::vector<double> low = of("_p10"), high = of("_p90");
  for (std::size_t t = 0; t < low.size(); ++t) {
    const double height_m = written.columns[0].sea[t].significant_height_m;
    const double spread = 1.2815515655446004 * written.columns[0].height_spread[t];
    EXPECT_NEAR(high[t], (height_m + 0.3) * std::exp(spread) - 0.3, 1e-12);
    EXPECT_NEAR(low[t], std::max(0.0, (height_m + 0.3) * std::exp(-spread) - 0.3), 1e-12);
  }
  written.columns[0].height_spread.clear();
  write_forecast(folder / "before.nc", written);
  EXPECT_TRUE(read_forecast(folder / "before.nc").columns[0].height_spread.empty());
}

TEST(ForecastFile, HasOneVariablePerComponentWithTheStandardName) {
  const slackwater::tests::TemporaryFolder folder;
  write_forecast(folder / "f.nc", full_snapshot(3));
  const auto file = netcdf::File::open(folder / "f.nc");
  for (const std::string name : {"eastward_sea_water_velocity", "northward_sea_water_velocity"}) {
    int holders = 0;
    for (const netcdf::Variable& variable : file.variables()) {
      if (variable.text("standard_name") != name) continue;
      ++holders;
      EXPECT_EQ(variable.dimensions, (std::vector<std::string>{"time", "depth", "column"}));
    }
    EXPECT_EQ(holders, 1) << name;
  }
}

TEST(ForecastFile, AMissingCurrentIsFillNeverZero) {
  const slackwater::tests::TemporaryFolder folder;
  write_forecast(folder / "f.nc", full_snapshot(1));
  const auto file = netcdf::File::open(folder / "f.nc");
  const auto* east = file.find("eastward_sea_water_velocity");
  const auto values = file.read_all(*east);
  for (std::size_t t = 0; t < 25; ++t) EXPECT_EQ(values[t * 3 + 2], east->number("_FillValue"));
}

TEST(ForecastFile, AnotherFileIsRefused) {
  const slackwater::tests::TemporaryFolder folder;
  auto writer = netcdf::Writer::create(folder / "other.nc");
  const int time = writer.dimension("time", 2);
  writer.variable("time", netcdf::Type::float64, {time});
  writer.end_definitions();
  writer.close();
  EXPECT_THROW(static_cast<void>(read_forecast(folder / "other.nc")), Error);
  EXPECT_THROW(static_cast<void>(read_forecast(folder / "none.nc")), Error);
}

}  // namespace
}  // namespace slackwater::ingest::forecast_file_test
