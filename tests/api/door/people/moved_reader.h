#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "api/door/people/wire/pose.h"
#include "session/session_generated.h"

namespace slackwater::tests {

/// Reads frames with `moved` as api/docs/session_wire.md tells a stranger to; shares nothing with
/// what writes them.
class MovedReader {
 public:
  using Numbers = std::array<double, 13>;
  struct Known {
    people::Pose shown;
    Numbers numbers{};
    std::array<double, 6> step{};
  };

  /// @return whether the frame could be taken; else the station waits for a whole one
  bool take(const session::Frame& frame) {
    const double now_ms = std::floor(1000 * frame.time_s() + 0.5);
    const double t = now_ms - at_ms_;
    std::vector<std::uint16_t> in_poses;
    for (const session::Pose* pose : *frame.poses()) in_poses.push_back(pose->vehicle());
    if (frame.is_whole()) {
      known_.clear();
      order_.clear();
    } else if (!follows(frame)) {
      return give_up();
    }
    is_lost_ = false;
    const std::size_t before = order_.size();
    for (const session::Pose* pose : *frame.poses()) take_pose(*pose);
    if (!frame.is_whole()) {
      bits_ = frame.moved();
      at_bit_ = 0;
      if (!take_bits(before, in_poses, t)) return give_up();
    }
    u_ = frame.is_whole() ? 0 : t;
    at_ms_ = now_ms;
    number_ = frame.number();
    return true;
  }
  [[nodiscard]] const Known& of(std::uint16_t vehicle) const { return known_.at(vehicle); }
  [[nodiscard]] std::size_t vehicles() const { return order_.size(); }
  [[nodiscard]] const std::vector<std::uint16_t>& order() const { return order_; }

 private:
  static double turned(double angle) { return angle - 16384 * std::floor((angle + 8192) / 16384); }
  bool follows(const session::Frame& frame) const {
    return !is_lost_ && frame.moved() != nullptr && frame.number() == number_ + 1;
  }
  bool give_up() {
    is_lost_ = true;
    return false;
  }
  static double count(double value, double steps) {
    const double count = std::floor(value * steps + 0.5);
    return std::fabs(count) <= 67108864 ? count : 0;
  }
  void take_pose(const session::Pose& p) {
    if (known_.count(p.vehicle()) == 0) order_.push_back(p.vehicle());
    Known& known = known_[p.vehicle()];
    known = {};
    known.shown = {p.east_m(),           p.north_m(),           p.up_m(),
                   p.roll_rad(),         p.pitch_rad(),         p.heading_rad(),
                   p.east_m_s(),         p.north_m_s(),         p.up_m_s(),
                   p.current_east_m_s(), p.current_north_m_s(), p.bed_m(),
                   p.charge(),           p.vehicle(),           p.halted()};
    const double angle = 2607.5945876176133;
    const double bed = static_cast<double>(p.up_m()) - static_cast<double>(p.bed_m());
    known.numbers = {count(p.east_m_s(), 100),
                     count(p.north_m_s(), 100),
                     count(p.up_m_s(), 100),
                     turned(count(p.roll_rad(), angle)),
                     turned(count(p.pitch_rad(), angle)),
                     turned(count(p.heading_rad(), angle)),
                     count(p.east_m(), 200),
                     count(p.north_m(), 200),
                     count(p.up_m(), 200),
                     count(p.current_east_m_s(), 100),
                     count(p.current_north_m_s(), 100),
                     count(bed, 20),
                     count(p.charge(), 2000)};
  }
  bool take_bits(std::size_t before, const std::vector<std::uint16_t>& in_poses, double t) {
    if (count() != static_cast<double>(before)) return false;
    for (std::size_t i = 0; i < before; ++i) {
      const std::uint16_t vehicle = order_[i];
      if (std::find(in_poses.begin(), in_poses.end(), vehicle) != in_poses.end()) continue;
      take_vehicle(known_[vehicle], t);
    }
    std::uint32_t h = 2166136261U;
    for (const std::uint16_t vehicle : order_)
      for (const double number : known_[vehicle].numbers)
        h = (h ^ static_cast<std::uint32_t>(static_cast<std::int64_t>(number))) * 16777619U;
    std::uint32_t told = 0;
    for (int i = 0; i < 16; ++i) told = 2 * told + bit();
    while (at_bit_ % 8 != 0)
      if (bit() != 0) return false;
    return told == ((h ^ (h >> 16U)) & 0xFFFFU) && at_bit_ == std::size_t{8} * bits_->size();
  }
  void take_vehicle(Known& known, double t) {
    Numbers now = known.numbers;
    if (bit() == 0) {
      known.step = {};
      return;
    }
    for (std::size_t i = 0; i < 13; ++i) {
      if (i == 11 && std::isnan(known.shown.bed_m)) continue;
      if (i == 12 && std::isnan(known.shown.charge)) continue;
      if (i < 6 && u_ > 0 && t <= 4 * u_)
        now[i] += std::floor((2 * known.step[i] * t + u_) / (2 * u_));
      if (i >= 6 && i < 9)
        now[i] += std::floor(((known.numbers[i - 6] + now[i - 6]) * t + 500) / 1000);
      const double code = count();
      now[i] += std::fmod(code, 2) == 0 ? code / 2 : -(code + 1) / 2;
      if (i >= 3 && i < 6) now[i] = turned(now[i]);
    }
    for (std::size_t i = 0; i < 6; ++i) {
      known.step[i] = now[i] - known.numbers[i];
      if (i >= 3) known.step[i] = turned(known.step[i]);
    }
    known.numbers = now;
    show(known);
  }
  static void show(Known& known) {
    const Numbers& n = known.numbers;
    const auto over = [&](std::size_t i, double steps) { return static_cast<float>(n[i] / steps); };
    people::Pose& p = known.shown;
    const double angle = 2607.5945876176133;
    const bool has_bed = !std::isnan(p.bed_m), has_charge = !std::isnan(p.charge);
    p.east_m_s = over(0, 100), p.north_m_s = over(1, 100), p.up_m_s = over(2, 100);
    p.roll_rad = over(3, angle), p.pitch_rad = over(4, angle), p.heading_rad = over(5, angle);
    p.east_m = over(6, 200), p.north_m = over(7, 200), p.up_m = over(8, 200);
    p.current_east_m_s = over(9, 100), p.current_north_m_s = over(10, 100);
    if (has_bed) p.bed_m = static_cast<float>(n[8] / 200 - n[11] / 20);
    if (has_charge) p.charge = over(12, 2000);
  }
  std::uint32_t bit() {
    if (at_bit_ >= std::size_t{8} * bits_->size())
      return 1;  // ends each code; found out by what is left over
    const std::uint32_t byte = bits_->Get(static_cast<std::uint32_t>(at_bit_ / 8));
    const std::uint32_t is = byte >> (7 - at_bit_ % 8) & 1U;
    ++at_bit_;
    return is;
  }
  double count() {
    int zeros = 0;
    while (zeros < 40 && bit() == 0) ++zeros;
    double value = 1;
    for (int i = 0; i < zeros; ++i) value = 2 * value + bit();
    return value - 1;
  }

  std::map<std::uint16_t, Known> known_;
  std::vector<std::uint16_t> order_;
  const flatbuffers::Vector<std::uint8_t>* bits_ = nullptr;
  std::size_t at_bit_ = 0;
  double at_ms_ = 0, u_ = 0;
  std::uint32_t number_ = 0;
  bool is_lost_ = true;
};

}  // namespace slackwater::tests
