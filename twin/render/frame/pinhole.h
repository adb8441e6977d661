#pragma once
#include <array>
#include <optional>

#include "twin/inspection/instrument/instrument.h"
#include "twin/inspection/instrument/look.h"
#include "twin/scene/structure.h"

namespace slackwater::twin {

/// Where a place falls on a picture.
struct PixelPlace {
  double u = 0;        ///< from the left edge; the middle of the first pixel is at 0.5
  double v = 0;        ///< from the upper edge
  double depth_m = 0;  ///< along the camera's axis, above 0
};

/// A pinhole camera at a moment, NED of the run. The place (u, v) of its picture, counted from the
/// upper left corner, sees along
///
///   d = (axis + (u - w/2)/f_u right + (v - h/2)/f_v down) / |...|,   down = axis x right,
///   f_u = w / (2 tan(horizontal/2)),  f_v = h / (2 tan(vertical/2))  in pixels:
///
/// the camera of twin/sensor/camera.h and of the instruments' frames (quality.h). Pixel (i, j) is
/// told by its middle, (i + 1/2, j + 1/2). Whoever counts from that middle, as OpenCV does, takes
/// half a pixel from both of the camera matrix' centres.
/// Source: Hartley and Zisserman, Multiple View Geometry (2004), 6.1.
class Pinhole {
 public:
  /// @param pose   of the camera: position, axis and right
  /// @param frame  pixels and angles, in the medium
  Pinhole(const Pose& pose, const FrameFootprint& frame) noexcept;

  [[nodiscard]] int wide() const noexcept { return wide_; }
  [[nodiscard]] int high() const noexcept { return high_; }
  [[nodiscard]] double focal_u() const noexcept { return focal_u_; }  ///< pixels
  [[nodiscard]] double focal_v() const noexcept { return focal_v_; }
  [[nodiscard]] const Triple<double>& position_m() const noexcept { return position_m_; }
  [[nodiscard]] const Triple<double>& axis() const noexcept { return axis_; }
  [[nodiscard]] const Triple<double>& right() const noexcept { return right_; }
  [[nodiscard]] const Triple<double>& down() const noexcept { return down_; }

  /// Unit.
  [[nodiscard]] Triple<double> direction(double u, double v) const noexcept {
    const Triple<double> way =
        axis_ + ((u - 0.5 * wide_) / focal_u_) * right_ + ((v - 0.5 * high_) / focal_v_) * down_;
    return (1 / length_of(way)) * way;
  }
  /// Of the middle of a pixel.
  [[nodiscard]] Ray ray(int i, int j) const noexcept {
    return {position_m_, direction(i + 0.5, j + 0.5)};
  }
  /// Nothing for what is not before the camera.
  [[nodiscard]] std::optional<PixelPlace> place_of(const Triple<double>& at_m) const noexcept;
  /// K, row by row: (f_u, 0, w/2; 0, f_v, h/2; 0, 0, 1).
  [[nodiscard]] std::array<double, 9> matrix() const noexcept;

 private:
  Triple<double> position_m_, axis_, right_, down_;
  int wide_ = 0, high_ = 0;
  double focal_u_ = 0, focal_v_ = 0;
};

}  // namespace slackwater::twin
