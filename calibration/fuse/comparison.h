#pragma once
#include <cstddef>
#include <vector>

#include "calibration/fuse/fusion_settings.h"
#include "calibration/fuse/observed_at.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// An observed depth between two of the product's.
struct DepthPlace {
  std::size_t low = 0;
  std::size_t high = 0;
  double share = 0;  ///< of the lower one
};

/// What an instrument and a product say at one time, at the instrument's depths.
struct Differences {
  std::vector<std::size_t> level;  ///< of the instrument
  std::vector<DepthPlace> place;
  std::vector<Horizontal> value;  ///< observed less product
  std::vector<Horizontal> observed;
  std::vector<double> noise_left;  ///< of a sample's noise variance
};

/// An instrument beside a product: at each time of the product the instrument's levels that have a
/// value there and lie within the product's depths (or at most 3 m beyond them). Refers to the
/// product, which outlives it.
class Comparison {
 public:
  Comparison(const VectorColumn& product, const VectorColumn& observed,
             const FusionSettings& settings);

  [[nodiscard]] Differences at(std::size_t t) const;

 private:
  const VectorColumn& product_;
  std::vector<std::size_t> index_;
  std::vector<DepthPlace> place_;
  std::vector<ObservedLevel> level_;
};

}  // namespace slackwater::calibration
