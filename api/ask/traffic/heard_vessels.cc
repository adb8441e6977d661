#include "api/ask/traffic/heard_vessels.h"

#include <algorithm>

namespace slackwater::api {
namespace {

constexpr std::size_t weight_of_vessel = 5;  // of positions
constexpr std::size_t most_identities = 50;  // who says another name each time
constexpr std::size_t most_minutes = 100'000;

std::chrono::sys_time<std::chrono::minutes> minute_of(UtcTime time) {
  return std::chrono::floor<std::chrono::minutes>(time);
}

}  // namespace

bool HeardVessels::insert(std::vector<Heard>& into, const Heard& heard) {
  const auto at =
      std::lower_bound(into.begin(), into.end(), heard.position.time,
                       [](const Heard& one, UtcTime time) { return one.position.time < time; });
  if (at != into.end() && at->position.time == heard.position.time) {
    if (heard.received < at->received) *at = heard;  // several stations heard it
    return false;
  }
  into.insert(at, heard);
  return true;
}

void HeardVessels::note_time(UtcTime received) {
  first_ = first_ ? std::min(*first_, received) : received;
  const auto at =
      std::lower_bound(minutes_.begin(), minutes_.end(), received,
                       [](UtcTime one, UtcTime time) { return minute_of(one) < minute_of(time); });
  if (at != minutes_.end() && minute_of(*at) == minute_of(received))
    *at = std::max(*at, received);
  else
    minutes_.insert(at, received);
  if (minutes_.size() > most_minutes) minutes_.erase(minutes_.begin());
}

void HeardVessels::learn(Vessel& vessel, const ingest::AisReport& report) {
  const UtcTime since = report.time ? *report.time : last().value_or(UtcTime::min());
  ingest::AisIdentity identity;
  if (!vessel.known.empty()) {
    if (since < vessel.known.back().since) return;  // read again
    identity = vessel.known.back().identity;
  }
  ingest::renew(identity, report.identity);
  if (!vessel.known.empty() && identity == vessel.known.back().identity) return;
  if (identity == ingest::AisIdentity{}) return;
  if (vessel.known.size() == most_identities) vessel.known.erase(vessel.known.begin());
  vessel.known.push_back({since, std::move(identity)});
}

void HeardVessels::add(const ingest::AisReport& report) {
  if (report.time) note_time(*report.time);
  if (report.speaker == ingest::AisClass::base_station ||
      report.speaker == ingest::AisClass::aircraft)
    return;
  const auto [found, is_new] = vessels_.try_emplace(report.mmsi);
  Vessel& vessel = found->second;
  weight_ += is_new ? weight_of_vessel : 0;
  learn(vessel, report);
  if (report.time && report.position) {
    Heard heard;
    heard.received = *report.time;
    heard.speaker = report.speaker;
    // No position is of a time after its receipt: there a clock goes wrong.
    heard.position = {
        std::min(*report.time, ingest::time_of_position(*report.time, report.utc_second)),
        *report.position, report.speed_over_ground_m_s, report.course_over_ground, report.heading};
    weight_ += insert(report.type == 27 ? vessel.coarse : vessel.fine, heard) ? 1 : 0;
  }
  if (weight_ > most_positions_) forget_older_half();
}

void HeardVessels::forget_older_half() {
  std::vector<UtcTime> times;
  for (const auto& [mmsi, vessel] : vessels_)
    for (const auto* heard : {&vessel.fine, &vessel.coarse})
      for (const Heard& one : *heard) times.push_back(one.position.time);
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  const UtcTime since = times.empty() ? UtcTime::max() : *middle;
  const auto is_old = [&](const Heard& one) { return one.position.time < since; };
  weight_ = 0;
  for (auto vessel = vessels_.begin(); vessel != vessels_.end();) {
    auto& [fine, coarse, known] = vessel->second;
    std::erase_if(fine, is_old);
    std::erase_if(coarse, is_old);
    if (fine.empty() && coarse.empty()) {
      vessel = vessels_.erase(vessel);
    } else {
      weight_ += weight_of_vessel + fine.size() + coarse.size();
      ++vessel;
    }
  }
}

const HeardVessels::Heard* HeardVessels::newest(const std::vector<Heard>& heard, UtcTime at) {
  auto one = std::upper_bound(heard.begin(), heard.end(), at, [](UtcTime time, const Heard& other) {
    return time < other.position.time;
  });
  while (one != heard.begin())
    if ((--one)->received <= at) return &*one;
  return nullptr;
}

std::vector<LastHeard> HeardVessels::known_at(UtcTime at) const {
  std::vector<LastHeard> out;
  for (const auto& [mmsi, vessel] : vessels_) {
    const Heard* heard = newest(vessel.fine, at);
    if (heard == nullptr) heard = newest(vessel.coarse, at);
    if (heard == nullptr) continue;
    LastHeard last{mmsi, heard->speaker, {}, heard->position};
    const auto known =
        std::upper_bound(vessel.known.begin(), vessel.known.end(), at,
                         [](UtcTime time, const Known& one) { return time < one.since; });
    if (known != vessel.known.begin()) last.identity = std::prev(known)->identity;
    out.push_back(std::move(last));
  }
  return out;
}

std::optional<UtcTime> HeardVessels::last_received(UtcTime at) const {
  const auto next = std::upper_bound(minutes_.begin(), minutes_.end(), at);
  // Of the minute that is asked about, only its last receipt is known, which may come later.
  std::optional<UtcTime> last;
  if (next != minutes_.begin()) last = *std::prev(next);
  for (const auto& [mmsi, vessel] : vessels_)
    if (const Heard* heard = newest(vessel.fine, at))
      last = last ? std::max(*last, heard->received) : heard->received;
  return last;
}

std::optional<UtcTime> HeardVessels::first() const { return first_; }
std::optional<UtcTime> HeardVessels::last() const {
  return minutes_.empty() ? std::nullopt : std::optional(minutes_.back());
}

}  // namespace slackwater::api
