#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/turn.h"
#include "fields/service/field.h"
#include "fields/wind/log_profile.h"

// What a field says of the air above the sea and of the waves on it.

namespace slackwater {
namespace {

constexpr double product_wind_m = 10.0;
/// Weight of a sea without waves in the mean direction: none beside any other, all where all are
/// calm.
constexpr double calm_m2 = 1e-12;
/// Of a sea that is missing what nobody knows is NaN; the height may be known without the period or
/// the direction.
constexpr SeaState unknown_sea{constants::nan, constants::nan, constants::nan};

Horizontal between(std::span<const Horizontal> values, TimePlace time) noexcept {
  if (!(time.upper > 0)) return values[time.low];
  return (1 - time.upper) * values[time.low] + time.upper * values[time.low + 1];
}

/// A weighted mean of sea states, grown one by one.
class MeanSea {
 public:
  void add(double weight, const SeaState& s) noexcept {
    sum_.significant_height_m += weight * s.significant_height_m;
    sum_.peak_period_s += weight * s.peak_period_s;
    if (s.peak_period_s == 0) without_period_ += weight;
    const double energy = s.significant_height_m * s.significant_height_m + calm_m2;
    from_ += weight * energy * std::polar(1.0, constants::degree * s.from_direction_deg);
  }
  /// Missing where any of them had no number; what is known of the sea is in it nevertheless.
  [[nodiscard]] SeaSample sample() const noexcept {
    const bool is_known =
        std::isfinite(sum_.significant_height_m + sum_.peak_period_s + from_.real());
    SeaSample sample{sum_, is_known ? SampleStatus::ok : SampleStatus::missing};
    // Calm water has no period: beside a sea it must not make that sea's look short and steep.
    if (without_period_ > 0 && without_period_ < 1)
      sample.sea.peak_period_s = sum_.peak_period_s / (1 - without_period_);
    sample.sea.from_direction_deg = std::isfinite(from_.real())
                                        ? compass_deg(std::arg(from_) / constants::degree)
                                        : constants::nan;
    return sample;
  }

 private:
  SeaState sum_;
  double without_period_ = 0;
  Horizontal from_{};
};

}  // namespace

WindSample Field::wind_at(const Place& place, std::size_t member) const noexcept {
  const Spot here = spot(place.longitude_deg, place.latitude_deg);
  const std::optional<TimePlace> time = when(place.time);
  const bool is_high = !(place.vertical_m >= lowest_wind_m) || place.vertical_m > highest_wind_m;
  if (here.status == SampleStatus::outside_area) return {{}, here.status};
  if (!time) return {{}, SampleStatus::outside_time};
  if (is_high) return {{}, SampleStatus::outside_area};
  if (here.status != SampleStatus::ok) return {{}, here.status};
  Horizontal sum{};
  for (std::uint32_t c = 0; c < here.stencil.count; ++c) {
    const auto wind = wind_of_member(snapshot_->columns[here.stencil.column[c]], member);
    if (wind.empty()) return {};
    sum += here.stencil.weight[c] * between(wind, *time);
  }
  if (!std::isfinite(sum.real() + sum.imag())) return {};
  return {log_profile_ratio(place.vertical_m, product_wind_m) * sum, SampleStatus::ok};
}

void Field::sample_wind(std::span<const Place> places, std::span<WindSample> out,
                        std::size_t member) const noexcept {
  for (std::size_t i = 0; i < places.size(); ++i) out[i] = wind_at(places[i], member);
}

SeaSample Field::sea_at(const Place& place) const noexcept {
  const Spot here = spot(place.longitude_deg, place.latitude_deg);
  const std::optional<TimePlace> time = when(place.time);
  if (here.status != SampleStatus::ok) return {{}, here.status};
  if (!time) return {{}, SampleStatus::outside_time};
  MeanSea mean;
  for (std::uint32_t c = 0; c < here.stencil.count; ++c) {
    const std::vector<SeaState>& sea = snapshot_->columns[here.stencil.column[c]].sea;
    if (sea.empty()) return {unknown_sea, SampleStatus::missing};
    const double weight = here.stencil.weight[c];
    mean.add(weight * (1 - time->upper), sea[time->low]);
    if (time->upper > 0) mean.add(weight * time->upper, sea[time->low + 1]);
  }
  return mean.sample();
}

void Field::sample_sea(std::span<const Place> places, std::span<SeaSample> out) const noexcept {
  for (std::size_t i = 0; i < places.size(); ++i) out[i] = sea_at(places[i]);
}

}  // namespace slackwater
