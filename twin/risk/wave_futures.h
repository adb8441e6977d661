#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::twin {

/// Wave heights for the members of a forecast whose waves have no spread: products of waves serve
/// one sea. Member 0 keeps it; in another it is
///
///   H + sigma(H, lead) z(t),   0 at least,
///
/// sigma the published error of forecast heights (fields/wave/height_error.h; its bias left out, as
/// on the page of a forecast), z a path of its own: standard normal at each time, remembered as
/// exp(-t / 12 h). The memory is an estimate: half a day, about as long as the error of a wind that
/// raises a sea lasts.
///
/// A path depends on (seed, member) and the lead alone, not on what is asked.
class WaveFutures {
 public:
  static constexpr double memory_h = 12;
  /// @param from  lead 0: the first time of the forecast  @param until  the last time asked about
  WaveFutures(std::uint64_t seed, std::size_t members, UtcTime from, UtcTime until);

  /// NaN of NaN. A time before `from` is as `from`, one after `until` as that.
  [[nodiscard]] double height_m(std::size_t member, double central_m, UtcTime time) const noexcept;
  [[nodiscard]] std::size_t members() const noexcept { return paths_.size() + 1; }

 private:
  UtcTime from_;
  std::vector<std::vector<double>> paths_;  ///< of members 1, 2, ...: hourly
};

}  // namespace slackwater::twin
