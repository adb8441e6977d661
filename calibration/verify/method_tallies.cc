#include "calibration/verify/method_tallies.h"

#include <algorithm>
#include <cmath>

namespace slackwater::calibration {
namespace {

/// The hours of a lead bin within what was tallied.
struct HourRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

HourRange hours_of(const LeadBin& lead, std::size_t hours) {
  const auto clamped = [&](double h) {
    return static_cast<std::size_t>(std::clamp(std::round(h), 0.0, static_cast<double>(hours)));
  };
  return {clamped(lead.from_h), clamped(lead.to_h)};
}

}  // namespace

void HourlyTallies::merge(const HourlyTallies& other) noexcept {
  for (std::size_t i = 0; i < std::min(tally_.size(), other.tally_.size()); ++i)
    tally_[i].merge(other.tally_[i]);
}

VectorTally HourlyTallies::over(std::size_t band, const LeadBin& lead) const {
  const HourRange range = hours_of(lead, hours_);
  VectorTally sum;
  for (std::size_t h = range.first; h < range.last; ++h) sum.merge(at(band, h));
  return sum;
}

std::vector<BlockSum> HourlyTallies::six_hour_blocks(std::size_t band, const LeadBin& lead) const {
  const HourRange range = hours_of(lead, hours_);
  std::vector<BlockSum> blocks;
  for (std::size_t h = range.first; h < range.last; ++h) {
    if (blocks.empty() || h % 6 == 0) blocks.emplace_back();
    const BlockSum hour = at(band, h).squares();
    blocks.back().sum += hour.sum;
    blocks.back().weight += hour.weight;
  }
  return blocks;
}

void merge(TalliesByMethod& all, const TalliesByMethod& more) {
  for (const auto& [method, tallies] : more) {
    const auto [found, is_new] = all.try_emplace(method, tallies);
    if (!is_new) found->second.merge(tallies);
  }
}

std::optional<std::size_t> hour_of_lead(UtcTime end_of_day, UtcTime time) noexcept {
  const auto lead = time - end_of_day;
  if (lead.count() <= 0) return std::nullopt;
  constexpr Duration hour = std::chrono::hours(1);
  return static_cast<std::size_t>((lead - Duration(1)) / hour);
}

std::vector<SkillEntry> entries_of(const TalliesByMethod& methods,
                                   const std::vector<DepthBand>& bands,
                                   const VerifyOptions& options, const SkillEntry& blank,
                                   bool with_interval) {
  std::vector<SkillEntry> entries;
  const auto add = [&](std::size_t band, const LeadBin& lead, bool interval) {
    for (const auto& [method, tallies] : methods) {
      const VectorTally tally = tallies.over(band, lead);
      if (tally.size() == 0) continue;
      SkillEntry entry = blank;
      entry.method = method;
      entry.band = bands[band];
      entry.lead = lead;
      entry.vector = tally.score();
      if (interval) {
        Rng random(static_cast<std::uint64_t>(blank.day.time_since_epoch().count()),
                   "verify/bootstrap");
        entry.interval = bootstrap_rms(tallies.six_hour_blocks(band, lead), random);
      }
      entries.push_back(std::move(entry));
    }
  };
  for (std::size_t band = 0; band < bands.size(); ++band)
    for (const LeadBin& lead : options.leads) add(band, lead, with_interval);
  if (!options.by_hour || methods.empty()) return entries;
  const std::size_t hours = methods.begin()->second.hours();
  for (std::size_t h = 0; h < hours; ++h) {
    const LeadBin hour{static_cast<double>(h), static_cast<double>(h + 1)};
    if (std::find(options.leads.begin(), options.leads.end(), hour) == options.leads.end())
      add(0, hour, false);
  }
  return entries;
}

}  // namespace slackwater::calibration
