// made_up_sun FILE.json: where our sun stands at random places and times, and when days are light.
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "fields/base/numbers/random.h"
#include "twin/risk/workability/daylight.h"
#include "twin/risk/workability/sun_position.h"

int main(int argc, char** argv) {
  using namespace slackwater;
  if (argc != 2) {
    std::fprintf(stderr, "made_up_sun FILE.json\n");
    return 2;
  }
  Rng random(25, "strangers/sun");
  nlohmann::json made = {{"positions", nlohmann::json::array()}, {"days", nlohmann::json::array()}};
  const UtcTime first = parse_utc("1990-01-01T00:00:00Z");
  const double span_ms = 60 * 365.25 * 86'400'000.0;
  for (int i = 0; i < 4000; ++i) {
    const GeoPoint place =
        GeoPoint::from_degrees(random.uniform(-89.9, 89.9), random.uniform(-180, 180));
    const UtcTime time = first + Duration(static_cast<Duration::rep>(random.uniform(0, span_ms)));
    const twin::SunPosition sun = twin::sun_position(place, time);
    made["positions"].push_back({place.latitude_deg(), place.longitude_deg(), format_utc(time),
                                 sun.elevation_deg, sun.azimuth_deg});
  }
  for (int i = 0; i < 600; ++i) {
    const GeoPoint place =
        GeoPoint::from_degrees(random.uniform(-85, 85), random.uniform(-180, 180));
    const UtcDay day =
        day_of(first) + std::chrono::days(static_cast<int>(random.uniform(0, 21900)));
    const auto light = static_cast<twin::Light>(i % 3);
    const twin::DayOfLight found = twin::light_of(place, day, light, std::nullopt);
    const auto text = [](const std::optional<UtcTime>& time) {
      return time ? nlohmann::json(format_utc(*time)) : nlohmann::json(nullptr);
    };
    made["days"].push_back({{"latitude_deg", place.latitude_deg()},
                            {"longitude_deg", place.longitude_deg()},
                            {"least_elevation_deg", twin::least_elevation_deg(light)},
                            {"kind", static_cast<int>(found.kind)},
                            {"noon", format_utc(found.noon)},
                            {"begin", text(found.begin)},
                            {"end", text(found.end)}});
  }
  std::ofstream(argv[1]) << made.dump();
  return 0;
}
