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

std::vector<BlockSum> HourlyTallies::squares_by_hour(std::size_t band, const LeadBin& lead) const {
  const HourRange range = hours_of(lead, hours_);
  std::vector<BlockSum> squares;
  for (std::size_t h = range.first; h < range.last; ++h) squares.push_back(at(band, h).squares());
  return squares;
}

void MethodTallies::add(std::size_t band, std::size_t hour, const PairContribution& pair,
                        double ours_squared_error) noexcept {
  common_.at(band, hour).add(pair);
  BlockSum& ours = ours_[band * common_.hours() + hour];
  ours.sum += ours_squared_error;
  ours.weight += 1.0;
}

void MethodTallies::add_alone(std::size_t band, std::size_t hour, const PairContribution& pair) {
  if (!alone_) alone_.emplace(ours_.size() / common_.hours(), common_.hours());
  alone_->at(band, hour).add(pair);
}

void MethodTallies::merge(const MethodTallies& other) {
  common_.merge(other.common_);
  for (std::size_t i = 0; i < std::min(ours_.size(), other.ours_.size()); ++i) {
    ours_[i].sum += other.ours_[i].sum;
    ours_[i].weight += other.ours_[i].weight;
  }
  if (!other.alone_) return;
  if (alone_) {
    alone_->merge(*other.alone_);
  } else {
    alone_ = other.alone_;
  }
}

BlockSum MethodTallies::ours(std::size_t band, const LeadBin& lead) const {
  const HourRange range = hours_of(lead, common_.hours());
  BlockSum sum;
  for (std::size_t h = range.first; h < range.last; ++h) {
    sum.sum += ours_[band * common_.hours() + h].sum;
    sum.weight += ours_[band * common_.hours() + h].weight;
  }
  return sum;
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
  const auto ours = methods.find(Method::forecast);
  const auto add = [&](std::size_t band, const LeadBin& lead, bool interval) {
    const bool is_forecast_there =
        ours != methods.end() && ours->second.common().over(band, lead).size() > 0;
    for (const auto& [method, tallies] : methods) {
      const HourlyTallies* const scored = is_forecast_there ? &tallies.common() : tallies.alone();
      if (scored == nullptr) continue;
      const VectorTally tally = scored->over(band, lead);
      if (tally.size() == 0) continue;
      SkillEntry entry = blank;
      entry.method = method;
      entry.band = bands[band];
      entry.lead = lead;
      entry.vector = tally.score();
      if (is_forecast_there && method != Method::forecast) {
        const BlockSum there = tallies.ours(band, lead);
        entry.forecast_rmse = std::sqrt(there.sum / there.weight);
      }
      if (interval) {
        Rng random(static_cast<std::uint64_t>(blank.day.time_since_epoch().count()),
                   "verify/bootstrap");
        entry.interval = bootstrap_rms(scored->squares_by_hour(band, lead), random);
      }
      entries.push_back(std::move(entry));
    }
  };
  for (std::size_t band = 0; band < bands.size(); ++band)
    for (const LeadBin& lead : options.leads) add(band, lead, with_interval);
  if (!options.by_hour || methods.empty()) return entries;
  const std::size_t hours = methods.begin()->second.common().hours();
  for (std::size_t h = 0; h < hours; ++h) {
    const LeadBin hour{static_cast<double>(h), static_cast<double>(h + 1)};
    if (std::find(options.leads.begin(), options.leads.end(), hour) == options.leads.end())
      add(0, hour, false);
  }
  return entries;
}

}  // namespace slackwater::calibration
