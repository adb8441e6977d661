#pragma once
#include <array>
#include <span>
#include <string>

#include "api/door/dds/message/bytes.h"
#include "twin/inspection/instrument/look.h"
#include "twin/render/frame/truth_frame.h"
#include "twin/render/light/infrared_frame.h"
#include "twin/render/ranging/lidar.h"

namespace slackwater::dds {

// What cameras and lidars see, as messages; what sonars hear is beside it (sonar_messages.h). Their
// frame is that of the sensor, NAME/SENSOR, whose axes are those that ROS's users expect of its
// kind. Forward is the sensor's axis, whichever way that looks on the vehicle:
//
// | of      | x         | y         | z       | by                             |
// |---------|-----------|-----------|---------|--------------------------------|
// | camera  | right     | down      | forward | REP-103, "optical" frames      |
// | scanner | forward   | left      | up      | REP-103                        |
// | fan     | up        | starboard | forward | marine_acoustic_msgs           |
enum class SensorAxes { camera, scanner, fan };

/// Where a frame of a message is of.
struct SensorStamp {
  Stamp stamp;           ///< of the moment
  std::string frame_id;  ///< NAME/SENSOR
};

/// geometry_msgs/msg/PoseStamped in `map`: where the sensor is, and how its axes lie.
[[nodiscard]] Bytes sensor_pose(const twin::Pose& pose, SensorAxes axes, const Stamp& stamp);

/// sensor_msgs/msg/CompressedImage of a JPEG.
[[nodiscard]] Bytes compressed_image(std::span<const std::uint8_t> jpeg, const SensorStamp& of);

/// sensor_msgs/msg/CameraInfo of a pinhole without distortion. ROS and OpenCV count from the middle
/// of the first pixel, we from its corner: half a pixel is taken from both centres.
///
///   K = (f_u, 0, c_u - 1/2; 0, f_v, c_v - 1/2; 0, 0, 1),  R = I,  P = (K | 0)
///
/// Of the right one of a pair P(0, 3) = -f_u baseline; its frame is that of the left one.
///
/// @param matrix      row by row, as `Pinhole::matrix`
/// @param baseline_m  how far to the right of the frame's camera it stands
[[nodiscard]] Bytes camera_info(int wide, int high, const std::array<double, 9>& matrix,
                                const SensorStamp& of, double baseline_m = 0);

/// sensor_msgs/msg/Image, 32FC1: metres along the camera's axis, as REP-118 has it; not a number
/// where nothing is within reach.
[[nodiscard]] Bytes depth_image(const twin::TruthFrame& truth, const SensorStamp& of);

/// sensor_msgs/msg/Image, 32FC1: kelvins as told, of a black body that radiates so.
[[nodiscard]] Bytes heat_image(const twin::InfraredFrame& heat, const SensorStamp& of);

/// sensor_msgs/msg/PointCloud2 of x, y, z in metres and intensity, single precision: a row for each
/// channel from the lowest, a column for each bearing. As measured, with noise; what did not come
/// back is not a number.
[[nodiscard]] Bytes point_cloud(const twin::LidarScan& scan, const twin::LidarSheet& sheet,
                                const SensorStamp& of);

}  // namespace slackwater::dds
