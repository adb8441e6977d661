#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/netcdf/file.h"
#include "tests/support/made_up_forecast.h"
#include "tests/support/store_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::forecast_members_test {
namespace {

using slackwater::tests::made_up_forecast;
using slackwater::tests::TemporaryFolder;

Snapshot through_a_file(const Snapshot& s) {
  const TemporaryFolder folder;
  write_forecast(folder / "f.nc", s);
  return read_forecast(folder / "f.nc");
}

/// Largest difference of a component, or infinity where the sizes differ.
double worst(const std::vector<Horizontal>& a, const std::vector<Horizontal>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result = std::max(
        {result, std::abs(a[i].real() - b[i].real()), std::abs(a[i].imag() - b[i].imag())});
  }
  return result;
}

TEST(ForecastMembers, ComeBackWithinHalfAStepAndTheCentralOneToTheBit) {
  for (const std::size_t columns : {1U, 2U, 7U}) {
    const Snapshot written = made_up_forecast({.columns = columns, .members = 5, .seed = 99});
    const Snapshot read = through_a_file(written);
    EXPECT_EQ(read.members, 5U);
    EXPECT_EQ(read.seed, 99U);
    ASSERT_EQ(read.columns.size(), columns);
    for (std::size_t c = 0; c < columns; ++c) {
      const ForecastColumn& w = written.columns[c];
      const ForecastColumn& r = read.columns[c];
      EXPECT_EQ(r.current_m_s, w.current_m_s);
      EXPECT_EQ(r.wind_m_s, w.wind_m_s);
      EXPECT_LE(worst(r.member_m_s, w.member_m_s), member_step_m_s / 2);
      EXPECT_LE(worst(r.wind_member_m_s, w.wind_member_m_s), wind_member_step_m_s / 2);
      EXPECT_GT(worst(r.member_m_s, w.member_m_s), 0) << "or the bound above tests nothing";
    }
  }
}

TEST(ForecastMembers, AreReadAndWrittenAgainWithoutAnyChange) {
  const Snapshot once = through_a_file(made_up_forecast({.columns = 3}));
  const Snapshot twice = through_a_file(once);
  for (std::size_t c = 0; c < once.columns.size(); ++c) {
    EXPECT_EQ(twice.columns[c].member_m_s, once.columns[c].member_m_s);
    EXPECT_EQ(twice.columns[c].wind_member_m_s, once.columns[c].wind_member_m_s);
  }
}

TEST(ForecastMembers, AreWrittenToTheSameBytesEachTime) {
  const TemporaryFolder folder;
  const Snapshot s = made_up_forecast({.columns = 3});
  write_forecast(folder / "a.nc", s);
  write_forecast(folder / "b.nc", s);
  EXPECT_EQ(slackwater::tests::read_bytes(folder / "a.nc"),
            slackwater::tests::read_bytes(folder / "b.nc"));
}

TEST(ForecastMembers, AreRoundedOnceThoughTheForecastIsLongerThanAChunk) {
  // 30 levels x 241 stamps x 50 members fill more than one chunk for a single column.
  const Snapshot written =
      made_up_forecast({.columns = 2, .levels = 30, .hours = 240, .members = 51});
  const Snapshot read = through_a_file(written);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_LE(worst(read.columns[c].member_m_s, written.columns[c].member_m_s),
              member_step_m_s / 2);
  }
}

TEST(ForecastMembers, OfOneColumnAreThoseOfTheWholeFile) {
  const TemporaryFolder folder;
  write_forecast(folder / "f.nc", made_up_forecast({.columns = 5}));
  const Snapshot whole = read_forecast(folder / "f.nc");
  Snapshot part = read_forecast(folder / "f.nc", Members::none);
  EXPECT_EQ(part.members, whole.members) << "as issued, though left in the file";
  for (const ForecastColumn& column : part.columns) {
    EXPECT_TRUE(column.member_m_s.empty());
    EXPECT_TRUE(column.wind_member_m_s.empty());
  }
  read_members(folder / "f.nc", part, 3);
  EXPECT_EQ(part.columns[3].member_m_s, whole.columns[3].member_m_s);
  EXPECT_EQ(part.columns[3].wind_member_m_s, whole.columns[3].wind_member_m_s);
  EXPECT_TRUE(part.columns[2].member_m_s.empty());
}

TEST(ForecastMembers, AreNotNeededInEveryColumnNorWithEveryWind) {
  Snapshot written = made_up_forecast({.columns = 3, .members = 4});
  written.columns[1].member_m_s.clear();
  for (ForecastColumn& column : written.columns) column.wind_member_m_s.clear();
  const Snapshot read = through_a_file(written);
  EXPECT_EQ(read.members, 4U);
  EXPECT_TRUE(read.columns[1].member_m_s.empty());
  EXPECT_EQ(read.columns[2].member_m_s.size(), written.columns[2].member_m_s.size());
  EXPECT_TRUE(read.columns[2].wind_member_m_s.empty());
}

/// The members of a made-up forecast with the numbers of a weather ensemble's.
Snapshot numbered_forecast(std::size_t columns) {
  Snapshot s = made_up_forecast({.columns = columns, .members = 5});
  s.wind_ensemble = "NWP_ecmf issued 2025-03-10T00:00:00Z";
  for (ForecastColumn& column : s.columns) column.wind_member_number = {3, 7, 50, 12};
  return s;
}

TEST(ForecastMembers, KeepTheNumbersOfTheWindsThatDriveThem) {
  for (const std::size_t columns : {1U, 3U}) {
    Snapshot written = numbered_forecast(columns);
    if (columns > 1) written.columns[1].wind_member_number.clear();
    const Snapshot read = through_a_file(written);
    EXPECT_EQ(read.wind_ensemble, written.wind_ensemble);
    for (std::size_t c = 0; c < columns; ++c)
      EXPECT_EQ(read.columns[c].wind_member_number, written.columns[c].wind_member_number) << c;
  }
  const TemporaryFolder folder;
  write_forecast(folder / "f.nc", numbered_forecast(3));
  Snapshot part = read_forecast(folder / "f.nc", Members::none);
  EXPECT_TRUE(part.columns[2].wind_member_number.empty());
  read_members(folder / "f.nc", part, 2);
  EXPECT_EQ(part.columns[2].wind_member_number, (std::vector{3, 7, 50, 12}));
  EXPECT_TRUE(part.columns[0].wind_member_number.empty());
  EXPECT_EQ(through_a_file(made_up_forecast({.members = 5})).wind_ensemble, "")
      << "without an ensemble the file says nothing of one";
}

TEST(ForecastMembers, OfTheWindStandWithoutCurrents) {
  Snapshot written = made_up_forecast({.members = 4});
  written.depth_m.clear();
  ForecastColumn& column = written.columns[0];
  column.current_m_s.clear();
  column.current_sigma_m_s.clear();
  column.current_status.clear();
  column.member_m_s.clear();
  const Snapshot read = through_a_file(written);
  EXPECT_LE(worst(read.columns[0].wind_member_m_s, column.wind_member_m_s),
            wind_member_step_m_s / 2);
  EXPECT_TRUE(read.columns[0].member_m_s.empty());
}

TEST(ForecastMembers, LeaveOneVariableForEachNameAndItsDimensions) {
  const TemporaryFolder folder;
  for (const std::size_t columns : {1U, 3U}) {
    write_forecast(folder / "f.nc", made_up_forecast({.columns = columns}));
    const auto file = netcdf::File::open(folder / "f.nc");
    std::vector<std::string> central{"time", "depth"};
    if (columns > 1) central.emplace_back("column");
    std::vector<std::string> members = central;
    members.emplace_back("realization");
    for (const std::string name : {"eastward_sea_water_velocity", "northward_sea_water_velocity"}) {
      int found = 0;
      for (const netcdf::Variable& variable : file.variables()) {
        if (variable.text("standard_name") != name) continue;
        found += variable.dimensions == central ? 1 : 0;
        EXPECT_EQ(variable.name, variable.dimensions == central ? name : name + "_member");
        EXPECT_TRUE(variable.dimensions == central || variable.dimensions == members);
      }
      EXPECT_EQ(found, 1) << name;
      ASSERT_NE(file.find(name + "_member"), nullptr);
      EXPECT_TRUE(file.find(name + "_member")->compressed);
      EXPECT_EQ(file.find(name + "_member")->text("units"), "m s-1");
    }
    const netcdf::Variable* realization = file.find("realization");
    ASSERT_NE(realization, nullptr);
    EXPECT_EQ(realization->type, netcdf::Type::int32);
    EXPECT_EQ(realization->text("standard_name"), "realization");
    EXPECT_EQ(file.read_all(*realization).front(), 1) << "member 0 is not kept twice";
    EXPECT_EQ(file.read_all(*realization).back(), 20);
  }
}

TEST(ForecastMembers, DeflateToHalfTheirFloats) {
  const TemporaryFolder folder;
  const Snapshot with = made_up_forecast({.columns = 20});
  const Snapshot without = made_up_forecast({.columns = 20, .members = 1});
  write_forecast(folder / "with.nc", with);
  write_forecast(folder / "without.nc", without);
  const auto bytes = static_cast<double>(std::filesystem::file_size(folder / "with.nc") -
                                         std::filesystem::file_size(folder / "without.nc"));
  const auto numbers = 2.0 * 20 *
                       static_cast<double>(with.columns[0].member_m_s.size() +
                                           with.columns[0].wind_member_m_s.size());
  EXPECT_LT(bytes / numbers, 2.2);  // bytes for each number; 1.9 on this made-up sea
}

TEST(ForecastMembers, WrongSizesAndMissingNumbersAreTheMakersBug) {
  const TemporaryFolder folder;
  const auto written_after = [&](const std::function<void(Snapshot&)>& change) {
    Snapshot s = made_up_forecast({.members = 3});
    change(s);
    write_forecast(folder / "f.nc", s);
  };
  EXPECT_NO_THROW(written_after([](Snapshot&) {}));
  EXPECT_THROW(written_after([](Snapshot& s) { s.members = 4; }), ContractViolation);
  EXPECT_THROW(written_after([](Snapshot& s) { s.members = 0; }), ContractViolation);
  EXPECT_THROW(written_after([](Snapshot& s) { s.columns[0].member_m_s.pop_back(); }),
               ContractViolation);
  EXPECT_THROW(written_after([](Snapshot& s) { s.columns[0].wind_member_m_s.pop_back(); }),
               ContractViolation);
  EXPECT_THROW(written_after([](Snapshot& s) {
                 s.columns[0].member_m_s[7] = {std::nan(""), 0};
               }),
               ContractViolation);
  EXPECT_THROW(written_after([](Snapshot& s) {
                 s.columns[0].member_m_s[7] = {0, 1e30};
               }),
               ContractViolation);
}

}  // namespace
}  // namespace slackwater::ingest::forecast_members_test
