#include "api/ask/render/logged_poses.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

const ingest::TrajectoryFile::Variable& column(const ingest::TrajectoryFile& log,
                                               std::string_view name, std::size_t per) {
  const auto* found = log.find(name);
  if (found == nullptr || found->per != per ||
      found->values.size() != log.names.size() * log.t_s.size() * per)
    throw Error(ErrorKind::invalid_input,
                formatted("found no whole variable {}; give a log that `slackwater simulate` or "
                          "`live` wrote",
                          name));
  return *found;
}

double between(double a, double b, double share) { return a + share * (b - a); }
twin::Triple<double> between(const twin::Triple<double>& a, const twin::Triple<double>& b,
                             double share) {
  return a + share * (b - a);
}
/// Within half a turn to either side.
double angle_between(double a, double b, double share) {
  return a + share * std::remainder(b - a, 2 * constants::pi);
}

twin::Triple<double> or_zeros(const twin::Triple<double>& v) {
  const auto or_zero = [](double x) { return std::isfinite(x) ? x : 0; };
  return {or_zero(v.x), or_zero(v.y), or_zero(v.z)};
}
bool is_somewhere(const PoseRow& row) {
  return std::isfinite(row.position_m.x + row.position_m.y + row.position_m.z +
                       row.turned.roll_rad + row.turned.pitch_rad + row.turned.yaw_rad);
}

}  // namespace

twin::Carriage carriage_of(const PoseRow& row) noexcept {
  const twin::Rotation<double> attitude = twin::rotation_of(twin::attitude_of(row.turned));
  return {row.position_m, attitude, attitude.to_ned(row.velocity_m_s), row.rates_rad_s};
}

std::optional<twin::Carriage> carriage_as_logged(const twin::BodyState<double>& body) noexcept {
  const PoseRow row{body.position_m, twin::euler_angles(body.attitude), or_zeros(body.nu.linear),
                    or_zeros(body.nu.angular)};
  if (!is_somewhere(row)) return std::nullopt;
  return carriage_of(row);
}

LoggedPoses::LoggedPoses(const ingest::TrajectoryFile& log) : t_s_(log.t_s), log_(&log) {
  if (t_s_.empty() || log.names.empty())
    throw Error(ErrorKind::invalid_input,
                "found no rows; give a log that `slackwater simulate` or `live` wrote");
  for (const char* name : {"x", "y", "z", "roll", "pitch", "yaw"}) (void)column(log, name, 1);
  for (const char* name : {"velocity_body", "rate_body"}) (void)column(log, name, 3);
}

std::optional<PoseRow> LoggedPoses::row(std::size_t vehicle, std::size_t at) const {
  const auto value = [&](std::string_view name, std::size_t per = 1, std::size_t i = 0) {
    return log_->find(name)->values[(vehicle * t_s_.size() + at) * per + i];
  };
  const auto three = [&](std::string_view name) {
    return or_zeros({value(name, 3, 0), value(name, 3, 1), value(name, 3, 2)});
  };
  PoseRow row;
  row.position_m = {value("y"), value("x"), -value("z")};
  row.turned = {value("roll"), value("pitch"), value("yaw")};
  if (!is_somewhere(row)) return std::nullopt;
  row.velocity_m_s = three("velocity_body");
  row.rates_rad_s = three("rate_body");
  return row;
}

std::optional<twin::Carriage> LoggedPoses::at(std::size_t vehicle, double t_s) const {
  const auto next = std::upper_bound(t_s_.begin(), t_s_.end(), t_s);
  const std::size_t after = static_cast<std::size_t>(next - t_s_.begin());
  const std::size_t from = after == 0 ? 0 : after - 1;
  const auto a = row(vehicle, from);
  if (!a) return std::nullopt;
  PoseRow now = *a;
  if (after < t_s_.size() && after > 0 && t_s > t_s_[from]) {
    const auto b = row(vehicle, after);
    if (!b) return std::nullopt;
    const double share = (t_s - t_s_[from]) / (t_s_[after] - t_s_[from]);
    now.position_m = between(a->position_m, b->position_m, share);
    now.turned = {angle_between(a->turned.roll_rad, b->turned.roll_rad, share),
                  between(a->turned.pitch_rad, b->turned.pitch_rad, share),
                  angle_between(a->turned.yaw_rad, b->turned.yaw_rad, share)};
    now.velocity_m_s = between(a->velocity_m_s, b->velocity_m_s, share);
    now.rates_rad_s = between(a->rates_rad_s, b->rates_rad_s, share);
  }
  return carriage_of(now);
}

}  // namespace slackwater::api
