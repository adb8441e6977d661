#include "api/door/dds/message/sensor_messages.h"

#include <cmath>

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/float_messages.h"
#include "api/door/dds/message/map_frame.h"
#include "api/door/dds/message/parts.h"

namespace slackwater::dds {
namespace {

/// Unit, ENU.
struct FrameAxes {
  twin::Triple<double> x, y, z;
};

FrameAxes axes_of(const twin::Pose& pose, SensorAxes axes) {
  const twin::Triple<double> forward = enu_ned(pose.axis), right = enu_ned(pose.right),
                             down = enu_ned(cross(pose.axis, pose.right));
  switch (axes) {
    case SensorAxes::camera:
      return {right, down, forward};
    case SensorAxes::scanner:
      return {forward, -1.0 * right, -1.0 * down};
    case SensorAxes::fan:
      break;
  }
  return {-1.0 * down, right, forward};
}

/// The quaternion of a rotation whose columns these axes are, w not negative. By the largest of the
/// four, so that none is a small difference (Shepperd 1978, J. Guidance and Control 1, 223).
geometry_msgs::msg::Quaternion turned_by(const FrameAxes& a) {
  const double trace = a.x.x + a.y.y + a.z.z;
  double w = 1 + trace, x = 1 + 2 * a.x.x - trace, y = 1 + 2 * a.y.y - trace,
         z = 1 + 2 * a.z.z - trace;                                         // 4 times their squares
  const double wx = a.y.z - a.z.y, wy = a.z.x - a.x.z, wz = a.x.y - a.y.x;  // 4 w x, ...
  const double xy = a.y.x + a.x.y, yz = a.z.y + a.y.z, zx = a.x.z + a.z.x;
  if (w >= x && w >= y && w >= z) {
    x = wx, y = wy, z = wz;
  } else if (x >= y && x >= z) {
    w = wx, y = xy, z = zx;
  } else if (y >= z) {
    w = wy, x = xy, z = yz;
  } else {
    w = wz, x = zx, y = yz;
  }
  const double length = std::copysign(std::sqrt(w * w + x * x + y * y + z * z), w);
  geometry_msgs::msg::Quaternion q;
  q.w(w / length);
  q.x(x / length);
  q.y(y / length);
  q.z(z / length);
  return q;
}

Bytes number_image(int wide, int high, std::span<const float> numbers, const SensorStamp& of) {
  sensor_msgs::msg::Image message;
  message.header(header_message(of.stamp, of.frame_id));
  message.width(static_cast<std::uint32_t>(wide));
  message.height(static_cast<std::uint32_t>(high));
  message.encoding("32FC1");
  message.step(message.width() * static_cast<std::uint32_t>(sizeof(float)));
  message.data(float_bytes_of(numbers));
  return encoded(message);
}

}  // namespace

Bytes sensor_pose(const twin::Pose& pose, SensorAxes axes, const Stamp& stamp) {
  geometry_msgs::msg::PoseStamped message;
  message.header(header_message(stamp, map_frame));
  message.pose().position(xyz_message<geometry_msgs::msg::Point>(enu_ned(pose.position_m)));
  message.pose().orientation(turned_by(axes_of(pose, axes)));
  return encoded(message);
}

Bytes compressed_image(std::span<const std::uint8_t> jpeg, const SensorStamp& of) {
  sensor_msgs::msg::CompressedImage message;
  message.header(header_message(of.stamp, of.frame_id));
  message.format("jpeg");
  message.data().assign(jpeg.begin(), jpeg.end());
  return encoded(message);
}

Bytes camera_info(int wide, int high, const std::array<double, 9>& matrix, const SensorStamp& of,
                  double baseline_m) {
  std::array<double, 9> k = matrix;
  k[2] -= 0.5;
  k[5] -= 0.5;
  sensor_msgs::msg::CameraInfo message;
  message.header(header_message(of.stamp, of.frame_id));
  message.width(static_cast<std::uint32_t>(wide));
  message.height(static_cast<std::uint32_t>(high));
  message.distortion_model("plumb_bob");
  message.d().assign(5, 0.0);
  message.k(k);
  message.r({1, 0, 0, 0, 1, 0, 0, 0, 1});
  message.p({k[0], k[1], k[2], -k[0] * baseline_m, k[3], k[4], k[5], 0, k[6], k[7], k[8], 0});
  return encoded(message);
}

Bytes depth_image(const twin::TruthFrame& truth, const SensorStamp& of) {
  return number_image(truth.wide, truth.high, truth.depth_m, of);
}

Bytes heat_image(const twin::InfraredFrame& heat, const SensorStamp& of) {
  return number_image(heat.wide, heat.high, heat.apparent_k, of);
}

Bytes point_cloud(const twin::LidarScan& scan, const twin::LidarSheet& sheet,
                  const SensorStamp& of) {
  constexpr std::uint32_t of_a_point = 4;
  twin::Pose own;  // the scanner's own axes: forward, right, down
  own.axis = {1, 0, 0};
  own.right = {0, 1, 0};
  std::vector<float> numbers;
  numbers.reserve(of_a_point * scan.range_m.size());
  for (int channel = 0; channel < scan.channels; ++channel)
    for (int column = 0; column < scan.columns; ++column) {
      const std::size_t at = numbers.size() / of_a_point;
      const double range_m = scan.range_m[at];
      const twin::Triple<double> place =
          range_m * flu_frd(twin::lidar_direction(sheet, own, channel, column));
      for (const double number : {place.x, place.y, place.z})
        numbers.push_back(static_cast<float>(number));
      numbers.push_back(scan.intensity[at]);
    }
  return encoded(cloud_message({"x", "y", "z", "intensity"},
                               static_cast<std::size_t>(scan.channels), numbers, of));
}

}  // namespace slackwater::dds
