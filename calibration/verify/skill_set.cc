#include "calibration/verify/skill_set.h"
#include "fields/base/text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace slackwater::calibration {
namespace {

/// What the entries of one set share.
auto key_of(const SkillEntry& e) {
  const DepthBand band = e.band.value_or(DepthBand{});
  return std::tuple(e.variable, e.site, e.column, e.wind, band.from_m, band.to_m, band.above_bed,
                    e.lead.from_h, e.lead.to_h, e.method);
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

}  // namespace

SkillSets sets_of(const std::vector<SkillEntry>& entries) {
  SkillSets result;
  std::map<decltype(key_of(entries.front())), std::size_t> index;
  std::vector<std::vector<const SkillEntry*>> pairs;
  for (const SkillEntry& entry : entries) {
    const auto [found, is_new] = index.try_emplace(key_of(entry), result.sets.size());
    if (is_new) {
      result.sets.push_back({entry, entry.day, entry.day, {}});
      pairs.emplace_back();
    }
    SkillSet& set = result.sets[found->second];
    const Duration averaging = std::max(set.of.truth_averaging, entry.truth_averaging);
    const bool hindsight = set.of.hindsight || entry.hindsight;
    set.of = entry;
    set.of.truth_averaging = averaging;
    set.of.hindsight = hindsight;
    set.first_day = std::min(set.first_day, entry.day);
    set.last_day = std::max(set.last_day, entry.day);
    pairs[found->second].push_back(&entry);
    result.of_entry.push_back(found->second);
  }
  for (std::size_t i = 0; i < result.sets.size(); ++i) {
    Rng random(static_cast<std::uint64_t>(result.sets[i].first_day.time_since_epoch().count()),
               "verify/pairs");
    result.sets[i].score = score_of(pairs[i], random);
  }
  return result;
}

bool is_hour(const LeadBin& lead) noexcept { return lead.to_h - lead.from_h <= 1; }

std::vector<SkillEntry> whole_current(const std::vector<SkillEntry>& entries, WindPolicy wind) {
  std::vector<SkillEntry> found;
  std::optional<DepthBand> widest;
  for (const SkillEntry& e : entries) {
    if (e.variable != current_variable || e.wind != wind || e.column || is_hour(e.lead)) continue;
    found.push_back(e);
    if (!widest || width_of(e.band) > width_of(widest) ||
        (width_of(e.band) == width_of(widest) && e.band && e.band->from_m < widest->from_m))
      widest = e.band;
  }
  std::erase_if(found, [&](const SkillEntry& e) { return e.band != widest; });
  return found;
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
