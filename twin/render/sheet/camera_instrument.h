#pragma once
#include "twin/render/sheet/render_sensor.h"

namespace slackwater::twin {

/// The instrument that an inspection would have of a camera (instrument.h): its frame and ranges,
/// and one lamp of the light of all of its lamps, as far aside as they are at the mean.
/// @param sensor  a camera
/// @param lamps   their range, of the sheet's
[[nodiscard]] Instrument instrument_of(const RenderSensor& sensor, double lamps = 1);

}  // namespace slackwater::twin
