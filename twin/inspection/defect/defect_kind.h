#pragma once
#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "twin/inspection/defect/defect.h"
#include "twin/inspection/surface/surface.h"

namespace slackwater::twin {

inline constexpr std::size_t defect_kinds = 9;
[[nodiscard]] const std::array<DefectKind, defect_kinds>& all_defect_kinds() noexcept;
[[nodiscard]] std::optional<DefectKind> defect_kind_named(std::string_view word) noexcept;

/// The surfaces that a defect of this kind can sit on: a crack in steel, erosion on a blade, ...
[[nodiscard]] std::span<const SurfaceKind> surfaces_of(DefectKind kind) noexcept;
[[nodiscard]] bool may_sit_on(DefectKind kind, SurfaceKind surface) noexcept;

/// What its severity is told in.
enum class SeverityUnit {
  metres,  ///< of depth, thickness or loss of burial
  share,   ///< 0 to 1: of the anode, of the chain's diameter; a fastener is missing or not
};
[[nodiscard]] SeverityUnit severity_unit_of(DefectKind kind) noexcept;

}  // namespace slackwater::twin
