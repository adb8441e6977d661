#pragma once
#include "twin/render/frame/pinhole.h"

namespace slackwater::twin {

/// What one pixel sees of a flat face: a parallelogram about the place that its middle meets.
struct PixelFootprint {
  Triple<double> middle_m;
  Triple<double> side_m;  ///< along its rows, whole
  Triple<double> down_m;  ///< along its columns, whole

  /// With z the depth along the camera's axis and q the way to the place: P s is s moved along q
  /// into the face, and the sides are P right z/f_u and P down z/f_v (quality.h).
  /// @param face  unit normal
  PixelFootprint(const Pinhole& camera, const Triple<double>& at_m,
                 const Triple<double>& face) noexcept;
};

}  // namespace slackwater::twin
