#include "api/door/people/wire/moved.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace slackwater::people {
namespace {

constexpr double longest_ms = 10'000;         ///< from frame to frame; after longer a whole one
constexpr std::int32_t steps_apart = 4;       ///< a step says nothing of a way so many times longer
constexpr std::int64_t farthest = 1LL << 24;  ///< off what is expected

/// Rounded down, of below too.
std::int64_t divided(std::int64_t a, std::int64_t b) noexcept {
  return a / b - static_cast<std::int64_t>(a % b < 0);
}

bool is_angle(std::size_t number) noexcept {
  return number >= CountedPose::angles && number < CountedPose::places;
}

/// What goes wrong at either end is seen by this: 16 bits of all that the station knows.
std::uint32_t checksum(std::uint32_t sum, const CountedPose& pose) noexcept {
  for (const std::int32_t n : pose.n) sum = (sum ^ static_cast<std::uint32_t>(n)) * 16'777'619U;
  return sum;
}

}  // namespace

bool Moved::look(std::span<const Pose> now, double time_s) {
  now_.clear();
  for (const Pose& pose : now) now_.push_back(counted(pose));
  now_ms_ = std::floor(1000 * time_s + 0.5);
  const double since_ms = now_ms_ - told_ms_;
  const bool is_soon = since_ms >= 0 && since_ms <= longest_ms;  // and a number
  since_ms_ = is_soon ? static_cast<std::int32_t>(since_ms) : 0;
  is_whole_ = !is_soon || told_.empty() || told_.size() > now_.size();
  bool is_news = !is_soon || told_.size() != now_.size();
  for (std::size_t i = 0; i < told_.size() && !is_whole_; ++i) {
    is_whole_ = told_[i].pose.vehicle != now_[i].vehicle;
    is_news = is_news || !now_[i].is_like(told_[i].pose) || now_[i].n != told_[i].pose.n;
  }
  return is_news || is_whole_;
}

bool Moved::tell(std::span<const Pose> now) {
  bits_.clear();
  told_ms_ = now_ms_;
  if (is_whole_) {
    step_ms_ = 0;
    poses_.assign(now.begin(), now.end());
    told_.clear();
    for (const CountedPose& pose : now_) told_.push_back({pose, {}});
    return true;
  }
  poses_.clear();
  const std::size_t known = told_.size();
  bits_.put_count(static_cast<std::uint32_t>(known));
  std::uint32_t sum = 2'166'136'261U;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (i >= known || !put(told_[i], now_[i])) {
      if (i >= known) told_.emplace_back();
      told_[i] = {now_[i], {}};
      poses_.push_back(now[i]);
    }
    sum = checksum(sum, now_[i]);
  }
  bits_.put(sum >> 16U ^ sum, 16);
  step_ms_ = since_ms_;
  return false;
}

/// Velocity and angles go on as with the last frame; the place goes with the mean velocity from
/// there to here, which is told before it; all else stays.
std::int64_t Moved::expected(const Told& told, const CountedPose& now,
                             std::size_t number) const noexcept {
  const std::int64_t last = told.pose.n[number];
  if (number < CountedPose::places) {
    if (step_ms_ == 0 || since_ms_ > steps_apart * step_ms_) return last;
    const std::int64_t way = std::int64_t{2} * told.step[number] * since_ms_ + step_ms_;
    return last + divided(way, std::int64_t{2} * step_ms_);
  }
  if (number >= CountedPose::currents) return last;
  const std::size_t axis = number - CountedPose::places;
  const std::int64_t twice = std::int64_t{told.pose.n[axis]} + now.n[axis];
  return last + divided(twice * since_ms_ + 500, 1000);  // steps of 1/100 m/s, ms and 1/200 m
}

/// @return whether the vehicle could be told so
bool Moved::put(Told& told, const CountedPose& now) {
  if (!now.is_like(told.pose)) return false;
  if (now.n == told.pose.n) {
    bits_.put(0, 1);
    told.step = {};
    return true;
  }
  std::array<std::int32_t, CountedPose::numbers> off{};
  for (std::size_t i = 0; i < off.size(); ++i) {
    std::int64_t way = now.n[i] - expected(told, now, i);
    if (is_angle(i)) way = wrapped(way);
    if (std::abs(way) >= farthest) return false;
    off[i] = static_cast<std::int32_t>(way);
  }
  bits_.put(1, 1);
  for (std::size_t i = 0; i < off.size(); ++i)
    if (now.is_known(i)) bits_.put_signed(off[i]);
  for (std::size_t i = 0; i < told.step.size(); ++i) {
    const std::int32_t step = now.n[i] - told.pose.n[i];
    told.step[i] = is_angle(i) ? wrapped(step) : step;
  }
  told.pose = now;
  return true;
}

}  // namespace slackwater::people
