#include "calibration/residuals/separable_sum.h"

#include <algorithm>

namespace slackwater::calibration {

void SeparableSum::reserve(Eigen::Index terms) {
  if (terms <= over_time_.cols()) return;
  const Eigen::Index room = std::max<Eigen::Index>(terms, 2 * over_time_.cols() + 16);
  over_time_.conservativeResize(2 * times_, room);
  over_levels_.conservativeResize(room, levels_);
}

void SeparableSum::add(const OverTime& p, const Eigen::RowVectorXd& s) {
  reserve(terms_ + 1);
  over_time_.col(terms_).head(times_) = p.real();
  over_time_.col(terms_).tail(times_) = p.imag();
  over_levels_.row(terms_++) = s;
}

void SeparableSum::add(const OverTime& p, const OverLevels& s) {
  add(p, Eigen::RowVectorXd(s.real()));
  reserve(terms_ + 1);
  over_time_.col(terms_).head(times_) = -p.imag();
  over_time_.col(terms_).tail(times_) = p.real();
  over_levels_.row(terms_++) = s.imag();
}

void SeparableSum::write(Eigen::Ref<Planes> out) const {
  out.noalias() = over_time_.leftCols(terms_) * over_levels_.topRows(terms_);
}

}  // namespace slackwater::calibration
