#pragma once
#include <span>
#include <vector>

#include "calibration/propagate/inertial_memory.h"
#include "calibration/propagate/propagate.h"

namespace slackwater::calibration {

/// What one depth carries to a later time.
struct Carried {
  Horizontal mean_m_s{};
  double variance_m2_s2 = 0;  ///< of a component: of the memory, and of what it leaves over
  /// 1: the doubt about the interior is the steady fit's; 0: it is in the variance above.
  double interior_doubt = 1;
};

/// What the residual of D says about later: at each level that was observed a constant, the share of a
/// slab and a free inertial oscillation (inertial_memory.h), and the mean of what they leave over in
/// the last hours. A level without a value in the last hours has nothing left over.
class CarriedResidual {
 public:
  /// @param residual  of D, what is to be remembered; levels as in the calibration
  CarriedResidual(const Calibration& calibration, const VectorColumn& residual, InertialBasis basis,
                  const PropagationSettings& settings);

  /// At one time, linear between the levels of D and held beyond them. A time before the end of D has
  /// lead 0.
  void at(UtcTime time, std::span<const double> depths_m, std::span<Carried> out) const;

  /// Sum over the levels of the variance that the memory does not explain.
  [[nodiscard]] double left_over_m2_s2() const noexcept;

 private:
  InertialBasis basis_;
  PropagationSettings settings_;
  double age_h_ = 0;  ///< of the last residual, at the end of D
  std::vector<double> node_m_;
  std::vector<InertialMemory> memory_;
  std::vector<Horizontal> recent_m_s_;
};

}  // namespace slackwater::calibration
