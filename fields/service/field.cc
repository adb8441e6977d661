#include "fields/service/field.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "fields/base/text.h"
#include "fields/service/bed_rule.h"

namespace slackwater {
namespace {

bool are_even(const std::vector<UtcTime>& time) {
  if (time.size() < 2) return false;
  for (std::size_t i = 2; i < time.size(); ++i) {
    if (time[i] - time[i - 1] != time[1] - time[0]) return false;
  }
  return true;
}

/// Shares of a step nearer to a stamp than this are the stamp: a millisecond of eleven days.
constexpr double same_stamp = 1e-9;

void expect_whole(const Snapshot& snapshot) {
  const std::size_t times = snapshot.time.size();
  const std::size_t values = times * snapshot.depth_m.size();
  const auto is = [](std::size_t size, std::size_t wanted) { return size == 0 || size == wanted; };
  for (const ForecastColumn& column : snapshot.columns) {
    const bool has_current = !column.current_m_s.empty();
    expects(is(column.current_m_s.size(), values) &&
                column.current_status.size() == (has_current ? values : 0) &&
                column.current_sigma_m_s.size() == (has_current ? values : 0),
            "a column has a current, a sigma and a status for each time and level, or none");
    expects(is(column.wind_m_s.size(), times) && is(column.sea.size(), times) &&
                is(column.height_spread.size(), column.sea.size()),
            "a column has wind and waves for each time, or none");
    const SeaLevel& level = column.sea_level;
    expects(is(level.level_m.size(), times) && level.sigma_m.size() == level.level_m.size(),
            "a column has a level of the sea and a sigma for each time, or none");
  }
}

/// What the level of each member is off, in standard deviations: 0 of the central one, then
/// opposite pairs; of a member the same whatever their number.
std::vector<double> level_errors(std::uint64_t seed, std::size_t members) {
  Rng rng(seed, "fields/sea_level");
  std::vector<double> errors(std::max<std::size_t>(1, members), 0);
  for (std::size_t m = 1; m < errors.size(); ++m)
    errors[m] = m % 2 == 1 ? rng.normal() : -errors[m - 1];
  return errors;
}

std::string degrees(double value, char positive, char negative) {
  return formatted("{:.3f} {}", std::abs(value), value < 0 ? negative : positive);
}

}  // namespace

std::string ValidRange::text() const {
  return "longitude " + degrees(box.west_deg, 'E', 'W') + " to " + degrees(box.east_deg, 'E', 'W') +
         ", latitude " + degrees(box.south_deg, 'N', 'S') + " to " +
         degrees(box.north_deg, 'N', 'S') + ", " + format_utc(from) + " to " + format_utc(to) +
         formatted(", depth 0 to {:.1f} m", deepest_m);
}

Field::Field(std::shared_ptr<const Snapshot> snapshot) : snapshot_(std::move(snapshot)) {
  expects(snapshot_ && !snapshot_->columns.empty() && !snapshot_->time.empty(),
          "a field needs a snapshot with columns and times");
  expect_whole(*snapshot_);
  std::vector<GeoPoint> points;
  for (const ForecastColumn& column : snapshot_->columns) {
    points.push_back(column.point);
    water_depth_m_.push_back(column.water_depth_m);
    known_to_m_.push_back(known_to_m(column, snapshot_->depth_m));
  }
  layout_ = ColumnLayout(points);
  for (std::size_t m = 0; m < std::max<std::size_t>(1, snapshot_->members); ++m) {
    const bool is_held = std::any_of(
        snapshot_->columns.begin(), snapshot_->columns.end(),
        [&](const ForecastColumn& column) { return !current_of_member(column, m).empty(); });
    if (!is_held) break;
    member_.emplace_back(*snapshot_, m);
  }
  level_error_ = level_errors(snapshot_->seed, snapshot_->members);
  const std::vector<UtcTime>& time = snapshot_->time;
  if (are_even(time)) stamps_per_ms_ = 1.0 / static_cast<double>((time[1] - time[0]).count());
  range_ = {layout_.box(), time.front(), time.back(),
            *std::max_element(water_depth_m_.begin(), water_depth_m_.end())};
  const bool are_numbers = std::all_of(water_depth_m_.begin(), water_depth_m_.end(),
                                       [](double depth) { return std::isfinite(depth); });
  if (!are_numbers) return;
  shallowest_m_ = *std::min_element(water_depth_m_.begin(), water_depth_m_.end());
  shallowest_known_m_ =
      std::min(shallowest_m_, *std::min_element(known_to_m_.begin(), known_to_m_.end()));
}

Field::Spot Field::spot(double longitude_deg, double latitude_deg) const noexcept {
  Spot spot;
  spot.stencil = layout_.at(longitude_deg, latitude_deg);
  if (!spot.stencil.is_inside) {
    spot.status = SampleStatus::outside_area;
  } else if (spot.stencil.count == 0) {
    spot.status = SampleStatus::land;
  } else {
    spot.status = SampleStatus::ok;
    spot.water_depth_m = bed_m(spot.stencil);
  }
  return spot;
}

std::optional<TimePlace> Field::when(UtcTime time) const noexcept {
  const std::vector<UtcTime>& stamps = snapshot_->time;
  if (stamps_per_ms_ <= 0) return place_in(stamps, time);
  if (time < stamps.front() || time > stamps.back()) return std::nullopt;
  const double steps = static_cast<double>((time - stamps.front()).count()) * stamps_per_ms_;
  const auto low = std::min(static_cast<std::size_t>(steps), stamps.size() - 2);
  const double upper = steps - static_cast<double>(low);
  // On a stamp its neighbours have no say: they may be missing.
  if (upper > 1 - same_stamp) return TimePlace{low + 1, 0};
  return TimePlace{low, upper < same_stamp ? 0 : upper};
}

double Field::bed_m(const ColumnStencil& stencil) const noexcept {
  double bed = 0;
  for (std::uint32_t c = 0; c < stencil.count; ++c)
    bed += stencil.weight[c] * water_depth_m_[stencil.column[c]];
  return bed;
}

SampleStatus Field::water(ColumnStencil& stencil, double depth_m) const noexcept {
  if (!stencil.is_inside) return SampleStatus::outside_area;
  if (stencil.count == 0) return SampleStatus::land;
  if (!(depth_m >= 0)) return SampleStatus::above_surface;
  if (depth_m <= shallowest_known_m_) return SampleStatus::ok;  // most water is
  if (!(depth_m <= bed_m(stencil) + same_depth_m)) return SampleStatus::below_bed;
  for (std::uint32_t c = 0; c < stencil.count; ++c) {
    if (!(depth_m <= water_depth_m_[stencil.column[c]] + same_depth_m)) stencil.weight[c] = 0;
  }
  return known(stencil, depth_m);
}

SampleStatus Field::known(const ColumnStencil& stencil, double depth_m) const noexcept {
  double known_m = 0;
  double whole = 0;
  for (std::uint32_t c = 0; c < stencil.count; ++c) {
    if (!(stencil.weight[c] > 0)) continue;
    known_m += stencil.weight[c] * known_to_m_[stencil.column[c]];
    whole += stencil.weight[c];
  }
  return depth_m * whole <= known_m ? SampleStatus::ok : SampleStatus::carried;
}

namespace {

CurrentSample without_value(SampleStatus status) noexcept {
  CurrentSample sample;
  sample.status = status;
  return sample;
}

/// A sample of the table where the depth is in water, `ok` or `carried`.
CurrentSample in_water(CurrentSample sample, SampleStatus status) noexcept {
  if (sample.status == SampleStatus::ok) sample.status = status;
  return sample;
}

/// What is said of a place in water that has `status`, at a time within the forecast or not.
SampleStatus in_time(SampleStatus status, bool is_within) noexcept {
  const bool is_at_sea = status != SampleStatus::outside_area && status != SampleStatus::land;
  return is_at_sea && !is_within ? SampleStatus::outside_time : status;
}

}  // namespace

CurrentSample Field::current(const Place& place, std::size_t member) const noexcept {
  ColumnStencil stencil = layout_.at(place.longitude_deg, place.latitude_deg);
  const std::optional<TimePlace> time = when(place.time);
  const SampleStatus status = in_time(water(stencil, place.vertical_m), time.has_value());
  if (!has_value(status)) return without_value(status);
  if (member >= member_.size()) return without_value(SampleStatus::missing);
  const CurrentTable& table = member_[member];
  return in_water(table.at(stencil, *time, table.level_at(place.vertical_m)), status);
}

void Field::sample_current(std::span<const Place> places, std::span<CurrentSample> out,
                           std::size_t member) const noexcept {
  const CurrentTable* table = member < member_.size() ? &member_[member] : nullptr;
  struct Asked {
    ColumnStencil stencil;
    std::optional<TimePlace> time;
    CurrentTable::Level level;
    SampleStatus status;
  };
  // Places at random wait for memory: the values of a block are asked for before the first is used.
  constexpr std::size_t block = 32;
  std::array<Asked, block> asked;
  for (std::size_t first = 0; first < places.size(); first += block) {
    const std::size_t count = std::min(block, places.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const Place& place = places[first + i];
      __builtin_prefetch(&place + 2 * block);
      Asked& a = asked[i];
      a.stencil = layout_.at(place.longitude_deg, place.latitude_deg);
      a.time = when(place.time);
      a.status = in_time(water(a.stencil, place.vertical_m), a.time.has_value());
      if (!has_value(a.status)) continue;
      if (!table) {
        a.status = SampleStatus::missing;
        continue;
      }
      a.level = table->level_at(place.vertical_m);
      table->prefetch(a.stencil, *a.time, a.level);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Asked& a = asked[i];
      out[first + i] = has_value(a.status)
                           ? in_water(table->at(a.stencil, *a.time, a.level), a.status)
                           : without_value(a.status);
    }
  }
}

void Field::sample_profiles(double longitude_deg, double latitude_deg,
                            std::span<const UtcTime> times, std::span<const double> depths_m,
                            std::span<CurrentSample> out, std::size_t member) const noexcept {
  const CurrentTable* table = member < member_.size() ? &member_[member] : nullptr;
  const ColumnStencil here = layout_.at(longitude_deg, latitude_deg);
  struct Asked {  // of a depth, for all times
    CurrentTable::Level level;
    std::array<double, 4> weight;
    SampleStatus status;
  };
  constexpr std::size_t block = 16;
  std::array<Asked, block> asked;
  ColumnStencil stencil = here;
  for (std::size_t first = 0; first < depths_m.size(); first += block) {
    const std::size_t count = std::min(block, depths_m.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      Asked& a = asked[i];
      stencil.weight = here.weight;
      a.status = water(stencil, depths_m[first + i]);
      a.weight = stencil.weight;
      if (!has_value(a.status)) continue;
      if (table)
        a.level = table->level_at(depths_m[first + i]);
      else
        a.status = SampleStatus::missing;
    }
    for (std::size_t t = 0; t < times.size(); ++t) {
      const std::optional<TimePlace> time = when(times[t]);
      CurrentSample* const profile = &out[t * depths_m.size() + first];
      for (std::size_t i = 0; i < count; ++i) {
        const SampleStatus status = in_time(asked[i].status, time.has_value());
        stencil.weight = asked[i].weight;
        profile[i] = has_value(status) ? in_water(table->at(stencil, *time, asked[i].level), status)
                                       : without_value(status);
      }
    }
  }
}

void Field::sample_profile(double longitude_deg, double latitude_deg, UtcTime time,
                           std::span<const double> depths_m, std::span<CurrentSample> out,
                           std::size_t member) const noexcept {
  const CurrentTable* table = member < member_.size() ? &member_[member] : nullptr;
  ColumnStencil stencil = layout_.at(longitude_deg, latitude_deg);
  const std::array<double, 4> weight = stencil.weight;
  const std::optional<TimePlace> at = when(time);
  for (std::size_t i = 0; i < depths_m.size(); ++i) {
    stencil.weight = weight;
    const SampleStatus status = in_time(water(stencil, depths_m[i]), at.has_value());
    if (!has_value(status))
      out[i] = without_value(status);
    else if (!table)
      out[i] = without_value(SampleStatus::missing);
    else
      out[i] = in_water(table->at(stencil, *at, table->level_at(depths_m[i])), status);
  }
}

void Field::sample_bed(std::span<const Place> places, std::span<BedSample> out) const noexcept {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Spot here = spot(places[i].longitude_deg, places[i].latitude_deg);
    out[i] = {here.water_depth_m, here.status};
  }
}

}  // namespace slackwater
