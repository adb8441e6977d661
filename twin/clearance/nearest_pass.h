#pragma once
#include <algorithm>
#include <limits>

#include "twin/body/attitude.h"

namespace slackwater::twin {

/// The nearest that something came to a vehicle, and when. Numbers only.
struct NearestPass {
  double distance_m = std::numeric_limits<double>::infinity();
  double t_s = 0;    ///< since the epoch
  double whom = -1;  ///< a vehicle or structure by its place, a vessel by its MMSI; below 0: nobody

  [[nodiscard]] bool is_any() const noexcept { return whom >= 0; }
  void take(double least_m, double at_s, double by_whom) noexcept {
    if (least_m < distance_m) *this = {least_m, at_s, by_whom};
  }
  friend bool operator==(const NearestPass&, const NearestPass&) = default;
};

/// The nearest passes of a vehicle in a run so far. Numbers only.
struct NearestPasses {
  NearestPass vehicle;    ///< of the run, from origin to origin
  NearestPass structure;  ///< from its origin to a face, negative inside
  NearestPass vessel;     ///< of the traffic, in the plane, to the position that it reports
  NearestPass line;       ///< another's tether, by its owner, from its origin
  friend bool operator==(const NearestPasses&, const NearestPasses&) = default;
};

/// The least distance on a straight way, and how far along it, from 0 to 1.
struct LeastOnWay {
  double distance_m = 0;
  double share = 0;
};

/// Of two points that go straight in the same time, from what lies between them before and after:
/// |a + s (b - a)| is least at s = -a . (b - a) / |b - a|^2, within [0, 1].
[[nodiscard]] inline LeastOnWay least_between(const Triple<double>& before_m,
                                              const Triple<double>& after_m) noexcept {
  const Triple<double> way = after_m - before_m;
  const double square = dot(way, way);
  const double share = square > 0 ? std::clamp(-dot(before_m, way) / square, 0.0, 1.0) : 0.0;
  return {length_of(share < 1 ? before_m + share * way : after_m), share};
}

/// Of a straight way and a straight piece that lies still. Ericson, Real-Time Collision Detection
/// (2005), 5.1.9.
[[nodiscard]] inline LeastOnWay least_to_piece(const Triple<double>& from_m,
                                               const Triple<double>& to_m, const Triple<double>& a,
                                               const Triple<double>& b) noexcept {
  const Triple<double> way = to_m - from_m, piece = b - a, off = from_m - a;
  const double way2 = dot(way, way), piece2 = dot(piece, piece);
  const double off_way = dot(way, off), off_piece = dot(piece, off);
  double s = 0, t = 0;
  if (way2 > 0 && piece2 > 0) {
    const double both = dot(way, piece), square = way2 * piece2 - both * both;
    if (square > 0) s = std::clamp((both * off_piece - off_way * piece2) / square, 0.0, 1.0);
    t = (both * s + off_piece) / piece2;
    if (t < 0 || t > 1) {
      t = std::clamp(t, 0.0, 1.0);
      s = std::clamp((t * both - off_way) / way2, 0.0, 1.0);
    }
  } else if (way2 > 0) {
    s = std::clamp(-off_way / way2, 0.0, 1.0);
  } else if (piece2 > 0) {
    t = std::clamp(off_piece / piece2, 0.0, 1.0);
  }
  return {length_of(off + s * way - t * piece), s};
}

}  // namespace slackwater::twin
