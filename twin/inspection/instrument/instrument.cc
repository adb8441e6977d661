#include "twin/inspection/instrument/instrument.h"

#include <algorithm>

namespace slackwater::twin {

const char* name_of(InstrumentKind kind) noexcept {
  switch (kind) {
    case InstrumentKind::rgb:
      return "rgb";
    case InstrumentKind::infrared:
      return "infrared";
    case InstrumentKind::lidar:
      return "lidar";
    case InstrumentKind::multibeam:
      return "multibeam";
    case InstrumentKind::side_scan:
      return "side_scan";
    case InstrumentKind::thickness:
      return "thickness";
    case InstrumentKind::potential:
      return "potential";
    case InstrumentKind::magnetometer:
      return "magnetometer";
    case InstrumentKind::acoustic_detection:
      return "acoustic_detection";
    case InstrumentKind::optical_detection:
      return "optical_detection";
    case InstrumentKind::radar:
      return "radar";
    case InstrumentKind::ais:
      return "ais";
  }
  return "unknown";
}

bool works_by_light(InstrumentKind kind) noexcept {
  return kind == InstrumentKind::rgb || kind == InstrumentKind::infrared ||
         kind == InstrumentKind::lidar || kind == InstrumentKind::optical_detection;
}

}  // namespace slackwater::twin
