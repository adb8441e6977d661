#include "twin/handling/trial_quantity.h"

#include <array>
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::twin {
namespace {

struct QuantityName {
  std::string_view column;
  TrialQuantity quantity{};
  double si = 1;
};
/// In the order of TrialQuantity; then other names of the same.
constexpr std::array<QuantityName, 20> quantity_names{
    {{"north_m", TrialQuantity::north},
     {"east_m", TrialQuantity::east},
     {"down_m", TrialQuantity::down},
     {"roll_rad", TrialQuantity::roll},
     {"pitch_rad", TrialQuantity::pitch},
     {"yaw_rad", TrialQuantity::yaw},
     {"u_m_s", TrialQuantity::u},
     {"v_m_s", TrialQuantity::v},
     {"w_m_s", TrialQuantity::w},
     {"p_rad_s", TrialQuantity::p},
     {"q_rad_s", TrialQuantity::q},
     {"r_rad_s", TrialQuantity::r},
     {"speed_m_s", TrialQuantity::speed},
     {"depth_m", TrialQuantity::down},
     {"roll_deg", TrialQuantity::roll, constants::degree},
     {"pitch_deg", TrialQuantity::pitch, constants::degree},
     {"yaw_deg", TrialQuantity::yaw, constants::degree},
     {"p_deg_s", TrialQuantity::p, constants::degree},
     {"q_deg_s", TrialQuantity::q, constants::degree},
     {"r_deg_s", TrialQuantity::r, constants::degree}}};

}  // namespace

std::string_view name_of(TrialQuantity quantity) noexcept {
  return quantity_names[static_cast<std::size_t>(quantity)].column;
}

std::string_view unit_of(TrialQuantity quantity) noexcept {
  switch (quantity) {
    case TrialQuantity::north:
    case TrialQuantity::east:
    case TrialQuantity::down:
      return "m";
    case TrialQuantity::roll:
    case TrialQuantity::pitch:
    case TrialQuantity::yaw:
      return "rad";
    case TrialQuantity::u:
    case TrialQuantity::v:
    case TrialQuantity::w:
    case TrialQuantity::speed:
      return "m/s";
    case TrialQuantity::p:
    case TrialQuantity::q:
    case TrialQuantity::r:
      return "rad/s";
  }
  return "";
}

bool is_angle(TrialQuantity quantity) noexcept { return unit_of(quantity) == "rad"; }

std::optional<MeasuredName> measured_name(std::string_view column) noexcept {
  for (const QuantityName& name : quantity_names)
    if (name.column == column) return MeasuredName{name.quantity, name.si};
  return std::nullopt;
}

std::vector<std::string> measured_names() {
  std::vector<std::string> names;
  names.reserve(quantity_names.size());
  for (const QuantityName& name : quantity_names) names.emplace_back(name.column);
  return names;
}

double value_of(TrialQuantity quantity, const BodyState<double>& body) noexcept {
  switch (quantity) {
    case TrialQuantity::north:
      return body.position_m.x;
    case TrialQuantity::east:
      return body.position_m.y;
    case TrialQuantity::down:
      return body.position_m.z;
    case TrialQuantity::roll:
      return euler_angles(body.attitude).roll_rad;
    case TrialQuantity::pitch:
      return euler_angles(body.attitude).pitch_rad;
    case TrialQuantity::yaw:
      return euler_angles(body.attitude).yaw_rad;
    case TrialQuantity::u:
      return body.nu.linear.x;
    case TrialQuantity::v:
      return body.nu.linear.y;
    case TrialQuantity::w:
      return body.nu.linear.z;
    case TrialQuantity::p:
      return body.nu.angular.x;
    case TrialQuantity::q:
      return body.nu.angular.y;
    case TrialQuantity::r:
      return body.nu.angular.z;
    case TrialQuantity::speed: {
      const Triple<double> over_ground = rotation_of(body.attitude).to_ned(body.nu.linear);
      return std::hypot(over_ground.x, over_ground.y);
    }
  }
  return 0;
}

}  // namespace slackwater::twin
