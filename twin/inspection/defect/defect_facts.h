#pragma once
#include <array>
#include <limits>
#include <string>

#include "fields/base/config.h"
#include "twin/inspection/defect/defect_kind.h"

namespace slackwater::twin {

/// The lasting potential of steel with anodes by how much of them is gone: a broken line.
///
///     E(x) = fresh + (limit - fresh) x/u      x <= u, the utilisation factor
///            limit + (bare - limit) (x - u)/(1 - u)   beyond
///
/// That the line is straight is ours; its ends are a designer's: an anode is done at u, and steel
/// above the limit is no longer protected. mV against Ag/AgCl in sea water.
struct PotentialRule {
  double fresh_mv = -1050;  ///< closed circuit, Al-Zn-In in sea water
  double limit_mv = -800;   ///< of protection
  double bare_mv = -650;    ///< of steel that corrodes freely
  double utilisation = 0.8;
};
[[nodiscard]] double potential_mv(const PotentialRule& rule, double depletion) noexcept;
/// The depletion of such a potential, 0 to 1: the inverse.
[[nodiscard]] double depletion_of(const PotentialRule& rule, double potential_mv) noexcept;

/// What defects are like, and what they are measured against, where a plan says nothing.
struct DefectFacts {
  struct OfKind {
    Range size_m;    ///< of the longest side on the surface
    Range severity;  ///< in the unit of the kind
    double up_to_height_m = std::numeric_limits<double>::infinity();  ///< above mean sea level
    double from_top_m = std::numeric_limits<double>::infinity();      ///< down the sheet
    std::string source;
    std::string status;
  };
  std::array<OfKind, defect_kinds> kinds;  ///< in the order of all_defect_kinds
  double wall_m = 0;                       ///< of steel, when it was new
  double burial_m = 0;                     ///< of a cable, when it was laid
  double chain_diameter_m = 0;             ///< of the bar, when it was new
  PotentialRule potential;

  [[nodiscard]] const OfKind& of(DefectKind kind) const noexcept {
    return kinds[static_cast<std::size_t>(kind)];
  }
};

/// One file of data/defects:
///
///     kinds:
///       - {kind: crack, size_m: [0.02, 0.2], severity_m: [0.001, 0.01], source: ..., status: ...}
///       - {kind: anode_loss, size_m: [...], severity_share: [...], ...}
///     when_new: {wall_m: 0.06, burial_m: 1.5, chain_diameter_m: 0.13, source: ..., status: ...}
///     potential: {fresh_mv: -1050, limit_mv: -800, bare_mv: -650, utilisation: 0.8, ...}
///
/// Each kind once. `up_to_height_m` and `from_top_m` say where on its surfaces a kind is.
/// @throws Error(invalid_input)
[[nodiscard]] DefectFacts read_defect_facts(const Config& config);

/// `key` as two numbers, the lesser first and above 0; one number stands for both.
/// @throws Error(invalid_input)
[[nodiscard]] Range read_span(const Config& config, const char* key, double most);
/// `severity_m` or `severity_share`, as the kind has it.
[[nodiscard]] const char* severity_key_of(DefectKind kind) noexcept;
[[nodiscard]] double most_severity_of(DefectKind kind) noexcept;  ///< that makes sense
inline constexpr double most_defect_size_m = 1000;

/// `kind` of an entry. @throws Error(invalid_input), which lists them
[[nodiscard]] DefectKind read_defect_kind(const Config& config);

}  // namespace slackwater::twin
