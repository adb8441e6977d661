#pragma once
#include <cstdint>
#include <string>

namespace slackwater::twin {

enum class DefectKind {
  crack,
  corrosion,
  marine_growth,
  missing_fastener,
  leading_edge_erosion,
  anode_loss,
  scour,
  burial_loss,
  chain_wear,
};
/// crack, corrosion, ...
[[nodiscard]] const char* name_of(DefectKind kind) noexcept;

/// What is there, whether anybody sees it or not.
struct Defect {
  std::uint32_t number = 0;  ///< of the run, from 0
  DefectKind kind{};
  std::size_t surface = 0;  ///< of the plan
  std::size_t patch = 0;    ///< of the surface: where its middle is
  double size_m = 0;        ///< its longest side on the surface
  /// How far it has gone, in the unit of its kind: m of depth, thickness or loss of burial; a share
  /// of the anode or of the chain's diameter.
  double severity = 0;
};

}  // namespace slackwater::twin
