#include "api/show/rehearse/detections_report.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "api/show/report/html_page.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// A place that was reported, by its surest find.
struct Place {
  const LoggedFind* surest = nullptr;
  std::size_t pictures = 0;
  bool is_true = false;
};

std::vector<Place> places_of(const DetectorRecord& record) {
  std::map<std::size_t, Place> places;
  std::map<std::size_t, double> last_t_s;
  for (const LoggedFind& find : record.finds) {
    Place& place = places[find.finding];
    if (place.surest == nullptr || find.confidence > place.surest->confidence) place.surest = &find;
    const auto [last, is_first] = last_t_s.emplace(find.finding, find.t_s);
    // Two finds of one picture may lie at one place; the picture counts once.
    if (is_first || last->second != find.t_s) ++place.pictures;
    last->second = find.t_s;
    place.is_true |= find.defect.has_value();
  }
  std::vector<Place> out;
  for (const auto& [number, place] : places) out.push_back(place);
  std::stable_sort(out.begin(), out.end(), [](const Place& a, const Place& b) {
    return a.surest->confidence > b.surest->confidence;
  });
  return out;
}

std::size_t places_of_kind(const std::vector<Place>& places, const std::string& kind) {
  return static_cast<std::size_t>(std::count_if(
      places.begin(), places.end(), [&](const Place& place) { return place.surest->of == kind; }));
}

ReportTable how_much(const std::vector<DetectorRecord>& records,
                     const std::vector<std::string>& vehicles, bool shows_truth) {
  ReportTable table;
  table.title = "What detectors found in its pictures";
  table.columns = {"Vehicle", "Camera", "Detector", "Pictures", "Kind", "Places reported"};
  if (shows_truth)
    for (const char* column : {"Planted in view", "Found", "False alarms"})
      table.columns.emplace_back(column);
  for (const DetectorRecord& record : records) {
    const std::vector<Place> places = places_of(record);
    for (const KindFound& kind : record.kinds) {
      table.rows.push_back({vehicles.at(record.vehicle), record.sensor, record.detector,
                            std::to_string(record.pictures), kind.of,
                            std::to_string(places_of_kind(places, kind.of))});
      if (!shows_truth) continue;
      for (const std::size_t count : {kind.in_view, kind.found, kind.false_alarms})
        table.rows.back().push_back(std::to_string(count));
    }
  }
  return table;
}

ReportTable where(const std::vector<DetectorRecord>& records,
                  const std::vector<std::string>& vehicles, bool shows_truth) {
  constexpr std::size_t most_rows = 200;
  ReportTable table;
  table.title = "Where they found it";
  table.columns = {"Vehicle", "Kind",       "Surface", "Depth m", "Size m",
                   "After s", "Confidence", "Range m", "Pictures"};
  if (shows_truth) table.columns.emplace_back("Truth");
  std::size_t places_in_all = 0;
  for (const DetectorRecord& record : records)
    for (const Place& place : places_of(record)) {
      if (++places_in_all > most_rows) continue;
      const LoggedFind& find = *place.surest;
      table.rows.push_back({vehicles.at(record.vehicle), find.of, find.surface,
                            formatted("{:.1f}", find.place_m.z), formatted("{:.2f}", find.size_m),
                            formatted("{:.1f}", find.t_s), formatted("{:.2f}", find.confidence),
                            formatted("{:.2f}", find.range_m), std::to_string(place.pictures)});
      if (shows_truth) table.rows.back().emplace_back(place.is_true ? "found" : "false alarm");
    }
  table.note = "Finds of one kind at one place are one row, by the surest of them.";
  if (places_in_all > most_rows)
    table.note += formatted(" The first {} of {}; the log has them all.", most_rows, places_in_all);
  return table;
}

}  // namespace

std::string detections_text(const std::vector<DetectorRecord>& records, std::size_t vehicle,
                            const std::string& whose) {
  std::string out;
  for (const DetectorRecord& record : records) {
    if (record.vehicle != vehicle) continue;
    out += formatted("{}: {} in {} of {}:", whose, record.detector,
                     counted(record.pictures, "picture"), record.sensor);
    const char* between = " ";
    for (const KindFound& kind : record.kinds) {
      out += formatted("{}{} {} of {} planted in view found, {}", between, kind.of, kind.found,
                       kind.in_view, counted(kind.false_alarms, "false alarm"));
      between = "; ";
    }
    out += "\n";
  }
  return out;
}

nlohmann::json kinds_found_json(const std::vector<KindFound>& kinds) {
  nlohmann::json out = nlohmann::json::array();
  for (const KindFound& kind : kinds)
    out.push_back({{"of", kind.of},
                   {"in_view", kind.in_view},
                   {"found", kind.found},
                   {"false_alarms", kind.false_alarms}});
  return out;
}

nlohmann::json detections_json(const std::vector<DetectorRecord>& records, std::size_t vehicle) {
  using Json = nlohmann::json;
  Json out = Json::array();
  for (const DetectorRecord& record : records) {
    if (record.vehicle != vehicle) continue;
    out.push_back({{"sensor", record.sensor},
                   {"detector", record.detector},
                   {"pictures", record.pictures},
                   {"kinds", kinds_found_json(record.kinds)}});
  }
  return out;
}

std::string detections_html(const std::vector<DetectorRecord>& records,
                            const std::vector<std::string>& vehicles, bool shows_truth) {
  if (records.empty()) return {};
  return table_html(how_much(records, vehicles, shows_truth)) +
         table_html(where(records, vehicles, shows_truth));
}

}  // namespace slackwater::api
