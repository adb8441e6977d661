#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// A run of NOAA's GFS, 0.25 degree, 3-hourly.
struct GfsRun {
  UtcTime begun;
  std::chrono::hours last_step{0};     ///< the last that is wanted
  std::vector<std::string> addresses;  ///< of each step, cut by NOMADS; none: it begins too late
};
inline constexpr std::chrono::hours gfs_step{3};
/// Runs begin at 00, 06, 12 and 18 UTC. Their first files lie on NOMADS 3 h 46 min to 3 h 51 min
/// later (f000 of 2024-07-21 at 03:46: development notes of the RRFS workflow); the rest of five
/// hours is for the later steps.
inline constexpr std::chrono::hours gfs_run_every{6};
inline constexpr std::chrono::hours gfs_published_after{5};

/// The newest run that was published by `issued`, and its steps until a time: the wind at 10 m of a
/// few cells about a site.
[[nodiscard]] GfsRun gfs_run(const Site& site, UtcTime issued, UtcTime until);

/// Where NOMADS gives a step of it. @param step  three digits, or what stands for them
[[nodiscard]] std::string gfs_address(const Site& site, UtcTime run, const std::string& step);

}  // namespace slackwater::api
