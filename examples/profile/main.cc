// profile FORECAST.nc LONGITUDE LATITUDE TIME: the current over depth at a place, with its p10 and
// p90.
#include <cstdio>
#include <cstdlib>

#include "fields/service/field.h"
#include "ingest/cf/forecast/forecast_file.h"

int main(int argc, char** argv) try {
  using namespace slackwater;
  if (argc != 5)
    return std::fputs("usage: profile FORECAST.nc LONGITUDE LATITUDE TIME\n", stderr), 2;
  const Field field(
      std::make_shared<const Snapshot>(ingest::read_forecast(argv[1], ingest::Members::none)));
  for (const double depth_m : field.snapshot().depth_m) {
    const Place place{std::atof(argv[2]), std::atof(argv[3]), depth_m, parse_utc(argv[4])};
    const CurrentSample at = field.current(place);
    if (has_value(at.status)) {
      const CurrentQuantiles q = quantiles_of(at);
      std::printf("%5.1f m  east %+.3f (%+.3f to %+.3f)  north %+.3f (%+.3f to %+.3f) m/s\n",
                  depth_m, at.velocity_m_s.real(), q.p10_m_s.real(), q.p90_m_s.real(),
                  at.velocity_m_s.imag(), q.p10_m_s.imag(), q.p90_m_s.imag());
    } else {
      std::printf("%5.1f m  %s; valid: %s\n", depth_m, name_of(at.status).data(),
                  field.range().text().c_str());
    }
  }
} catch (const std::exception& problem) {
  return std::fprintf(stderr, "%s\n", problem.what()), 1;
}
