#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "calibration/propagate/wind_error.h"

namespace slackwater::calibration {

/// What the members of a weather ensemble say: how far each departs from the wind that is used.
struct WindDepartures {
  std::vector<int> number;                ///< the provider's, of each member
  std::vector<Horizontal> departure_m_s;  ///< members x times; NaN where a member says nothing
  [[nodiscard]] bool empty() const noexcept { return number.empty(); }
};

/// Which member of an ensemble drives each member of the forecast: indices into the ensemble. As
/// many as there are: each once; more: chosen without repetition by the seed, in ascending order;
/// fewer: every one equally often, the odd ones out chosen by the seed. The same at all columns of
/// a site, whose weather is one.
///
/// Sets of members follow one another as hands of cards: each set goes on where the one before it
/// ended, in rounds of the whole ensemble shuffled anew, so that nobody drives again before all
/// have driven; within a round a set's share is in ascending order.
[[nodiscard]] std::vector<std::size_t> choose_drivers(std::size_t ensemble, std::size_t members,
                                                      std::uint64_t seed, std::size_t set = 0);

/// The mean square departure of a component from the wind that is used, m2/s2, per time, over the
/// members that say something; NaN where none does. About the wind used, not about the ensemble's
/// mean: where the two stand apart, that wind is in doubt by as much.
[[nodiscard]] std::vector<double> ensemble_variance(const WindDepartures& ensemble,
                                                    std::size_t times);

/// An ensemble is no surer of the wind than an analysis is, 1 m/s (`analysed_wind_error`): in the
/// first days ensembles spread less than they err (Buizza et al. 2005, Mon. Wea. Rev. 133, 1076).
[[nodiscard]] double least_ensemble_sigma_m_s() noexcept;

/// A member that drives a second time has a departure of its own of this share of the ensemble's
/// spread: another future, and still that member's weather (correlation 0.96).
inline constexpr double repeated_share = 0.3;

/// The winds of a weather ensemble as departures of the forecast's members from the central wind,
/// at the samples of that wind after D:
///
///   d_m = e_n + r_m (+ repeated_share of S, drawn, where n has driven before),   n drives m
///
///   within the run of n   e_n as given,   var r_m = max(0, 1 m2/s2 - S^2)
///   after its end at t_e  e_n(t_e) a,     var r_m = a^2 var r_m(t_e) + (1 - a^2) sigma^2(lead)
///   before its beginning  0,              var r_m = sigma^2(lead)
///
/// S^2: the ensemble's variance (`ensemble_variance`); a = exp(-(t - t_e)/memory); sigma(lead) and
/// memory: the law of the wind's error without an ensemble. Spread is thus never below an analysis'
/// error; beyond the run it grows into the law at the pace at which winds forget. r is Gauss-Markov
/// and of opposite sign in members 1 and 2, 3 and 4, ...
///
/// Departures are not centred: member m carries the wind of n itself, and where the ensemble's mean
/// stands off the central wind so does the mean of the members.
class EnsembleWind {
 public:
  /// @param times    of the departures given, ascending
  /// @param samples  of the central wind, ascending, after the end of D
  /// @param members  of one set of the forecast's
  /// @param set      which of the sets: members are counted within it
  EnsembleWind(const WindDepartures& ensemble, std::span<const UtcTime> times, UtcTime end_of_day,
               std::span<const UtcTime> samples, const WindErrorGrowth& law, std::size_t members,
               std::uint64_t seed, std::size_t set = 0);

  /// The number of the member that drives each member of the forecast.
  [[nodiscard]] std::vector<int> numbers() const;
  /// Of member m = 0, 1, ... of the forecast at the samples, m/s.
  /// @param random  of the pair of members; members 2p and 2p + 1 are given the same state
  [[nodiscard]] std::vector<Horizontal> departure(std::size_t m, Rng& random) const;

 private:
  /// What an ensemble's member says at the samples, and what it leaves open.
  struct Driver {
    std::vector<Horizontal> departure_m_s;
    std::vector<double> spread_m_s;     ///< S, fading after the end
    std::vector<double> remainder_m_s;  ///< standard deviation of r
  };
  [[nodiscard]] Driver driver_of(std::span<const Horizontal> departure_m_s,
                                 std::span<const double> variance, std::span<const UtcTime> times,
                                 UtcTime end_of_day) const;

  std::vector<UtcTime> samples_;
  WindErrorGrowth law_;
  std::uint64_t seed_;
  std::size_t first_;  ///< of the set's members, counted over all sets
  std::vector<int> number_;
  std::vector<std::size_t> driver_of_member_;
  std::vector<bool> is_repeated_;  ///< per member of the forecast: its driver has driven before
  std::vector<Driver> drivers_;
};

}  // namespace slackwater::calibration
