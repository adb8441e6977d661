#include "api/door/edr/write/format_netcdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "fields/base/error.h"
#include "ingest/netcdf/file.h"
#include "tests/api/door/edr/made_up_answer.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api::edr::format_netcdf_test {
namespace {

using ingest::netcdf::File;
using ingest::netcdf::Variable;
using tests::made_up_answer;
using tests::made_up_value;
using Names = std::vector<std::string>;

constexpr const char* east = "eastward_sea_water_velocity";
constexpr const char* north = "northward_sea_water_velocity";

/// The bytes of an answer, opened as a file.
class Opened {
 public:
  explicit Opened(const Answer& answer) : file_(File::open(put(netcdf(answer)))) {}
  const File& file() const { return file_; }
  const Variable& variable(const std::string& name) const {
    const Variable* found = file_.find(name);
    if (found == nullptr) throw Error(ErrorKind::not_found, "no variable " + name);
    return *found;
  }
  std::vector<double> values(const std::string& name) const {
    return file_.read_all(variable(name));
  }

 private:
  std::filesystem::path put(const std::string& bytes) const {
    std::ofstream(folder_ / "answer.nc", std::ios::binary) << bytes;
    return folder_ / "answer.nc";
  }
  tests::TemporaryFolder folder_;
  File file_;
};

TEST(NetCdf, OnePlaceIsAProfileOverTimeAndDepth) {
  for (const auto& [type, dimensions, count] :
       {std::tuple(DomainType::vertical_profile, Names{"time", "depth"}, 4U),
        std::tuple(DomainType::point_series, Names{"time", "depth"}, 25U),
        std::tuple(DomainType::point, Names{"time", "depth"}, 1U)}) {
    const Opened opened(made_up_answer(type));
    EXPECT_EQ(opened.variable(east).dimensions, dimensions);
    const auto values = opened.values(east);
    ASSERT_EQ(values.size(), count);
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(values[i], made_up_value(0, 0, i));
    EXPECT_GT(opened.values(north)[0], 1e36) << "the fill value, for what is missing";
    EXPECT_EQ(opened.variable(north).number("_FillValue"), opened.values(north)[0]);
    EXPECT_TRUE(opened.variable("latitude").dimensions.empty());
    EXPECT_EQ(opened.file().text("featureType"), "timeSeriesProfile");
    EXPECT_EQ(opened.file().text("Conventions"), "CF-1.8");
  }
}

TEST(NetCdf, TheStandardNameIsOfTheCentralForecastAlone) {
  const Opened opened(made_up_answer(DomainType::point));
  EXPECT_EQ(opened.variable(east).text("standard_name"), east);
  EXPECT_EQ(opened.variable(east).text("units"), "m s-1");
  const Variable& quantile = opened.variable("eastward_sea_water_velocity_p10");
  EXPECT_EQ(quantile.text("standard_name"), std::nullopt);
  EXPECT_EQ(quantile.text("long_name"), "eastward current (quantile 0.1)");
}

TEST(NetCdf, SeveralPlacesAreStations) {
  const Opened opened(made_up_answer(DomainType::point_series, 3));
  EXPECT_EQ(opened.variable(east).dimensions, (Names{"station", "time", "depth"}));
  EXPECT_EQ(opened.values("longitude"), (std::vector<double>{2.45, 3.45, 4.45}));
  EXPECT_EQ(opened.values(east)[2 * 25 + 7], made_up_value(2, 0, 7));
  EXPECT_EQ(opened.variable("station_name").text("cf_role"), "timeseries_id");
}

TEST(NetCdf, ProfilesAtSeveralTimesOfOnePlaceBecomeOneArray) {
  Answer answer = made_up_answer(DomainType::vertical_profile, 2);
  answer.coverages[1].longitude_deg = answer.coverages[0].longitude_deg;
  answer.coverages[1].time[0] += std::chrono::hours(1);
  answer.coverages[1].vertical_m = {0.5, 10.5, 20.5, 35};
  const Opened opened(answer);
  EXPECT_EQ(opened.variable(east).shape, (std::vector<std::size_t>{2, 5}));
  EXPECT_EQ(opened.values("depth"), (std::vector<double>{0.5, 10.5, 20.5, 30.5, 35}));
  const auto values = opened.values(east);
  EXPECT_EQ(values[3], made_up_value(0, 0, 3));
  EXPECT_GT(values[4], 1e36) << "35 m is a level of the second profile alone";
  EXPECT_GT(values[8], 1e36);
  EXPECT_EQ(values[9], made_up_value(1, 0, 3));
}

TEST(NetCdf, AGridRunsOverTimeDepthLatitudeLongitude) {
  const Opened opened(made_up_answer(DomainType::grid));
  EXPECT_EQ(opened.variable(east).dimensions, (Names{"time", "depth", "latitude", "longitude"}));
  EXPECT_EQ(opened.values(east)[47], made_up_value(0, 0, 47));
  EXPECT_EQ(opened.variable("depth").text("positive"), "down");
  const auto time = opened.values("time");
  EXPECT_EQ(time[1] - time[0], 3600);
}

TEST(NetCdf, TrajectoriesFollowEachOther) {
  const Opened opened(made_up_answer(DomainType::trajectory, 2));
  EXPECT_EQ(opened.variable(east).dimensions, Names{"obs"});
  EXPECT_EQ(opened.values("row_size"), (std::vector<double>{5, 5}));
  EXPECT_EQ(opened.values(east)[9], made_up_value(1, 0, 4));
  EXPECT_EQ(opened.values("depth")[9], 20);
  EXPECT_EQ(opened.file().text("featureType"), "trajectory");
}

TEST(NetCdf, HeightsCountUpAndMayBeAbsent) {
  Answer answer = made_up_answer(DomainType::point_series);
  answer.vertical = Vertical::height_up;
  EXPECT_EQ(Opened(answer).variable("altitude").text("positive"), "up");
  answer.vertical = Vertical::none;
  answer.coverages[0].vertical_m.clear();
  const Opened flat(answer);
  EXPECT_EQ(flat.variable(east).dimensions, Names{"time"});
  EXPECT_EQ(flat.file().text("featureType"), "timeSeries");
}

TEST(NetCdf, ProvenanceIsInTheAttributes) {
  const Opened opened(made_up_answer(DomainType::point));
  EXPECT_EQ(opened.file().text("slackwater_instance"), "20250309T0500Z");
  EXPECT_EQ(opened.file().text("references"),
            "© E.U. Copernicus Marine Service Information\nMET Norway, \"CC BY\" 4.0");
  EXPECT_EQ(opened.file().text("slackwater_degraded"), "true");
  EXPECT_EQ(opened.values("forecast_reference_time"),
            (std::vector<double>{seconds_between(UtcTime{}, parse_utc("2025-03-10T00:00:00Z"))}));
}

TEST(NetCdf, WhatCannotBeOneFileIsRefused) {
  try {
    (void)netcdf(made_up_answer(DomainType::grid, 0));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
  }
  // 150 series at 150 places, no two with a time in common: the array would be empty but for 1/150.
  Answer answer = made_up_answer(DomainType::point_series, 150);
  for (std::size_t c = 0; c < 150; ++c) {
    for (UtcTime& time : answer.coverages[c].time) time += std::chrono::hours(100 * c);
    answer.coverages[c].vertical_m = {static_cast<double>(c)};
  }
  try {
    (void)netcdf(answer);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_NE(error.message().find("share axes"), std::string::npos) << error.message();
  }
}

TEST(NetCdf, LeavesNothingBehind) {
  const auto count = [] {
    std::size_t folders = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::temp_directory_path())) {
      if (std::filesystem::exists(entry.path() / "answer.nc")) ++folders;
    }
    return folders;
  };
  const std::size_t before = count();
  (void)netcdf(made_up_answer(DomainType::point));
  EXPECT_EQ(count(), before);
}

}  // namespace
}  // namespace slackwater::api::edr::format_netcdf_test
