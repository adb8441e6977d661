#include "calibration/propagate/members.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "calibration/propagate/member_wind.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration {
namespace {

std::vector<UtcTime> wind_samples_after(const VectorColumn& wind, UtcTime end_of_day) {
  std::vector<UtcTime> times;
  for (const TimeCell& cell : wind.time) {
    if (cell.centre() > end_of_day) times.push_back(cell.centre());
  }
  return times;
}

/// Departures known at the samples of the wind, at the stamps of the forecast: linear between
/// samples, from 0 at the end of D, held after the last.
std::vector<Horizontal> at_stamps(std::span<const UtcTime> samples,
                                  std::span<const Horizontal> departure,
                                  std::span<const UtcTime> stamps, UtcTime end_of_day) {
  std::vector<Horizontal> out;
  for (const UtcTime stamp : stamps) {
    const auto i = static_cast<std::size_t>(
        std::lower_bound(samples.begin(), samples.end(), stamp) - samples.begin());
    if (samples.empty() || stamp <= end_of_day) {
      out.emplace_back();
    } else if (i == samples.size()) {
      out.push_back(departure.back());
    } else {
      const UtcTime before = i == 0 ? end_of_day : samples[i - 1];
      const Horizontal low = i == 0 ? Horizontal{} : departure[i - 1];
      const double share = hours_between(before, stamp) / hours_between(before, samples[i]);
      out.push_back((1.0 - share) * low + share * departure[i]);
    }
  }
  return out;
}

std::vector<Horizontal> opposite(std::vector<Horizontal> values) {
  for (Horizontal& value : values) value = -value;
  return values;
}

/// The winds of a pair of members: departures at the samples of the wind after D.
struct PairWind {
  std::vector<Horizontal> plus;
  std::vector<Horizontal> minus;
};

/// Fewer pairs are left as they fall: scaled, two winds would blow at one strength for days.
constexpr std::size_t fewest_to_match = 8;

/// Scales the winds of all pairs at each sample to the spread that they were drawn from, and makes
/// them opposite: twelve pairs as they fall miss it by a seventh.
void match_spread(const std::vector<double>& sigma_m_s, std::vector<PairWind>& blown) {
  for (std::size_t k = 0; k < sigma_m_s.size() && blown.size() >= fewest_to_match; ++k) {
    double squares = 0;
    for (const PairWind& pair : blown) squares += 0.5 * std::norm(pair.plus[k]);
    if (squares <= 0) continue;
    const double to_sigma = sigma_m_s[k] / std::sqrt(squares / static_cast<double>(blown.size()));
    for (PairWind& pair : blown) pair.plus[k] *= to_sigma;
  }
  for (PairWind& pair : blown) pair.minus = opposite(pair.plus);
}

/// One pair: its winds, opposite parameters.
void draw_pair(const Calibration& c, const VectorColumn& wind, UtcTime end_of_day,
               WindDriven& model, const std::vector<Horizontal>& central, const PairWind& blown,
               Rng& random, std::span<Horizontal> plus, std::span<Horizontal> minus) {
  std::vector<double> normals(c.parameters.size());
  for (double& z : normals) z = random.normal();
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> z = normals;
    for (double& x : z) x *= sign;
    const StressSeries stress(departed_wind(wind, end_of_day, sign > 0 ? blown.plus : blown.minus),
                              c.drag_law);
    const std::vector<Horizontal> driven = model.under(stress, drawn_parameters(c, z));
    const std::span<Horizontal> out = sign > 0 ? plus : minus;
    for (std::size_t i = 0; i < driven.size(); ++i) out[i] = driven[i] - central[i];
  }
}

/// Nonlinear drag gives a pair of opposite winds a mean; member 0 is the centre.
void centre_pair(std::span<Horizontal> plus, std::span<Horizontal> minus) {
  for (std::size_t i = 0; i < plus.size(); ++i) {
    const Horizontal half = 0.5 * (plus[i] + minus[i]);
    plus[i] -= half;
    minus[i] -= half;
  }
}

/// Which form each pair of members follows: as often as its weight asks, in order.
std::vector<std::size_t> form_of_pairs(const std::vector<double>& weight, std::size_t pairs) {
  std::vector<std::size_t> form;
  double sum = 0;
  std::size_t f = 0;
  for (std::size_t p = 0; p < pairs; ++p) {
    const double at = (static_cast<double>(p) + 0.5) / static_cast<double>(pairs);
    while (f + 1 < weight.size() && sum + weight[f] < at) sum += weight[f++];
    form.push_back(f);
  }
  return form;
}

}  // namespace

Members::Members(std::span<const Calibration> forms, const std::vector<double>& form_weight,
                 int members, std::size_t size, std::uint64_t seed, std::size_t set)
    : forms_(forms),
      size_(size),
      seed_(seed),
      set_(set),
      form_of_pair_(form_of_pairs(form_weight, static_cast<std::size_t>(std::max(0, members) / 2))),
      departure_(2 * form_of_pair_.size() * size) {}

void Members::draw_wind_driven(std::span<const UtcTime> times, const VectorColumn& wind,
                               UtcTime end_of_day, const WindErrorGrowth& wind_error,
                               std::span<const std::vector<Horizontal>> central,
                               const WindDepartures& ensemble) {
  const std::vector<UtcTime> samples = wind_samples_after(wind, end_of_day);
  std::optional<EnsembleWind> weather;
  if (!ensemble.empty() && !form_of_pair_.empty()) {
    weather.emplace(ensemble, times, end_of_day, samples, wind_error, 2 * form_of_pair_.size(),
                    seed_, set_);
    wind_number_ = weather->numbers();
  }
  std::vector<Rng> random;
  std::vector<PairWind> blown(form_of_pair_.size());
  for (std::size_t p = 0; p < form_of_pair_.size(); ++p) {
    const std::size_t number = set_ * form_of_pair_.size() + p;
    random.emplace_back(seed_, "calibration/member_wind/" + std::to_string(number));
    if (weather) {
      Rng same = random[p];
      blown[p].minus = weather->departure(2 * p + 1, same);
      blown[p].plus = weather->departure(2 * p, random[p]);
    } else {
      blown[p].plus = draw_wind_departures(samples, end_of_day, wind_error, random[p]);
    }
  }
  if (!weather) match_spread(departure_sigma_m_s(samples, end_of_day, wind_error), blown);
  std::vector<WindDriven> model;
  for (const Calibration& c : forms_) model.emplace_back(c, times, end_of_day);
  for (std::size_t p = 0; p < form_of_pair_.size(); ++p) {
    const std::size_t f = form_of_pair_[p];
    draw_pair(forms_[f], wind, end_of_day, model[f], central[f], blown[p], random[p], member(2 * p),
              member(2 * p + 1));
    if (!weather) centre_pair(member(2 * p), member(2 * p + 1));
    for (const std::vector<Horizontal>* one : {&blown[p].plus, &blown[p].minus}) {
      const std::vector<Horizontal> at_times = at_stamps(samples, *one, times, end_of_day);
      wind_.insert(wind_.end(), at_times.begin(), at_times.end());
    }
  }
}

void Members::draw_memory(std::span<const UtcTime> times, std::span<const ColumnMemory> memory,
                          std::span<const std::vector<Horizontal>> central) {
  for (std::size_t f = 0; f < forms_.size(); ++f) {
    const auto count = static_cast<int>(std::count(form_of_pair_.begin(), form_of_pair_.end(), f));
    if (count == 0) continue;
    std::string name = "calibration/member_memory/" + std::to_string(f);
    if (set_ > 0) name += "/" + std::to_string(set_);
    Rng random(seed_, name);
    std::vector<Horizontal> drawn(static_cast<std::size_t>(count) * size_);
    memory[f].likeliest().sample(times, central[f], random, count, drawn);
    std::size_t next = 0;
    for (std::size_t p = 0; p < form_of_pair_.size(); ++p) {
      if (form_of_pair_[p] != f) continue;
      for (std::size_t i = 0; i < size_; ++i) {
        member(2 * p)[i] += drawn[next * size_ + i];
        member(2 * p + 1)[i] -= drawn[next * size_ + i];
      }
      ++next;
    }
  }
}

std::vector<double> Members::variance() const {
  std::vector<double> variance(size_);
  const auto members = static_cast<double>(2 * form_of_pair_.size());
  for (std::size_t i = 0; i < departure_.size(); ++i)
    variance[i % size_] += 0.5 * std::norm(departure_[i]) / members;
  return variance;
}

void Members::scale_to(const std::vector<double>& sigma_m_s) {
  const std::vector<double> drawn = variance();
  for (std::size_t i = 0; i < departure_.size(); ++i) {
    const std::size_t at = i % size_;
    departure_[i] *= drawn[at] > 0 ? sigma_m_s[at] / std::sqrt(drawn[at]) : 0.0;
  }
}

}  // namespace slackwater::calibration
