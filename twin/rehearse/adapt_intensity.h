#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "twin/mission/intensity.h"
#include "twin/rehearse/reserve_fate.h"

namespace slackwater::twin {

/// A mission laid out with the work of all its agents thinned; by nothing: the fixed plan.
using MissionThinned = std::function<Scenario(const Intensity& thinned_by)>;

/// How closely can a mission look and still bring its vehicles home with their reserve?
struct IntensityQuestion {
  UtcTime start;
  std::vector<std::size_t> members;  ///< the futures that it is flown in
  /// From dense to sparse, the first 1: the fixed plan.
  std::vector<double> densities{1, 0.8, 0.65, 0.5, 0.35, 0.2};
  /// Of the passes wherever some are left out: who has to come home early leaves no hole.
  PassOrder order = PassOrder::coarse_to_fine;
  double keep_share = 0.9;  ///< probability with which the reserve shall be kept
  int threads = 1;
  FlightSettings flights;
};

/// A density, flown in all members.
struct TriedIntensity {
  Intensity thinned_by;
  /// Member by member, in the order of the question.
  std::vector<ReserveFate> fates;
  std::vector<double> charge_left;  ///< at the end, the least of the vehicles whose work counts
  std::vector<double> duration_s;
  std::vector<double> coverage;  ///< see `coverage_of`

  [[nodiscard]] std::size_t count(ReserveFate fate) const;
  [[nodiscard]] std::size_t kept() const { return count(ReserveFate::kept); }
};

struct IntensityChoice {
  std::vector<TriedIntensity> tried;  ///< from dense to sparse; not all of the ladder
  std::optional<std::size_t> chosen;  ///< of `tried`; nothing: do not fly
  std::size_t members = 0;
  std::size_t needed = 0;  ///< of them have to keep the reserve (`rank_needed`)
  /// "density 0.65: the reserve is kept in 19 of 19 futures, 18 needed; with density 0.8 in 15 of
  /// 19 futures (4 called home by it)".
  std::string reason;

  [[nodiscard]] bool is_fixed_plan() const {
    return chosen && tried[*chosen].thinned_by.density == 1;
  }
};

/// What a flight has looked at, the mean of the vehicles whose work counts: of one that inspects,
/// the share of its surfaces that it covered; of others what they have done of their work
/// (`VehicleAccount::work_share`) times the length of that against the fixed plan's.
[[nodiscard]] double coverage_of(const Flight& flight, const Scenario& flown,
                                 const Scenario& fixed_plan, const FlightSettings& settings);

/// The densest plan of the ladder with which as many members as `rank_needed` asks for keep their
/// reserve, by bisection: the first is flown, then the last, then those between. What is chosen has
/// been flown and holds; that those between are easier the sparser they are is taken for granted.
/// Rungs whose way is that of the one before are left out.
///
/// The same whatever the number of threads: a member's sea, gusts and pilot are its own.
/// @throws Error(invalid_input) for a ladder that does not fall from 1, too few members for
///         `keep_share`, and as `set_up`
[[nodiscard]] IntensityChoice adapt_intensity(const MissionThinned& mission,
                                              const Surround& surround,
                                              const IntensityQuestion& question);

}  // namespace slackwater::twin
