#include "twin/inspection/defect/defect_kind.h"

#include <algorithm>

namespace slackwater::twin {
namespace {

constexpr SurfaceKind steel[]{SurfaceKind::monopile, SurfaceKind::transition_piece,
                              SurfaceKind::tower};
constexpr SurfaceKind wet_steel[]{SurfaceKind::monopile, SurfaceKind::transition_piece};
constexpr SurfaceKind flange[]{SurfaceKind::transition_piece};
constexpr SurfaceKind blade[]{SurfaceKind::blade};
constexpr SurfaceKind anodes[]{SurfaceKind::anodes};
constexpr SurfaceKind bed[]{SurfaceKind::bed};
constexpr SurfaceKind cable[]{SurfaceKind::cable};
constexpr SurfaceKind mooring_line[]{SurfaceKind::mooring_line};

}  // namespace

const char* name_of(DefectKind kind) noexcept {
  switch (kind) {
    case DefectKind::crack:
      return "crack";
    case DefectKind::corrosion:
      return "corrosion";
    case DefectKind::marine_growth:
      return "marine_growth";
    case DefectKind::missing_fastener:
      return "missing_fastener";
    case DefectKind::leading_edge_erosion:
      return "leading_edge_erosion";
    case DefectKind::anode_loss:
      return "anode_loss";
    case DefectKind::scour:
      return "scour";
    case DefectKind::burial_loss:
      return "burial_loss";
    case DefectKind::chain_wear:
      return "chain_wear";
  }
  return "";
}

const std::array<DefectKind, defect_kinds>& all_defect_kinds() noexcept {
  static constexpr std::array<DefectKind, defect_kinds> kinds{DefectKind::crack,
                                                              DefectKind::corrosion,
                                                              DefectKind::marine_growth,
                                                              DefectKind::missing_fastener,
                                                              DefectKind::leading_edge_erosion,
                                                              DefectKind::anode_loss,
                                                              DefectKind::scour,
                                                              DefectKind::burial_loss,
                                                              DefectKind::chain_wear};
  return kinds;
}

std::optional<DefectKind> defect_kind_named(std::string_view word) noexcept {
  for (const DefectKind kind : all_defect_kinds())
    if (word == name_of(kind)) return kind;
  return std::nullopt;
}

std::span<const SurfaceKind> surfaces_of(DefectKind kind) noexcept {
  switch (kind) {
    case DefectKind::crack:
    case DefectKind::corrosion:
      return steel;
    case DefectKind::marine_growth:
      return wet_steel;
    case DefectKind::missing_fastener:
      return flange;
    case DefectKind::leading_edge_erosion:
      return blade;
    case DefectKind::anode_loss:
      return anodes;
    case DefectKind::scour:
      return bed;
    case DefectKind::burial_loss:
      return cable;
    case DefectKind::chain_wear:
      return mooring_line;
  }
  return {};
}

bool may_sit_on(DefectKind kind, SurfaceKind surface) noexcept {
  const auto surfaces = surfaces_of(kind);
  return std::find(surfaces.begin(), surfaces.end(), surface) != surfaces.end();
}

SeverityUnit severity_unit_of(DefectKind kind) noexcept {
  switch (kind) {
    case DefectKind::missing_fastener:
    case DefectKind::anode_loss:
    case DefectKind::chain_wear:
      return SeverityUnit::share;
    default:
      return SeverityUnit::metres;
  }
}

}  // namespace slackwater::twin
