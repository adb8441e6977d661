#include "fields/current/tide.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/statistics.h"
#include "fields/current/astronomy.h"
#include "fields/current/tidal_carriers.h"

namespace slackwater {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

constexpr double turn = 2.0 * constants::pi;
constexpr double day_s = 86400.0;
constexpr double largest_condition = 1.0e3;
constexpr double least_signal_to_noise = 2.0;
/// Noise that any stored product carries, so that an exact series does not keep terms of rounding
/// size.
constexpr double least_noise_m_s = 1.0e-6;
/// Means that pass less of a constituent than this cannot show it (a day passes 0.03 of M2).
constexpr double least_passed_by_mean = 0.1;

/// The samples with values, as needed by the normal equations.
struct Record {
  UtcTime reference{};
  std::vector<TimeCell> time;
  VectorXcd value;
  double usual_step_s = 0;
  double usual_width_s = 0;
};

Record select(std::span<const TimeCell> time, std::span<const Horizontal> value,
              std::span<const SampleStatus> status) {
  expects(time.size() == value.size() && time.size() == status.size(),
          "a tide is fitted to one value and one status per time");
  Record record;
  std::vector<Horizontal> kept;
  std::vector<double> step;
  std::vector<double> width;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!has_value(status[i])) continue;
    if (!record.time.empty())
      step.push_back(seconds_between(record.time.back().centre(), time[i].centre()));
    width.push_back(seconds_between(time[i].start, time[i].end));
    record.time.push_back(time[i]);
    kept.push_back(value[i]);
  }
  record.value = Eigen::Map<const VectorXcd>(kept.data(), static_cast<Index>(kept.size()));
  if (!step.empty()) record.usual_step_s = upper_median(std::move(step));
  if (!width.empty()) record.usual_width_s = upper_median(std::move(width));
  if (!record.time.empty()) {
    // The middle of the record keeps the phases small and the mean nearly orthogonal to the tide.
    record.reference =
        record.time.front().start + (record.time.back().end - record.time.front().start) / 2;
  }
  return record;
}

double length_s(const Record& record) {
  if (record.time.empty()) return 0.0;
  return seconds_between(record.time.front().centre(), record.time.back().centre()) +
         record.usual_step_s;
}

double passed_by_mean(double speed_rad_s, double width_s) {
  const double half = 0.5 * speed_rad_s * width_s;
  return std::abs(half) < 1e-8 ? 1.0 : std::sin(half) / half;
}

/// e^{i w t} at an instant, or its exact average over a mean's interval.
Horizontal turning(double speed_rad_s, UtcTime reference, const TimeCell& cell) {
  const double width_s = seconds_between(cell.start, cell.end);
  const double centre_s = seconds_between(reference, cell.start) + 0.5 * width_s;
  return std::polar(1.0, speed_rad_s * centre_s) * passed_by_mean(speed_rad_s, width_s);
}

MatrixXcd design(const Record& record, std::span<const TidalCarrier> carriers) {
  MatrixXcd a(static_cast<Index>(record.time.size()), static_cast<Index>(1 + 2 * carriers.size()));
  a.col(0).setOnes();
  Index column = 1;
  const auto add = [&](double speed_rad_s, Horizontal factor) {
    for (Index i = 0; i < a.rows(); ++i) {
      a(i, column) +=
          factor * turning(speed_rad_s, record.reference, record.time[static_cast<std::size_t>(i)]);
    }
  };
  for (const TidalCarrier& carrier : carriers) {
    a.col(column).setZero();
    add(carrier.constituent->speed_rad_s, 1.0);
    for (const InferredConstituent& inferred : carrier.carried) {
      add(inferred.constituent->speed_rad_s,
          inference_factor(*carrier.constituent, inferred, record.reference));
    }
    a.col(column + 1) = a.col(column).conjugate();
    column += 2;
  }
  return a;
}

/// The carriers still in the fit, with their columns and the products of these: made once, and cut
/// when a carrier goes.
struct NormalForm {
  std::vector<TidalCarrier> carriers;
  MatrixXcd a;
  MatrixXcd gram;   ///< a^H a
  VectorXcd right;  ///< a^H y

  NormalForm(std::vector<TidalCarrier> given, const Record& record)
      : carriers(std::move(given)),
        a(design(record, carriers)),
        gram(a.adjoint() * a),
        right(a.adjoint() * record.value) {}

  void drop(std::size_t k) {
    carriers.erase(carriers.begin() + static_cast<std::ptrdiff_t>(k));
    const auto column = static_cast<Index>(1 + 2 * k);
    const Index after = a.cols() - column - 2;
    const Index left = a.cols() - 2;
    a.middleCols(column, after) = a.rightCols(after).eval();
    a.conservativeResize(Eigen::NoChange, left);
    gram.middleCols(column, after) = gram.rightCols(after).eval();
    gram.middleRows(column, after) = gram.bottomRows(after).eval();
    gram.conservativeResize(left, left);
    right.segment(column, after) = right.tail(after).eval();
    right.conservativeResize(left);
  }
};

std::string rounded(double x, int digits) {
  std::string text = std::to_string(x);
  const auto dot = text.find('.');
  return digits == 0 ? text.substr(0, dot)
                     : text.substr(0, dot + 1 + static_cast<std::size_t>(digits));
}

/// Takes away what the sampling cannot show.
void drop_unseen(std::vector<TidalCarrier>& carriers, const Record& record,
                 std::vector<std::string>& notes) {
  std::erase_if(carriers, [&](const TidalCarrier& carrier) {
    const double period_s = turn / carrier.constituent->speed_rad_s;
    const bool unseen = period_s <= 2.0 * record.usual_step_s;
    const bool averaged = std::abs(passed_by_mean(carrier.constituent->speed_rad_s,
                                                  record.usual_width_s)) < least_passed_by_mean;
    if (unseen || averaged) {
      notes.push_back(
          std::string(carrier.constituent->name) + " left out: a period of " +
          rounded(period_s / 3600.0, 2) + " h is not seen by values every " +
          rounded(record.usual_step_s / 3600.0, 2) + " h" +
          (averaged ? " averaged over " + rounded(record.usual_width_s / 3600.0, 2) + " h" : ""));
    }
    return unseen || averaged;
  });
}

/// Drops, one after the other, the constituent most involved in the worst-determined direction.
void drop_ill_conditioned(NormalForm& normal, std::vector<std::string>& notes) {
  while (!normal.carriers.empty()) {
    const Eigen::VectorXd inverse =
        normal.gram.diagonal().real().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<MatrixXcd> eigen(inverse.asDiagonal() * normal.gram *
                                                         inverse.asDiagonal());
    const Index columns = normal.a.cols();
    const double largest = eigen.eigenvalues()(columns - 1);
    const double smallest = std::max(eigen.eigenvalues()(0), 0.0);
    if (normal.a.rows() > columns && largest <= smallest * largest_condition * largest_condition)
      return;
    const VectorXcd direction = eigen.eigenvectors().col(0);
    std::size_t worst = 0;
    double most = -1.0;
    for (std::size_t k = 0; k < normal.carriers.size(); ++k) {
      const auto column = static_cast<Index>(1 + 2 * k);
      const double share = std::norm(direction(column)) + std::norm(direction(column + 1));
      // Of two equally involved ones the later, smaller constituent goes.
      if (share >= most * (1.0 - 1e-6)) most = share, worst = k;
    }
    notes.push_back(std::string(normal.carriers[worst].constituent->name) +
                    " dropped: not determined by this record (condition number above 1000)");
    normal.drop(worst);
  }
}

struct Solution {
  VectorXcd x;
  VectorXcd residual;
};

/// Through the normal equations: the condition number is at most a thousand here, so that ten
/// digits are left, enough to see which constituents stand out of the noise.
Solution quick_solution(const NormalForm& normal, const VectorXcd& y) {
  Solution solution;
  solution.x = normal.gram.ldlt().solve(normal.right);
  solution.residual = y - normal.a * solution.x;
  return solution;
}

Solution solve(const MatrixXcd& a, const VectorXcd& y) {
  Solution solution;
  const Eigen::CompleteOrthogonalDecomposition<MatrixXcd> decomposition(a);
  solution.x = decomposition.solve(y);
  solution.residual = y - a * solution.x;
  return solution;
}

/// Power of each pair of phasors over the variance of its estimate.
std::vector<double> signal_to_noise(const NormalForm& normal, const Solution& solution) {
  const MatrixXcd& a = normal.a;
  const Index n = a.rows();
  const VectorXcd& e = solution.residual;
  const double power = e.squaredNorm();
  double variance = power / std::max<double>(1.0, static_cast<double>(n - a.cols()));
  if (n > 2 && power > 0) {
    const double lag_one = std::clamp((e.head(n - 1).dot(e.tail(n - 1))).real() / power, 0.0, 0.98);
    variance *= (1.0 + lag_one) / (1.0 - lag_one);
  }
  variance = std::max(variance, least_noise_m_s * least_noise_m_s);
  const MatrixXcd inverse = normal.gram.ldlt().solve(MatrixXcd::Identity(a.cols(), a.cols()));
  std::vector<double> ratio;
  for (Index column = 1; column + 1 < a.cols(); column += 2) {
    const double noise =
        variance * (inverse(column, column).real() + inverse(column + 1, column + 1).real());
    ratio.push_back((std::norm(solution.x(column)) + std::norm(solution.x(column + 1))) / noise);
  }
  return ratio;
}

TideFit assemble(const Record& record, std::span<const TidalCarrier> carriers,
                 const Solution& solution, std::span<const double> ratio) {
  TideFit fit;
  fit.reference = record.reference;
  fit.mean = solution.x(0);
  const double n = std::max<double>(1.0, static_cast<double>(record.time.size()));
  fit.residual_rms_m_s = std::sqrt(solution.residual.squaredNorm() / n);
  for (std::size_t k = 0; k < carriers.size(); ++k) {
    const TidalCarrier& carrier = carriers[k];
    TideTerm term;
    term.name = carrier.constituent->name;
    term.speed_rad_s = carrier.constituent->speed_rad_s;
    term.counter_clockwise = solution.x(static_cast<Index>(1 + 2 * k));
    term.clockwise = solution.x(static_cast<Index>(2 + 2 * k));
    term.signal_to_noise = ratio.empty() ? 0.0 : ratio[k];
    fit.terms.push_back(term);
    for (const InferredConstituent& inferred : carrier.carried) {
      const Horizontal factor = inference_factor(*carrier.constituent, inferred, record.reference);
      TideTerm rider = term;
      rider.name = inferred.constituent->name;
      rider.speed_rad_s = inferred.constituent->speed_rad_s;
      rider.counter_clockwise *= factor;
      rider.clockwise *= std::conj(factor);
      rider.inferred_from = term.name;
      fit.terms.push_back(rider);
    }
  }
  return fit;
}

void leave_out_near_inertial(TideFit& fit, double record_s, Angle latitude) {
  const double coriolis_rad_s =
      2.0 * constants::earth_rotation_rad_s * std::sin(latitude.radians());
  for (TideTerm& term : fit.terms) {
    term.near_inertial = std::abs(term.speed_rad_s - std::abs(coriolis_rad_s)) * record_s < turn;
    if (!term.near_inertial) continue;
    Horizontal& shared = coriolis_rad_s > 0 ? term.clockwise : term.counter_clockwise;
    term.left_out_m_s = std::abs(shared);
    shared = {};
    fit.notes.push_back(term.name + " cannot be told from inertial motion of " +
                        rounded(turn / std::abs(coriolis_rad_s) / 3600.0, 2) +
                        " h in a record of " + rounded(record_s / day_s, 1) + " days: its " +
                        (coriolis_rad_s > 0 ? "clockwise" : "counter-clockwise") +
                        " part is left out");
  }
}

}  // namespace

TideFit fit_tide(std::span<const TimeCell> time, std::span<const Horizontal> value,
                 std::span<const SampleStatus> status, Angle latitude) {
  const Record record = select(time, value, status);
  std::vector<std::string> notes;
  std::vector<TidalCarrier> carriers;
  const double record_s = length_s(record);
  if (record.time.empty()) {
    TideFit nothing;
    nothing.notes.emplace_back("no tide: the record holds no value");
    return nothing;
  }
  if (record_s < 3.0 * day_s * (1.0 - 1e-9)) {
    notes.push_back("no tide: the record of " + rounded(record_s / day_s, 1) +
                    " days is shorter than 3");
  } else {
    carriers = tidal_carriers_for(Duration(std::llround(1000.0 * record_s)));
    drop_unseen(carriers, record, notes);
  }
  NormalForm normal(std::move(carriers), record);
  drop_ill_conditioned(normal, notes);
  std::vector<double> ratio = signal_to_noise(normal, quick_solution(normal, record.value));
  while (!ratio.empty()) {
    const auto weakest = std::min_element(ratio.begin(), ratio.end());
    if (*weakest >= least_signal_to_noise) break;
    const auto index = static_cast<std::size_t>(weakest - ratio.begin());
    notes.push_back(std::string(normal.carriers[index].constituent->name) +
                    " dropped: signal-to-noise ratio " + rounded(*weakest, 2) + " is below 2");
    normal.drop(index);
    ratio = signal_to_noise(normal, quick_solution(normal, record.value));
  }
  TideFit fit = assemble(record, normal.carriers, solve(normal.a, record.value), ratio);
  fit.notes = std::move(notes);
  for (const TideTerm& term : fit.terms) {
    if (!term.inferred_from.empty())
      fit.notes.push_back(term.name + " inferred from " + term.inferred_from +
                          " by the equilibrium ratio");
  }
  leave_out_near_inertial(fit, record_s, latitude);
  return fit;
}

TideFit fit_prescribed_tide(std::span<const TimeCell> time, std::span<const Horizontal> value,
                            std::span<const SampleStatus> status,
                            std::span<const std::string_view> names) {
  const Record record = select(time, value, status);
  expects(!record.time.empty(), "a prescribed tide needs at least one value");
  std::vector<TidalCarrier> carriers;
  for (const std::string_view name : names) carriers.push_back({&tidal_constituent(name), {}});
  return assemble(record, carriers, solve(design(record, carriers), record.value), {});
}

Duration record_length(std::span<const TimeCell> time, std::span<const SampleStatus> status) {
  const std::vector<Horizontal> nothing(time.size());
  return Duration(std::llround(1000.0 * length_s(select(time, nothing, status))));
}

Horizontal tidal_oscillation(const TideFit& fit, const TimeCell& cell) noexcept {
  Horizontal sum{};
  for (const TideTerm& term : fit.terms) {
    const Horizontal phase = turning(term.speed_rad_s, fit.reference, cell);
    sum += term.counter_clockwise * phase + term.clockwise * std::conj(phase);
  }
  return sum;
}

Horizontal tide_over(const TideFit& fit, const TimeCell& cell) noexcept {
  return fit.mean + tidal_oscillation(fit, cell);
}

}  // namespace slackwater
