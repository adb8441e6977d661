#include "twin/inspection/instrument/instrument.h"
#include "twin/inspection/surface/surface.h"

namespace slackwater::twin {

const char* name_of(SurfaceKind kind) noexcept {
  static constexpr const char* names[]{"monopile", "transition_piece", "tower", "nacelle", "blade",
                                       "anodes",   "mooring_line",     "cable", "bed",     "water"};
  return names[static_cast<int>(kind)];
}

const char* name_of(InstrumentKind kind) noexcept {
  static constexpr const char* names[]{
      "rgb",       "infrared",  "lidar",        "multibeam",          "side_scan",
      "thickness", "potential", "magnetometer", "acoustic_detection", "optical_detection",
      "radar",     "ais"};
  return names[static_cast<int>(kind)];
}

}  // namespace slackwater::twin
