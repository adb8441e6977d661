#include "api/door/dds/message/sensor_messages.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/map_frame.h"
#include "api/door/dds/message/parts.h"
#include "fields/base/check.h"
#include "marine_acoustic_msgs.h"
#include "sensor_msgs.h"
#include "twin/render/ranging/fan.h"

namespace slackwater::dds {
namespace {

constexpr std::uint32_t float_bytes = sizeof(float);
static_assert(std::endian::native == std::endian::little, "messages say so of their numbers");

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

std::vector<std::uint8_t> bytes_of(std::span<const float> numbers) {
  std::vector<std::uint8_t> bytes(numbers.size_bytes());
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

sensor_msgs::msg::PointField field_at(const char* name, std::uint32_t offset) {
  constexpr std::uint8_t float32 = 7;
  sensor_msgs::msg::PointField field;
  field.name(name);
  field.offset(offset);
  field.datatype(float32);
  field.count(1);
  return field;
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

Bytes camera_info(int wide, int high, const std::array<double, 9>& matrix, const SensorStamp& of) {
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
  message.p({k[0], k[1], k[2], 0, k[3], k[4], k[5], 0, k[6], k[7], k[8], 0});
  return encoded(message);
}

Bytes depth_image(const twin::TruthFrame& truth, const SensorStamp& of) {
  sensor_msgs::msg::Image message;
  message.header(header_message(of.stamp, of.frame_id));
  message.width(static_cast<std::uint32_t>(truth.wide));
  message.height(static_cast<std::uint32_t>(truth.high));
  message.encoding("32FC1");
  message.step(static_cast<std::uint32_t>(truth.wide) * float_bytes);
  message.data(bytes_of(truth.depth_m));
  return encoded(message);
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
  sensor_msgs::msg::PointCloud2 message;
  message.header(header_message(of.stamp, of.frame_id));
  message.height(static_cast<std::uint32_t>(scan.channels));
  message.width(static_cast<std::uint32_t>(scan.columns));
  for (const auto& [name, place] :
       {std::pair{"x", 0U}, std::pair{"y", 1U}, std::pair{"z", 2U}, std::pair{"intensity", 3U}})
    message.fields().push_back(field_at(name, place * float_bytes));
  message.point_step(of_a_point * float_bytes);
  message.row_step(message.width() * message.point_step());
  message.data(bytes_of(numbers));
  return encoded(message);
}

Bytes sonar_image(const twin::SonarImage& image, const twin::ImagingSonarSheet& sheet,
                  double most_range_m, const SensorStamp& of) {
  constexpr std::uint32_t float32 = 8;
  const auto beams = static_cast<std::size_t>(image.beams);
  const auto bins = static_cast<std::size_t>(image.bins);
  expects(image.intensity.size() == beams * bins, "a ping has a number for each beam and bin");
  marine_acoustic_msgs::msg::ProjectedSonarImage message;
  message.header(header_message(of.stamp, of.frame_id));
  message.ping_info().frequency(static_cast<float>(sheet.frequency_hz));
  message.ping_info().tx_beamwidths().assign(beams, static_cast<float>(sheet.upright_rad));
  message.ping_info().rx_beamwidths().assign(beams, static_cast<float>(sheet.beam_rad));
  for (int beam = 0; beam < image.beams; ++beam) {
    const double bearing_rad = twin::beam_bearing_rad(sheet.across_rad, sheet.beams, beam);
    message.beam_directions().push_back(xyz_message<geometry_msgs::msg::Vector3>(
        {0, std::sin(bearing_rad), std::cos(bearing_rad)}));
  }
  std::vector<float> by_range;
  by_range.reserve(image.intensity.size());
  for (std::size_t bin = 0; bin < bins; ++bin) {
    message.ranges().push_back(static_cast<float>((static_cast<double>(bin) + 0.5) * most_range_m /
                                                  static_cast<double>(bins)));
    for (std::size_t beam = 0; beam < beams; ++beam)
      by_range.push_back(image.intensity[beam * bins + bin]);
  }
  message.image().dtype(float32);
  message.image().beam_count(static_cast<std::uint32_t>(beams));
  message.image().data(bytes_of(by_range));
  return encoded(message);
}

}  // namespace slackwater::dds
