#include "fields/service/snapshot.h"

#include <algorithm>
#include <cassert>

#include "fields/base/constants.h"

namespace slackwater {
namespace {

/// The `member`-th block of `size` values, members counted from 1; empty where it is not there.
std::span<const Horizontal> member_block(const std::vector<Horizontal>& members, std::size_t member,
                                         std::size_t size) noexcept {
  if (size == 0 || member > members.size() / size) return {};
  return std::span(members).subspan((member - 1) * size, size);
}

}  // namespace

bool has_currents(const ForecastColumn& column) noexcept {
  return std::any_of(column.current_status.begin(), column.current_status.end(),
                     [](SampleStatus status) { return has_value(status); });
}

bool has_waves(const Snapshot& forecast) noexcept {
  return std::any_of(forecast.columns.begin(), forecast.columns.end(),
                     [](const ForecastColumn& column) { return !column.sea.empty(); });
}

std::span<const Horizontal> current_of_member(const ForecastColumn& column,
                                              std::size_t member) noexcept {
  if (member == 0) return column.current_m_s;
  return member_block(column.member_m_s, member, column.current_m_s.size());
}

std::span<const Horizontal> wind_of_member(const ForecastColumn& column,
                                           std::size_t member) noexcept {
  if (member == 0 || column.wind_member_m_s.empty()) return column.wind_m_s;
  return member_block(column.wind_member_m_s, member, column.wind_m_s.size());
}

CurrentQuantiles quantiles_of(const CurrentSample& central) noexcept {
  assert(has_value(central.status));
  const double reach = constants::normal_p90 * central.sigma_m_s;
  const Horizontal both(reach, reach);
  return {central.velocity_m_s - both, central.velocity_m_s, central.velocity_m_s + both};
}

}  // namespace slackwater
