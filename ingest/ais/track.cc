#include "ingest/ais/track.h"

#include <algorithm>

namespace slackwater::ingest {
namespace {

template <typename Value>
void renew(std::optional<Value>& known, const std::optional<Value>& heard) {
  if (heard) known = heard;
}

/// Sorted, one position at a time.
void settle(std::vector<AisPosition>& positions) {
  std::stable_sort(positions.begin(), positions.end(),
                   [](const AisPosition& a, const AisPosition& b) { return a.time < b.time; });
  const auto repeated =
      std::unique(positions.begin(), positions.end(),
                  [](const AisPosition& a, const AisPosition& b) { return a.time == b.time; });
  positions.erase(repeated, positions.end());
}

}  // namespace

void renew(AisIdentity& known, const AisIdentity& heard) {
  renew(known.name, heard.name);
  renew(known.callsign, heard.callsign);
  renew(known.ship_type, heard.ship_type);
  renew(known.imo, heard.imo);
  renew(known.length_m, heard.length_m);
  renew(known.beam_m, heard.beam_m);
  renew(known.antenna_from_bow_m, heard.antenna_from_bow_m);
  renew(known.antenna_from_port_m, heard.antenna_from_port_m);
}

UtcTime time_of_position(UtcTime received, const std::optional<int>& utc_second) noexcept {
  if (!utc_second) return received;
  using std::chrono::minutes;
  constexpr Duration early = std::chrono::seconds(2);
  const Duration within = std::chrono::seconds(*utc_second);
  const UtcTime newest = received + early;
  return std::chrono::floor<minutes>(newest - within) + within;
}

void AisTrackCollector::add(const AisReport& report) {
  AisTrack& track = tracks_[report.mmsi];
  track.mmsi = report.mmsi;
  ++track.reports;
  const bool has_position = report.time && report.position;
  if (has_position || track.positions.empty()) track.speaker = report.speaker;
  renew(track.identity, report.identity);
  if (!has_position) return;
  ++positions_;
  auto& positions = report.type == 27 ? coarse_[report.mmsi] : track.positions;
  positions.push_back({time_of_position(*report.time, report.utc_second), *report.position,
                       report.speed_over_ground_m_s, report.course_over_ground, report.heading});
}

std::vector<AisTrack> AisTrackCollector::take() && {
  std::vector<AisTrack> result;
  result.reserve(tracks_.size());
  for (auto& [mmsi, track] : tracks_) {
    if (track.positions.empty()) {
      if (const auto coarse = coarse_.find(mmsi); coarse != coarse_.end())
        track.positions = std::move(coarse->second);
    }
    settle(track.positions);
    result.push_back(std::move(track));
  }
  tracks_.clear();
  coarse_.clear();
  positions_ = 0;
  return result;
}

}  // namespace slackwater::ingest
