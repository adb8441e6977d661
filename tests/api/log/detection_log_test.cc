#include "api/log/detection_log.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api::detection_log_test {
namespace {

using slackwater::tests::contains;

ingest::TrajectoryFile run_of_two() {
  ingest::TrajectoryFile log;
  log.names = {"boat", "rov"};
  log.t_s = {0, 1};
  log.attributes = {{"title", "a run"}};
  log.variables = {{"x", "", "m", "east", 1, {0, 1, 2, 3}}};
  ingest::TrajectoryTable other;
  other.name = "event";
  other.columns = {{"time", "s", "of it", {0.5}}};
  log.tables = {other};
  return log;
}

DetectorRecord record_of_the_rov() {
  DetectorRecord record{1, "rov_camera", "rust_and_cracks", 12, {}, {}};
  record.kinds = {{"corrosion", 4, 3, 2}, {"crack", 1, 0, 5}};
  record.finds = {
      {"corrosion", "A01/monopile", 3.5, 0.75, 10, 20, 30, 40, {1, 2, 9}, 1.5, 0.2, 0, 7},
      {"crack", "A01/anodes", 4.5, 0.5, 100, 0, 3, 400, {-1, 2.5, 8}, 1.25, 0.4, 1, std::nullopt}};
  return record;
}

void expect_same(const DetectorRecord& found, const DetectorRecord& expected) {
  EXPECT_EQ(found.vehicle, expected.vehicle);
  EXPECT_EQ(found.sensor, expected.sensor);
  EXPECT_EQ(found.detector, expected.detector);
  EXPECT_EQ(found.pictures, expected.pictures);
  ASSERT_EQ(found.kinds.size(), expected.kinds.size());
  for (std::size_t i = 0; i < found.kinds.size(); ++i) {
    EXPECT_EQ(found.kinds[i].of, expected.kinds[i].of);
    EXPECT_EQ(found.kinds[i].in_view, expected.kinds[i].in_view);
    EXPECT_EQ(found.kinds[i].found, expected.kinds[i].found);
    EXPECT_EQ(found.kinds[i].false_alarms, expected.kinds[i].false_alarms);
  }
  ASSERT_EQ(found.finds.size(), expected.finds.size());
  for (std::size_t i = 0; i < found.finds.size(); ++i) {
    const LoggedFind &a = found.finds[i], &b = expected.finds[i];
    EXPECT_EQ(a.of, b.of);
    EXPECT_EQ(a.surface, b.surface);
    EXPECT_EQ(a.t_s, b.t_s);
    EXPECT_EQ(a.confidence, b.confidence);
    EXPECT_EQ((std::vector{a.left_px, a.top_px, a.wide_px, a.high_px}),
              (std::vector{b.left_px, b.top_px, b.wide_px, b.high_px}));
    EXPECT_EQ((std::vector{a.place_m.x, a.place_m.y, a.place_m.z}),
              (std::vector{b.place_m.x, b.place_m.y, b.place_m.z}));
    EXPECT_EQ(a.range_m, b.range_m);
    EXPECT_EQ(a.size_m, b.size_m);
    EXPECT_EQ(a.finding, b.finding);
    EXPECT_EQ(a.defect, b.defect);
  }
}

/// Of a log as it comes back from its file.
ingest::TrajectoryFile filed(const ingest::TrajectoryFile& log) {
  const tests::TemporaryFolder folder;
  ingest::write_trajectories(log, folder / "log.nc");
  return ingest::read_trajectories(folder / "log.nc");
}

TEST(DetectionLog, ComesBackFromTheFile) {
  ingest::TrajectoryFile log = run_of_two();
  EXPECT_TRUE(detections_in(log).empty());
  add_detections(record_of_the_rov(), log);
  const auto records = detections_in(filed(log));
  ASSERT_EQ(records.size(), 1U);
  expect_same(records[0], record_of_the_rov());
}

TEST(DetectionLog, TheSameDetectorOnTheSameCameraCountsOnceAndOthersStay) {
  ingest::TrajectoryFile log = run_of_two();
  DetectorRecord other = record_of_the_rov();
  other.vehicle = 0;
  add_detections(record_of_the_rov(), log);
  add_detections(other, log);
  DetectorRecord again = record_of_the_rov();
  again.pictures = 30;
  again.finds.pop_back();
  add_detections(again, log);
  const auto records = detections_in(filed(log));
  ASSERT_EQ(records.size(), 2U);
  expect_same(records[0], other);
  expect_same(records[1], again);
}

TEST(DetectionLog, OneThatFoundNothingIsKept) {
  ingest::TrajectoryFile log = run_of_two();
  DetectorRecord blind = record_of_the_rov();
  blind.finds.clear();
  add_detections(blind, log);
  const auto records = detections_in(filed(log));
  ASSERT_EQ(records.size(), 1U);
  expect_same(records[0], blind);
}

TEST(DetectionLog, TakenOffTheRunIsAsItWas) {
  ingest::TrajectoryFile log = run_of_two();
  EXPECT_FALSE(take_off_detections(log));
  add_detections(record_of_the_rov(), log);
  EXPECT_TRUE(take_off_detections(log));
  ASSERT_EQ(log.tables.size(), 1U);
  EXPECT_EQ(log.tables[0].name, "event");
}

TEST(DetectionLog, RefusesWhatDoesNotFit) {
  const auto refusal_with = [](const std::string& column, double value) {
    ingest::TrajectoryFile log = run_of_two();
    add_detections(record_of_the_rov(), log);
    for (ingest::TrajectoryTable& table : log.tables)
      for (ingest::TrajectoryTable::Column& one : table.columns)
        if (table.name + "_" + one.name == column) one.values[0] = value;
    try {
      (void)detections_in(log);
    } catch (const Error& error) {
      return error.message();
    }
    return std::string();
  };
  EXPECT_TRUE(contains(refusal_with("detector_kind_vehicle", 2), "a number below 2"));
  EXPECT_TRUE(contains(refusal_with("detector_kind_found", -1), "expected a count"));
  EXPECT_TRUE(contains(refusal_with("detection_vehicle", 0), "a detector that did not look"));
  EXPECT_TRUE(contains(refusal_with("detection_defect", 0.5), "expected a count"));
  EXPECT_EQ(refusal_with("detection_range", 2), "");
}

}  // namespace
}  // namespace slackwater::api::detection_log_test
