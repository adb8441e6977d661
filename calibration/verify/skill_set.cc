#include "calibration/verify/skill_set.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "fields/base/text.h"

namespace slackwater::calibration {
namespace {

/// What the entries of one set share.
auto key_of(const SkillEntry& e) {
  const DepthBand band = e.band.value_or(DepthBand{});
  return std::tuple(e.variable, e.site, e.column, e.origin, e.wind, band.from_m, band.to_m,
                    band.above_bed, e.lead.from_h, e.lead.to_h, e.method);
}

/// The pairs of a set score as what they are.
SetScore score_of(const std::vector<const SkillEntry*>& pairs, Rng& random) {
  constexpr int draws = 1000;
  if (!pairs.front()->scalar) {
    std::vector<VectorScore> scores;
    scores.reserve(pairs.size());
    for (const SkillEntry* pair : pairs) scores.push_back(pair->vector);
    return score_set(scores, random, draws);
  }
  std::vector<ScalarScore> scores;
  scores.reserve(pairs.size());
  for (const SkillEntry* pair : pairs) scores.push_back(pair->scalar.value());
  return score_set(scores, random, draws);
}

double width_of(const std::optional<DepthBand>& band) {
  return band && !band->above_bed ? band->to_m - band->from_m : 0.0;
}

/// What counts of the entries of one set, in the order of their days.
std::vector<const SkillEntry*> pairs_of(std::vector<const SkillEntry*> entries) {
  const auto has_ours = [](const SkillEntry* e) { return e->forecast_rmse.has_value(); };
  if (std::any_of(entries.begin(), entries.end(), has_ours))
    std::erase_if(entries, [&](const SkillEntry* e) { return !has_ours(e); });
  std::stable_sort(entries.begin(), entries.end(), [](const SkillEntry* a, const SkillEntry* b) {
    return std::tuple(a->day, a->issued) < std::tuple(b->day, b->issued);
  });
  const auto same_day = [](const SkillEntry* a, const SkillEntry* b) { return a->day == b->day; };
  entries.erase(std::unique(entries.begin(), entries.end(), same_day), entries.end());
  return entries;
}

SkillSet set_of(const std::vector<const SkillEntry*>& pairs) {
  SkillSet set;
  set.of = *pairs.back();
  set.first_day = pairs.front()->day;
  set.last_day = pairs.back()->day;
  std::vector<double> ours;
  for (const SkillEntry* pair : pairs) {
    set.of.truth_averaging = std::max(set.of.truth_averaging, pair->truth_averaging);
    set.of.hindsight = set.of.hindsight || pair->hindsight;
    set.of.simulated_wind = set.of.simulated_wind || pair->simulated_wind;
    if (pair->forecast_rmse) ours.push_back(*pair->forecast_rmse);
  }
  if (!ours.empty()) set.forecast_rmse = rmse_of_pairs(ours);
  Rng random(static_cast<std::uint64_t>(set.first_day.time_since_epoch().count()), "verify/pairs");
  set.score = score_of(pairs, random);
  return set;
}

/// The error as a share of our own over the same values.
std::optional<double> share_of_ours(const SkillSet& set) noexcept {
  if (set.of.method == Method::forecast) return 1.0;
  if (!set.forecast_rmse) return std::nullopt;
  if (*set.forecast_rmse > 0) return set.score.rmse / *set.forecast_rmse;
  return set.score.rmse > 0 ? std::numeric_limits<double>::infinity() : 1.0;
}

}  // namespace

SkillSets sets_of(const std::vector<SkillEntry>& entries) {
  SkillSets result;
  std::map<decltype(key_of(entries.front())), std::size_t> index;
  std::vector<std::vector<const SkillEntry*>> members;
  for (const SkillEntry& entry : entries) {
    const auto [found, is_new] = index.try_emplace(key_of(entry), members.size());
    if (is_new) members.emplace_back();
    members[found->second].push_back(&entry);
    result.of_entry.push_back(found->second);
  }
  for (std::vector<const SkillEntry*>& of_set : members)
    result.sets.push_back(set_of(pairs_of(std::move(of_set))));
  return result;
}

bool is_part_of(const SkillSet& baseline, const SkillSet& ours) noexcept {
  return baseline.of.method != Method::forecast &&
         (baseline.score.pairs != ours.score.pairs || baseline.score.n != ours.score.n);
}

bool is_better(const SkillSet& a, const SkillSet& b) noexcept {
  const auto key = [](const SkillSet& set) {
    const std::optional<double> share = share_of_ours(set);
    return std::tuple(!share, share.value_or(0), set.score.rmse, set.of.method);
  };
  return key(a) < key(b);
}

bool is_hour(const LeadBin& lead) noexcept { return lead.to_h - lead.from_h <= 1; }

std::vector<SkillEntry> whole_of(const std::vector<SkillEntry>& entries, std::string_view variable,
                                 WindPolicy wind, ForecastOrigin origin) {
  std::vector<SkillEntry> found;
  std::optional<DepthBand> widest;
  for (const SkillEntry& e : entries) {
    if (e.variable != variable || e.wind != wind || e.origin != origin) continue;
    if (e.column || is_hour(e.lead)) continue;
    found.push_back(e);
    if (!widest || width_of(e.band) > width_of(widest) ||
        (width_of(e.band) == width_of(widest) && e.band && e.band->from_m < widest->from_m))
      widest = e.band;
  }
  std::erase_if(found, [&](const SkillEntry& e) { return e.band != widest; });
  return found;
}

std::vector<SkillEntry> whole_current(const std::vector<SkillEntry>& entries, WindPolicy wind,
                                      ForecastOrigin origin) {
  return whole_of(entries, current_variable, wind, origin);
}

std::string band_text(const std::optional<DepthBand>& band) {
  if (!band) return "surface";
  if (band->above_bed) return formatted("{:g}-{:g} m above the bed", band->from_m, band->to_m);
  if (band->to_m < whole_column_m) return formatted("{:g}-{:g} m", band->from_m, band->to_m);
  return band->from_m > 0 ? formatted("below {:g} m", band->from_m) : "all depths";
}

std::string lead_text(const LeadBin& lead) {
  return formatted("{:g}-{:g} h", lead.from_h, lead.to_h);
}

}  // namespace slackwater::calibration
