#pragma once
#include <cmath>

#include "fields/current/complex.h"

namespace slackwater {

/// What one depth receives of the mixed layer's own motion.
template <typename T>
struct MixedLayerShare {
  T slab{};             ///< S, 1 inside the mixed layer, 0 well below its base
  Complex<T> spiral{};  ///< E, the Ekman spiral of unit surface current
};

/// Where the mixed layer ends, how sharply, and how deep the stress of the wind reaches.
///
///   S(d) = [1 - tanh((d - h)/w)]/2       E(d) = exp(-(1 + i s) d/l)
///
/// with d the depth, h the depth of the mixed-layer base, 2w the thickness over which 76 % of the
/// step at the base happens, l = sqrt(2 nu/|f|) (ekman_scale.h) and s the sign of f: the spiral
/// turns clockwise with depth in the north, counter-clockwise in the south.
///
/// @note The spiral is not cut at the base. Confined to it (cosh(lambda (h - d))/sinh(lambda h),
/// no stress at h), it predicted held-out levels of real profiles less well when its scale was free
/// and no better when the scale followed h.
template <typename T>
struct MixedLayerShape {
  T base_depth_m{};           ///< h > 0
  T base_half_thickness_m{};  ///< w > 0
  T spiral_scale_m{};         ///< l > 0
  bool is_northern = true;    ///< s = +1, else -1

  /// @param depth_m  d >= 0, positive down from the surface. One tanh, exp, sin and cos.
  [[nodiscard]] MixedLayerShare<T> at_depth(double depth_m) const {
    using std::tanh;
    const T fall = T(depth_m) / spiral_scale_m;
    const T below_base = (T(depth_m) - base_depth_m) / base_half_thickness_m;
    return {T(0.5) * (T(1.0) - tanh(below_base)),
            exp(Complex<T>{-fall, is_northern ? -fall : fall})};
  }
};

/// The current at one instant in deep stratified water: an interior with weak shear, a mixed layer
/// that slides over it as a slab, and the Ekman spiral that the wind of the hour drives inside it.
///
///   W(d) = M + G d + B S(d) + V E(d)
///
/// with W = east + i north, Eulerian, towards. An instantaneous profile holds the inertial motion
/// of the mixed layer, which has any direction: therefore the slab B is a vector of its own, and V,
/// the surface current of the spiral, stands for the part that keeps up with the wind.
///
/// Assumes: horizontally uniform, bed out of reach (no bottom layer), |latitude| >= 3 degrees.
/// Templated on the scalar: calibration differentiates the very lines that the service evaluates.
/// Limits, held by the tests: B = G = 0 is the surface spiral over a constant interior
/// (ekman_layer.h); h -> infinity makes the slab one with the interior; l -> 0 leaves the slab.
///
/// Allocates nothing, thread-safe.
/// Sources: Ekman (1905) for E; Pollard and Millard (1970), Deep-Sea Research 17, 813-821, for the
/// mixed layer that moves inertially as a slab. The tanh is a smooth step, not a solution.
template <typename T>
struct MixedLayerProfile {
  Complex<T> interior_m_s{};  ///< M, the interior continued to the surface
  Complex<T> shear_per_s{};   ///< G = dW/dd of the interior, 1/s, positive where W grows downward
  Complex<T> slab_m_s{};      ///< B, the mixed layer relative to the interior
  Complex<T> spiral_m_s{};    ///< V, the spiral at the surface
  MixedLayerShape<T> shape;

  /// The current at a depth (m, >= 0, positive down), m/s.
  [[nodiscard]] Complex<T> at_depth(double depth_m) const {
    const MixedLayerShare<T> share = shape.at_depth(depth_m);
    return interior_m_s + scaled(shear_per_s, T(depth_m)) + scaled(slab_m_s, share.slab) +
           spiral_m_s * share.spiral;
  }
};

}  // namespace slackwater
