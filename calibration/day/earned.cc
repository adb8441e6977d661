#include "calibration/day/earned.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

const RehearsedLead& lead_of(const PastLead& past) { return past.day->lead[past.lead]; }

Blend blend_of_leads(const std::vector<PastLead>& past, std::span<const Candidate> candidates,
                     const BlendSettings& settings = {}) {
  std::vector<PastPair> pairs;
  pairs.reserve(past.size());
  for (const PastLead& one : past)
    pairs.push_back(pair_of_errors(lead_of(one).errors, one.age_days));
  return blend_of(candidates, pairs, settings);
}

/// The candidates with the weights of the day of lead before as their prior, but for one that never
/// reached this day, and a hundredth of the documented prior: without it pairs that lack the one
/// candidate of the day before would say nothing.
std::vector<Candidate> believing(const Blend& before, std::span<const Candidate> candidates,
                                 const std::vector<PastLead>& past) {
  constexpr double documented = 0.01;
  double total = 0;
  for (const Candidate& c : candidates) total += c.available ? c.prior_weight : 0.0;
  std::vector<Candidate> believed(candidates.begin(), candidates.end());
  for (std::size_t c = 0; c < believed.size(); ++c) {
    const bool is_seen =
        past.empty() || std::any_of(past.begin(), past.end(), [&](const auto& one) {
          return !lead_of(one).errors[c].empty();
        });
    const double share = total > 0 ? believed[c].prior_weight / total : 0.0;
    believed[c].prior_weight =
        is_seen ? (1 - documented) * before.share[c].weight + documented * share : 0.0;
  }
  return believed;
}

/// The blend's errors on one day of lead against its own spread.
/// @param weights  earned without it
NormalisedErrors normalised(const RehearsedLead& lead, const Blend& blend,
                            const std::vector<double>& weights) {
  NormalisedErrors errors;
  for (std::size_t o = 0; o < lead.sigma_m_s.size(); ++o) {
    Horizontal error{};
    double weight = 0;
    for (std::size_t c = 0; c < lead.errors.size(); ++c) {
      if (weights[c] <= 0 || lead.errors[c].empty() || !std::isfinite(lead.errors[c][o].real()))
        continue;
      error += weights[c] * lead.errors[c][o];
      weight += weights[c];
    }
    if (weight <= 0) continue;
    const double blended =
        sigma_of_blend(blend, weights, lead.sigma_m_s[o], lead.merged_sigma_m_s[o]);
    const double sigma = std::hypot(blended, lead.noise_m_s[o]);
    errors.add(error.real() / weight, sigma);
    errors.add(error.imag() / weight, sigma);
  }
  return errors;
}

/// What one rehearsed day has met, whichever of its days of lead have a truth.
struct DaySpread {
  const RehearsedDay* day = nullptr;
  PastSpread spread;
};

/// The entry of the day that a lead is of, made where there is none.
PastSpread& spread_of(const PastLead& one, std::size_t leads, std::vector<DaySpread>& of_days) {
  const auto found = std::find_if(of_days.begin(), of_days.end(),
                                  [&](const DaySpread& of) { return of.day == one.day.get(); });
  if (found != of_days.end()) return found->spread;
  PastSpread spread;
  spread.age_days = one.age_days + static_cast<double>(one.lead);
  spread.later.resize(leads - 1);
  of_days.push_back({one.day.get(), std::move(spread)});
  return of_days.back().spread;
}

/// How the blend's own spread has held its errors, by day of lead.
EarnedSpread spread_of_leads(std::span<const std::vector<PastLead>> past, const Earned& earned) {
  std::vector<DaySpread> of_days;
  for (std::size_t lead = 0; lead < past.size(); ++lead) {
    const Blend& blend = lead == 0 ? earned.blend : earned.later[lead - 1];
    for (std::size_t i = 0; i < past[lead].size(); ++i) {
      PastSpread& spread = spread_of(past[lead][i], past.size(), of_days);
      (lead == 0 ? spread.errors : spread.later[lead - 1]) =
          normalised(lead_of(past[lead][i]), blend, blend.without_pair[i]);
    }
  }
  std::vector<PastSpread> spreads;
  spreads.reserve(of_days.size());
  for (DaySpread& of : of_days) spreads.push_back(std::move(of.spread));
  return earned_spread(spreads);
}

}  // namespace

Earned earned_from(std::span<const std::vector<PastLead>> past,
                   std::span<const Candidate> candidates) {
  expects(!past.empty(), "what days earned has a first day of lead");
  Earned earned;
  earned.blend = blend_of_leads(past.front(), candidates);
  BlendSettings of_later;
  of_later.prior_name = "weights of the day of lead before";
  for (std::size_t l = 1; l < past.size(); ++l) {
    const Blend& before = l == 1 ? earned.blend : earned.later.back();
    earned.later.push_back(
        blend_of_leads(past[l], believing(before, candidates, past[l]), of_later));
  }
  earned.spread = spread_of_leads(past, earned);
  for (const PastLead& first : past.front())
    earned.simulated_days += first.day->simulated_wind ? 1 : 0;
  return earned;
}

std::vector<double> weights_at(const Earned& earned, double lead_h) {
  const auto of_day = [&](std::size_t day) -> const Blend& {
    return day == 0 ? earned.blend : earned.later[day - 1];
  };
  const double last = static_cast<double>(earned.later.size());
  const double place = std::clamp(lead_h / 24.0 - 0.5, 0.0, last);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, earned.later.size());
  const double share = place - static_cast<double>(low);
  std::vector<double> weights;
  for (std::size_t c = 0; c < earned.blend.share.size(); ++c) {
    weights.push_back((1 - share) * of_day(low).share[c].weight +
                      share * of_day(high).share[c].weight);
  }
  return weights;
}

bool uses_provider(const Earned& earned) {
  const auto is_in = [](const Blend& blend) {
    return std::any_of(blend.share.begin(), blend.share.end(), [](const CandidateShare& share) {
      return share.weight > 0 &&
             (share.method == Method::provider || share.method == Method::merged);
    });
  };
  return is_in(earned.blend) || std::any_of(earned.later.begin(), earned.later.end(), is_in);
}

double sigma_of_blend(const Blend& blend, const std::vector<double>& weights, double own_sigma_m_s,
                      double merged_sigma_m_s) {
  if (!std::isfinite(merged_sigma_m_s)) return own_sigma_m_s;
  double merged = 0;
  for (std::size_t c = 0; c < weights.size(); ++c)
    if (blend.share[c].method == Method::merged) merged += weights[c];
  if (merged <= 0) return own_sigma_m_s;
  return std::sqrt((1 - merged) * own_sigma_m_s * own_sigma_m_s +
                   merged * merged_sigma_m_s * merged_sigma_m_s);
}

}  // namespace slackwater::calibration
