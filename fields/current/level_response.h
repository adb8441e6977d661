#pragma once
#include "fields/current/complex.h"

namespace slackwater {

/// How the steady current at one depth answers its two causes:
///
///   W = interior * W_interior + stress * T
///
/// with W_interior the flow of the interior (m/s) and T the surface stress (Pa), all east + i
/// north.
template <typename T>
struct LevelResponse {
  Complex<T> interior;  ///< no dimension: 1 far from the bed, 0 on a no-slip bed
  Complex<T> stress;    ///< m/s per Pa
};

}  // namespace slackwater
