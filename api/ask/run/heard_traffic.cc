#include "api/ask/run/heard_traffic.h"

#include <algorithm>
#include <map>

#include "api/ask/run/ais_traffic.h"
#include "api/log/traffic_tables.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "ingest/ais/read_ais.h"
#include "twin/traffic/jumps.h"

namespace slackwater::api {
namespace {

using twin::AisLog;
using twin::TrafficVessel;

/// What of a log is wanted.
struct Wanted {
  UtcTime from;  ///< of the log's time
  UtcTime to;
  GeoPoint origin;
};

struct Heard {
  std::vector<ingest::AisTrack> tracks;
  std::vector<std::string> warnings;
};

/// What a log holds, to say what it does not.
struct Contents {
  std::optional<UtcTime> first;
  std::optional<UtcTime> last;
  std::map<std::uint32_t, std::string> vessels;  ///< names, where known

  void add(const ingest::AisReport& report) {
    std::string& name = vessels[report.mmsi];
    if (report.identity.name) name = *report.identity.name;
    if (!report.time || !report.position) return;
    first = first ? std::min(*first, *report.time) : *report.time;
    last = last ? std::max(*last, *report.time) : *report.time;
  }
  [[nodiscard]] std::string some() const {
    constexpr std::size_t most = 8;
    std::string text;
    std::size_t count = 0;
    for (const auto& [mmsi, name] : vessels) {
      if (++count > most) return text + " and " + std::to_string(vessels.size() - most) + " more";
      text +=
          (count > 1 ? ", " : "") + std::to_string(mmsi) + (name.empty() ? "" : " (" + name + ")");
    }
    return text;
  }
};

Heard hear(const std::filesystem::path& file, const AisLog& log, const Wanted& wanted) {
  constexpr std::size_t most_positions = 1'000'000;  // as `AisTrackOptions`
  ingest::AisTrackCollector collector;
  Contents contents;
  const auto is_asked_for = [&](std::uint32_t mmsi) {
    return log.mmsi.empty() || std::find(log.mmsi.begin(), log.mmsi.end(), mmsi) != log.mmsi.end();
  };
  const ingest::AisReading reading = ingest::read_ais(file, [&](const ingest::AisReport& heard) {
    contents.add(heard);
    if (!is_asked_for(heard.mmsi)) return;
    ingest::AisReport report = heard;
    const bool is_then = report.time && *report.time >= wanted.from && *report.time <= wanted.to;
    if (!is_then || (report.position && distance_m(*report.position, wanted.origin) > log.reach_m))
      report.position.reset();  // what it says of itself still counts
    collector.add(report);
    if (collector.positions() > most_positions)
      refuse(file.string() + ": found more than " + std::to_string(most_positions) +
             " positions near the origin; name vessels (mmsi) or lower reach_km");
  });
  for (const std::uint32_t mmsi : log.mmsi)
    if (!contents.vessels.contains(mmsi))
      refuse(file.string() + ": holds no vessel " + std::to_string(mmsi) + "; it holds " +
             contents.some());
  if (!contents.first) {
    std::string why;
    for (const std::string& warning : reading.warnings()) why += "; " + warning;
    if (const std::string passed = reading.passed_over(); !passed.empty()) why += "; " + passed;
    refuse(file.string() +
           ": holds no position with a time; expected a time in front of each line, $PGHP lines or "
           "tag blocks" +
           why);
  }
  if (*contents.last < wanted.from || *contents.first > wanted.to)
    refuse(file.string() + ": holds positions from " + format_utc(*contents.first) + " to " +
           format_utc(*contents.last) + ", and the run asks for " + format_utc(wanted.from) +
           " to " + format_utc(wanted.to) +
           "; set `starts`: the time in the log at which the run starts");
  Heard out{std::move(collector).take(), {}};
  for (const std::string& warning : reading.warnings())
    out.warnings.push_back(file.string() + ": " + warning);
  return out;
}

/// The reports of one vessel from all logs.
struct Gathered {
  TrafficVessel vessel;
  std::vector<twin::TrackPoint> points;
};

class Gathering {
 public:
  void add(const TrafficVessel& vessel, bool is_around) {
    const auto [found, is_new] = vessels_.try_emplace(vessel.id);
    Gathered& one = found->second;
    if (is_new) {
      one.vessel = vessel;
      one.vessel.is_around = is_around;
    }
    one.vessel.is_around = one.vessel.is_around || is_around;
    if (one.vessel.name.empty()) one.vessel.name = vessel.name;
    if (!one.vessel.length_m) one.vessel.length_m = vessel.length_m;
    if (!one.vessel.beam_m) one.vessel.beam_m = vessel.beam_m;
    const auto points = vessel.track.points();
    one.points.insert(one.points.end(), points.begin(), points.end());
  }

  /// By MMSI, in pieces without jumps.
  [[nodiscard]] std::vector<TrafficVessel> vessels(std::vector<std::string>& warnings) {
    std::vector<TrafficVessel> out;
    std::size_t strays = 0, stray_vessels = 0;
    for (auto& [mmsi, one] : vessels_) {
      std::stable_sort(one.points.begin(), one.points.end(),
                       [](const auto& a, const auto& b) { return a.t_s < b.t_s; });
      const auto is_same_time = [](const auto& a, const auto& b) { return a.t_s == b.t_s; };
      one.points.erase(std::unique(one.points.begin(), one.points.end(), is_same_time),
                       one.points.end());
      twin::SteadyPieces steady = twin::cut_at_jumps(one.points);
      strays += steady.strays;
      stray_vessels += steady.strays > 0 ? 1U : 0U;
      for (const twin::Jump& jump : steady.jumps)
        warnings.push_back("vessel " + std::to_string(mmsi) + " jumps by " +
                           std::to_string(static_cast<long>(jump.distance_m)) + " m between " +
                           std::to_string(static_cast<long>(jump.from_s)) + " and " +
                           std::to_string(static_cast<long>(jump.to_s)) +
                           " s of the run: its track is cut there");
      for (std::vector<twin::TrackPoint>& piece : steady.pieces) {
        out.push_back(one.vessel);
        out.back().track = twin::Track(std::move(piece));
      }
    }
    if (strays > 0)
      warnings.push_back(std::to_string(strays) + " positions of " + std::to_string(stray_vessels) +
                         " vessels have impossible positions and are left out");
    return out;
  }

 private:
  std::map<std::uint32_t, Gathered> vessels_;
};

/// The logs of the traffic and of the tasks.
std::vector<AisLog> logs_of(const twin::Scenario& scenario) {
  std::vector<AisLog> logs = scenario.traffic.logs;
  for (const twin::ScenarioVehicle& vehicle : scenario.vehicles)
    for (const twin::ScenarioTask& task : vehicle.tasks)
      if (task.follow && task.follow->log) logs.push_back(*task.follow->log);
  return logs;
}

}  // namespace

void add_heard_traffic(const twin::Scenario& scenario, const std::filesystem::path& scenario_folder,
                       ScenarioWater& water) {
  const std::vector<AisLog> logs = logs_of(scenario);
  if (logs.empty()) return;
  const GeoPoint origin = twin::origin_of(scenario, water.surround.site);
  const LocalFrame site(origin);
  const UtcTime start = scenario.start.value_or(water.surround.field->range().from);
  // A report outside of the run may be one end of a leg that reaches into it.
  const auto margin =
      Duration(static_cast<Duration::rep>(1000 * twin::TrackRule{}.longest_gap_s) + 60'000);
  const auto length = Duration(static_cast<Duration::rep>(1000 * scenario.duration_s));
  Gathering gathering;
  std::map<std::string, std::string> sums;
  for (const AisLog& log : logs) {
    const std::filesystem::path named = log.file;
    const std::filesystem::path file = named.is_absolute() ? named : scenario_folder / named;
    const UtcTime starts = log.starts.value_or(start);
    Heard heard = with_context("traffic", [&] {
      return hear(file, log, {starts - margin, starts + length + margin, origin});
    });
    const std::vector<TrafficVessel> near =
        traffic_on_site(heard.tracks, site, starts, log.reach_m);
    for (const TrafficVessel& vessel : near) gathering.add(vessel, log.is_around);
    if (near.empty())
      heard.warnings.push_back(file.string() + ": no vessel is within " +
                               std::to_string(static_cast<long>(log.reach_m / 1000)) +
                               " km of the origin during the run");
    water.warnings.insert(water.warnings.end(), heard.warnings.begin(), heard.warnings.end());
    sums[named.filename().string()] = sha256_of_file(file);
  }
  water.surround.vessels = gathering.vessels(water.warnings);
  for (const auto& [name, sum] : sums)
    water.traffic_files += (water.traffic_files.empty() ? "" : ", ") + name + " " + sum;
}

void add_logged_traffic(const ingest::TrajectoryFile& log, const twin::Scenario& scenario,
                        ScenarioWater& water) {
  water.traffic_files = log.attribute("traffic_files_sha256");
  if (logs_of(scenario).empty() && water.traffic_files.empty()) return;
  for (TrafficVessel& vessel : vessels_in(log)) {
    const auto& laid = scenario.traffic.vessels;
    const bool is_laid =
        std::any_of(laid.begin(), laid.end(),
                    [&](const twin::MadeUpVessel& other) { return other.mmsi == vessel.id; });
    if (!is_laid) water.surround.vessels.push_back(std::move(vessel));
  }
}

}  // namespace slackwater::api
