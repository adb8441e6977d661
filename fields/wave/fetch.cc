#include "fields/wave/fetch.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"

namespace slackwater {
namespace {

/// 0 to 360 is the whole circle, 90 to 90 is nothing.
double width_deg(const FetchSector& sector) {
  if (sector.from_deg == sector.to_deg) return 0;
  const double width = compass_deg(sector.to_deg - sector.from_deg);
  return width > 0 ? width : 360.0;
}

std::string range_text(double from_deg, double to_deg) {
  return formatted("{:g} to {:g} degrees", compass_deg(from_deg), compass_deg(to_deg));
}

/// Each sector has to end where the next one begins.
void expect_circle(const std::vector<FetchSector>& clockwise) {
  constexpr double same_deg = 1e-6;
  for (std::size_t i = 0; i < clockwise.size(); ++i) {
    const FetchSector& sector = clockwise[i];
    const bool is_last = i + 1 == clockwise.size();
    const double end = sector.from_deg + width_deg(sector);
    const FetchSector& after = clockwise[is_last ? 0 : i + 1];
    const double next = after.from_deg + (is_last ? 360 : 0);
    if (end < next - same_deg) {
      refuse("found no fetch for wind from " + range_text(end, next) +
             "; sectors have to cover all directions, clockwise");
    }
    if (end > next + same_deg) {
      refuse("found two fetches for wind from " +
             range_text(next, std::min(end, next + width_deg(after))) +
             "; sectors must not overlap");
    }
  }
}

}  // namespace

Fetch::Fetch(double fetch_m) : sectors_{{0, 360, fetch_m}} {
  expects(fetch_m > 0, "a fetch is longer than nothing");
}

Fetch::Fetch(std::vector<FetchSector> sectors) : sectors_(std::move(sectors)) {
  if (sectors_.empty()) refuse("found no sector of fetch; expected one or more");
  for (FetchSector& sector : sectors_) {
    expects(sector.fetch_m > 0, "a fetch is longer than nothing");
    const double width = width_deg(sector);
    if (!(width > 0)) {
      refuse("found a sector from " + formatted("{:g}", sector.from_deg) +
             " degrees to the same; expected two different directions, or 0 to 360 for all");
    }
    sector.from_deg = compass_deg(sector.from_deg);
    sector.to_deg = sector.from_deg + width;
  }
  std::sort(sectors_.begin(), sectors_.end(),
            [](const FetchSector& a, const FetchSector& b) { return a.from_deg < b.from_deg; });
  expect_circle(sectors_);
}

double Fetch::at_m(double wind_from_direction_deg) const noexcept {
  const double direction = compass_deg(wind_from_direction_deg);
  // The last sector reaches through north to the first.
  const FetchSector* found = &sectors_.back();
  for (const FetchSector& sector : sectors_) {
    if (sector.from_deg <= direction) found = &sector;
  }
  return found->fetch_m;
}

double Fetch::shortest_m() const noexcept {
  double shortest = sectors_.front().fetch_m;
  for (const FetchSector& sector : sectors_) shortest = std::min(shortest, sector.fetch_m);
  return shortest;
}

double Fetch::longest_m() const noexcept {
  double longest = sectors_.front().fetch_m;
  for (const FetchSector& sector : sectors_) longest = std::max(longest, sector.fetch_m);
  return longest;
}

Fetch Fetch::times(double factor) const {
  expects(factor > 0, "a fetch is longer than nothing");
  Fetch scaled = *this;
  for (FetchSector& sector : scaled.sectors_) sector.fetch_m *= factor;
  return scaled;
}

std::string Fetch::text() const {
  if (shortest_m() == longest_m()) return formatted("{:g} km", longest_m() / 1000);
  return formatted("{:g} to {:g} km", shortest_m() / 1000, longest_m() / 1000) +
         " by the direction of the wind";
}

}  // namespace slackwater
