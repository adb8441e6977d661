#include "twin/render/sheet/camera_instrument.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

Instrument instrument_of(const RenderSensor& sensor, double lamps) {
  const auto& camera = std::get<CameraSheet>(sensor.device);
  Instrument instrument;
  instrument.name = sensor.name;
  instrument.kind = InstrumentKind::rgb;
  instrument.footprint = camera.frame;
  instrument.least_range_m = sensor.least_range_m;
  instrument.most_range_m = sensor.most_range_m;
  instrument.needs_light = true;
  double square = 0, aside = 0;
  for (const MountedLamp& lamp : camera.lamps) {
    square += lamps * lamps * lamp.range_m * lamp.range_m;
    aside += length_of(lamp.position_m - sensor.position_m);
  }
  instrument.lamp_range_m = std::sqrt(square);
  if (!camera.lamps.empty())
    instrument.lamp_aside_m = std::max(0.01, aside / static_cast<double>(camera.lamps.size()));
  return instrument;
}

}  // namespace slackwater::twin
