#pragma once
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/current/astronomy.h"

namespace slackwater {

/// A constituent too close to its carrier to be fitted.
struct InferredConstituent {
  const Constituent* constituent = nullptr;
  double ratio = 0;  ///< equilibrium amplitude over that of the carrier
};

/// A pair of unknowns (W+, W-) and the constituents that ride on it.
struct TidalCarrier {
  const Constituent* constituent = nullptr;
  std::vector<InferredConstituent> carried;
};

/// What a record of this length can tell apart, by the Rayleigh criterion: the table of `fit_tide`.
[[nodiscard]] std::vector<TidalCarrier> tidal_carriers_for(Duration record);

/// Factor on the counter-clockwise phasor of the carrier, at `reference`, that gives the one of the
/// inferred constituent: the same lag behind its own equilibrium tide. Its conjugate goes with the
/// clockwise phasor.
[[nodiscard]] Horizontal inference_factor(const Constituent& carrier,
                                          const InferredConstituent& inferred, UtcTime reference);

}  // namespace slackwater
