#include "api/log/detection_log.h"

#include <algorithm>
#include <cmath>

#include "api/log/table_reader.h"
#include "api/log/table_rows.h"
#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

constexpr const char* kind_table = "detector_kind";
constexpr const char* find_table = "detection";

TableRows kind_rows() {
  return {kind_table,
          {{"vehicle", "1", "whose camera it was, from 0", {}},
           {"pictures", "1", "that the detector looked at", {}},
           {"in_view", "1", "planted defects of the kind that some picture shows", {}},
           {"found", "1", "of these", {}},
           {"false_alarms", "1", "places that were reported, with nothing of the kind there", {}}},
          {{"sensor", "of which the pictures are", {}},
           {"detector", "that looked at them", {}},
           {"kind", "of defect", {}}}};
}

TableRows find_rows() {
  return {find_table,
          {{"vehicle", "1", "whose camera it was, from 0", {}},
           {"time", "s", "of the picture, since the start", {}},
           {"confidence", "1", "of the detector, from 0 to 1", {}},
           {"left", "1", "of the box in the picture, in pixels", {}},
           {"top", "1", "of the box in the picture, in pixels", {}},
           {"wide", "1", "of the box in the picture, in pixels", {}},
           {"high", "1", "of the box in the picture, in pixels", {}},
           {"x", "m", "of the place, east of the origin", {}},
           {"y", "m", "of the place, north of the origin", {}},
           {"z", "m", "of the place, above mean sea level", {}},
           {"range", "m", "from which it was seen", {}},
           {"size", "m", "of its longest side", {}},
           {"finding", "1", "finds of one place have the same number, from 0", {}},
           {"defect", "1", "its number in the made-up truth; -1: there is none", {}}},
          {{"sensor", "of which the picture is", {}},
           {"detector", "that looked at it", {}},
           {"kind", "of defect", {}},
           {"surface", "that it is on", {}}}};
}

bool is_of(const DetectorRecord& record, std::size_t vehicle, const std::string& sensor,
           const std::string& detector) {
  return record.vehicle == vehicle && record.sensor == sensor && record.detector == detector;
}

void write(const std::vector<DetectorRecord>& records, ingest::TrajectoryFile& log) {
  TableRows kinds = kind_rows(), finds = find_rows();
  for (const DetectorRecord& record : records) {
    const auto vehicle = static_cast<double>(record.vehicle);
    for (const KindFound& kind : record.kinds)
      kinds.add({vehicle, static_cast<double>(record.pictures), static_cast<double>(kind.in_view),
                 static_cast<double>(kind.found), static_cast<double>(kind.false_alarms)},
                {record.sensor, record.detector, kind.of});
    for (const LoggedFind& find : record.finds)
      finds.add({vehicle, find.t_s, find.confidence, find.left_px, find.top_px, find.wide_px,
                 find.high_px, find.place_m.y, find.place_m.x, -find.place_m.z, find.range_m,
                 find.size_m, static_cast<double>(find.finding),
                 find.defect ? static_cast<double>(*find.defect) : -1.0},
                {record.sensor, record.detector, find.of, find.surface});
  }
  log.tables.push_back(kinds.take());
  log.tables.push_back(finds.take());
}

LoggedFind find_in(const TableReader& table, std::size_t row) {
  LoggedFind find;
  find.of = table.text("kind", row);
  find.surface = table.text("surface", row);
  find.t_s = table.number("time", row);
  find.confidence = table.number("confidence", row);
  find.left_px = table.number("left", row);
  find.top_px = table.number("top", row);
  find.wide_px = table.number("wide", row);
  find.high_px = table.number("high", row);
  find.place_m = {table.number("y", row), table.number("x", row), -table.number("z", row)};
  find.range_m = table.number("range", row);
  find.size_m = table.number("size", row);
  find.finding = table.whole("finding", row);
  if (table.number("defect", row) != -1)
    find.defect = static_cast<std::uint32_t>(table.whole("defect", row));
  return find;
}

}  // namespace

std::vector<DetectorRecord> detections_in(const ingest::TrajectoryFile& log) {
  std::vector<DetectorRecord> records;
  const TableReader kinds(log, kind_table), finds(log, find_table);
  kinds.for_each([&](std::size_t vehicle, std::size_t row) {
    const std::string &sensor = kinds.text("sensor", row), &detector = kinds.text("detector", row);
    if (records.empty() || !is_of(records.back(), vehicle, sensor, detector))
      records.push_back({vehicle, sensor, detector, kinds.whole("pictures", row), {}, {}});
    records.back().kinds.push_back({kinds.text("kind", row), kinds.whole("in_view", row),
                                    kinds.whole("found", row), kinds.whole("false_alarms", row)});
  });
  finds.for_each([&](std::size_t vehicle, std::size_t row) {
    const auto mine = std::find_if(records.begin(), records.end(), [&](const auto& record) {
      return is_of(record, vehicle, finds.text("sensor", row), finds.text("detector", row));
    });
    if (mine == records.end()) finds.refuse("has a find of a detector that did not look");
    mine->finds.push_back(find_in(finds, row));
  });
  return records;
}

bool take_off_detections(ingest::TrajectoryFile& log) {
  return std::erase_if(log.tables, [](const ingest::TrajectoryTable& table) {
           return table.name == kind_table || table.name == find_table;
         }) > 0;
}

void add_detections(const DetectorRecord& record, ingest::TrajectoryFile& log) {
  std::vector<DetectorRecord> records = detections_in(log);
  std::erase_if(records, [&](const DetectorRecord& earlier) {
    return is_of(earlier, record.vehicle, record.sensor, record.detector);
  });
  records.push_back(record);
  (void)take_off_detections(log);
  write(records, log);
}

}  // namespace slackwater::api
