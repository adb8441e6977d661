#include "calibration/fuse/instrument_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/fuse/broken_samples.h"
#include "calibration/fuse/comparison.h"
#include "calibration/fuse/fusion.h"
#include "calibration/fuse/instrument_noise.h"
#include "calibration/fuse/tide_agreement.h"
#include "fields/base/check.h"
#include "fields/base/numbers/square.h"
#include "fields/base/text.h"

namespace slackwater::calibration {
namespace {

constexpr double most_usual_sigmas = 5.0;
constexpr double doubt_of_mean_flow = 0.5;
constexpr double lunar_day_h = 24.84;
constexpr double least_share_of_times = 0.75;
/// Noise from which on it is said: as much as a product errs.
constexpr double noise_worth_saying_m_s = 0.10;
constexpr double forgotten_share = 1.0 / 3.0;
constexpr double least_silence_worth_saying_h = 6.0;

std::optional<UtcTime> last_value(const VectorColumn& column) {
  for (std::size_t t = column.times(); t-- > 0;) {
    for (std::size_t k = 0; k < column.levels(); ++k)
      if (column.has(t, k)) return column.time[t].end;
  }
  return std::nullopt;
}

std::string span_text(double hours) {
  return hours < 48 ? formatted("{:.0f} h", hours) : formatted("{:.1f} days", hours / 24);
}

/// The depth means of one time of the product.
struct Moment {
  UtcTime time{};
  Horizontal product;
  Horizontal difference;
};

std::vector<Moment> moments_of(const VectorColumn& product, const VectorColumn& observed,
                               const FusionSettings& settings) {
  std::vector<Moment> moments;
  const Comparison comparison(product, observed, settings);
  for (std::size_t t = 0; t < product.times(); ++t) {
    const Differences found = comparison.at(t);
    if (found.value.empty()) continue;
    Moment moment{product.time[t].centre(), {}, {}};
    const auto count = static_cast<double>(found.value.size());
    for (std::size_t i = 0; i < found.value.size(); ++i) {
      moment.difference += found.value[i] / count;
      moment.product += (found.observed[i] - found.value[i]) / count;
    }
    moments.push_back(moment);
  }
  return moments;
}

/// The product's usual step.
double step_h(const VectorColumn& product) {
  if (product.time.front().is_mean())
    return hours_between(product.time.front().start, product.time.front().end);
  double shortest = 1e9;
  for (std::size_t t = 1; t < product.times(); ++t)
    shortest =
        std::min(shortest, hours_between(product.time[t - 1].centre(), product.time[t].centre()));
  return shortest;
}

/// Means over what lies at or after a time.
struct Means {
  double hours = 0;
  double share = 0;  ///< of the times that there could be
  Horizontal product;
  Horizontal difference;
};

Means means_after(const std::vector<Moment>& moments, UtcTime from, double step) {
  Means means;
  double count = 0;
  std::optional<UtcTime> first;
  for (const Moment& moment : moments) {
    if (moment.time < from) continue;
    if (!first) first = moment.time;
    means.product += moment.product;
    means.difference += moment.difference;
    ++count;
  }
  if (!first) return means;
  means.product /= count;
  means.difference /= count;
  means.hours = hours_between(*first, moments.back().time) + step;
  means.share = count * step / means.hours;
  return means;
}

/// Why the means are no water; empty where they may be.
std::string bias_text(const Means& means, double sigma_m_s) {
  if (means.hours < 24 - 1e-6 || means.share < least_share_of_times) return {};
  const double usual = most_usual_sigmas * sigma_m_s + doubt_of_mean_flow * std::abs(means.product);
  const double found = std::abs(means.difference);
  if (found <= usual) return {};
  return formatted(
      "it differs from the product by {:.2f} m/s on average over {}; expected at most {:.2f} m/s",
      found, span_text(means.hours), usual);
}

std::string bias_of(const std::vector<Moment>& moments, double step, double sigma_m_s) {
  std::string always = bias_text(means_after(moments, UtcTime::min(), step), sigma_m_s);
  if (!always.empty()) return always;
  const UtcTime lately = add_hours(moments.back().time, -(lunar_day_h + 0.5 * step));
  return bias_text(means_after(moments, lately, step), sigma_m_s);
}

std::string text_of(const TideAgreement& found) {
  const std::string turn =
      std::abs(found.turned_deg) > 150
          ? formatted("runs opposite to the product's (turned by {:.0f} degrees)",
                      std::abs(found.turned_deg))
          : formatted("is turned {:.0f} degrees {} of the product's", std::abs(found.turned_deg),
                      found.turned_deg > 0 ? "clockwise" : "anticlockwise");
  const std::string lag =
      formatted("{:.1f} h {}", std::abs(found.late_h), found.late_h > 0 ? "late" : "early");
  if (found.is_turned && !found.is_late)
    return "its tide " + turn + ": check its sign, heading and declination";
  if (found.is_late && !found.is_turned)
    return "its tide is " + lag + " compared with the product's: check its clock and time zone";
  return "its tide " + turn + ", or is " + lag + ": check its clock, sign and declination";
}

/// Noise and what lasts beyond it.
MooredInstrumentErrors errors_of(const VectorColumn& column, std::optional<double> stated_m_s,
                                 const FusionSettings& settings) {
  MooredInstrumentErrors errors;
  errors.noise_m_s = instrument_noise(column);
  if (!stated_m_s) return errors;
  double noise = 0;
  for (const double one : errors.noise_m_s) noise += one * one;
  noise /= static_cast<double>(errors.noise_m_s.size());
  const double known = std::max(noise, square(settings.instrument_error_m_s));
  errors.lasting_m_s = std::sqrt(std::max(0.0, square(*stated_m_s) - known));
  return errors;
}

void remark_on(const UnbrokenSeries& unbroken, double silent_h, MooredInstrumentVerdict& verdict) {
  if (unbroken.spikes > 0)
    verdict.remarks.push_back(std::to_string(unbroken.spikes) +
                              (unbroken.spikes == 1 ? " spike" : " spikes") + " left out");
  if (unbroken.stuck_h > 0)
    verdict.remarks.push_back(span_text(unbroken.stuck_h) +
                              " left out because the value never changed");
  const std::vector<double>& noise = verdict.errors.noise_m_s;
  const double loudest = *std::max_element(noise.begin(), noise.end());
  if (loudest >= noise_worth_saying_m_s)
    verdict.remarks.push_back(
        formatted("its values scatter by {:.2f} m/s, so they get less weight", loudest));
  if (verdict.errors.lasting_m_s >= noise_worth_saying_m_s)
    verdict.remarks.push_back(formatted("it states an error of {:.2f} m/s, so it gets less weight",
                                        verdict.errors.lasting_m_s));
  if (silent_h > least_silence_worth_saying_h)
    verdict.remarks.push_back("its last good value is " + span_text(silent_h) +
                              " before the end of the day");
}

}  // namespace

MooredInstrumentVerdict check_instrument(const VectorColumn& product, const VectorColumn& observed,
                                         double distance_m, UtcTime until,
                                         std::optional<double> stated_error_m_s,
                                         const FusionSettings& settings) {
  expects(!product.levels_m.empty() && !observed.levels_m.empty(), "two series over depths");
  MooredInstrumentVerdict verdict;
  UnbrokenSeries unbroken = without_broken_samples(observed, product);
  verdict.column = std::move(unbroken.column);
  const auto give_up = [&](MooredInstrumentUse use, std::string why) {
    verdict.use = use;
    verdict.why = std::move(why);
    return verdict;
  };
  const auto sent = last_value(observed);
  const auto good = last_value(verdict.column);
  if (!sent || product.time.empty())
    return give_up(MooredInstrumentUse::apart, "it has no value to compare with the product");
  const bool sends_rubbish = unbroken.stuck_h > 0 && (!good || unbroken.stuck_until > *good) &&
                             hours_between(*sent, until) <= least_silence_worth_saying_h;
  verdict.is_stuck_at_the_end = sends_rubbish;
  if (!good)
    return give_up(MooredInstrumentUse::rejected,
                   "its value never changes, but the product's does");
  const double silent_h = hours_between(*good, until);
  if (silent_h > -std::log(forgotten_share) * settings.slow_memory_h) {
    if (sends_rubbish)
      return give_up(MooredInstrumentUse::rejected,
                     "its value has not changed for " + span_text(silent_h));
    return give_up(MooredInstrumentUse::ended,
                   formatted("it ended {:.1f} days before", silent_h / 24));
  }
  verdict.errors = errors_of(verdict.column, stated_error_m_s, settings);
  remark_on(unbroken, silent_h, verdict);
  const std::vector<Moment> moments = moments_of(product, verdict.column, settings);
  if (moments.empty())
    return give_up(MooredInstrumentUse::apart,
                   "it has no value at a time and depth of the product");
  std::string bias =
      bias_of(moments, step_h(product), expected_difference(distance_m, verdict.errors, settings));
  if (!bias.empty()) return give_up(MooredInstrumentUse::rejected, std::move(bias));
  const auto tide = tide_disagreement(product, verdict.column, verdict.errors.noise_m_s, settings);
  if (tide) return give_up(MooredInstrumentUse::rejected, text_of(*tide));
  return verdict;
}

}  // namespace slackwater::calibration
