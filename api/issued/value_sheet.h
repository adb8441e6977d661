#pragma once
#include <algorithm>
#include <optional>
#include <span>

#include "api/issued/product_values.h"

// Only sources of this folder include this.

namespace slackwater::api {

/// Levels this near are one.
inline constexpr double same_level_m = 1e-3;
/// Values that are read at once where the window lets it: 32 MB.
inline constexpr std::size_t read_at_once = 8'000'000;

/// Where the values of some times are put.
class ValueSheet {
 public:
  ValueSheet(ProductValues& out, std::span<const UtcTime> all, std::size_t levels,
             std::size_t places)
      : out_(out), all_(all), levels_(levels), places_(places) {}

  [[nodiscard]] std::size_t levels() const noexcept { return levels_; }
  [[nodiscard]] std::optional<std::size_t> row(UtcTime time) const {
    const auto found = std::lower_bound(all_.begin(), all_.end(), time);
    if (found == all_.end() || *found != time) return std::nullopt;
    return static_cast<std::size_t>(found - all_.begin());
  }
  void put(std::size_t quantity, std::size_t row, std::size_t level, std::size_t place,
           double value) {
    out_.value[quantity][(row * levels_ + level) * places_ + place] = value;
  }
  ProductValues& out() noexcept { return out_; }

 private:
  ProductValues& out_;
  std::span<const UtcTime> all_;
  std::size_t levels_;
  std::size_t places_;
};

}  // namespace slackwater::api
