#include "api/pipeline/fetch/gfs_run.h"

#include <algorithm>

#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using std::chrono::hours;

/// Steps are there as far as a run goes: f000 to f120 hourly, then 3-hourly to f384 (NCEP
/// product inventory, https://www.nco.ncep.noaa.gov/pmb/products/gfs/).
constexpr hours gfs_last_step{384};

/// The newest run that was published by then.
UtcTime gfs_run_by(UtcTime issued) {
  const UtcTime begun = issued - gfs_published_after;
  const UtcTime midnight = UtcTime(day_of(begun));
  return midnight + (begun - midnight) / gfs_run_every * gfs_run_every;
}

}  // namespace

/// The form of the address: scripting_grib_filter.html of
/// https://www.cpc.ncep.noaa.gov/products/wesley/ and the pages of https://nomads.ncep.noaa.gov.
/// The cut holds two cells of 0.25 degree on each side of the site.
std::string gfs_address(const Site& site, UtcTime run, const std::string& step) {
  const BoundingBox box = site.box(0.5);
  const double east_deg = box.east_deg < box.west_deg ? box.east_deg + 360 : box.east_deg;
  const UtcDay day = day_of(run);
  std::string date = format_day(day);
  date.erase(std::remove(date.begin(), date.end(), '-'), date.end());
  const auto hour = std::chrono::floor<hours>(run - UtcTime(day)).count();
  return formatted(
      "https://nomads.ncep.noaa.gov/cgi-bin/filter_gfs_0p25.pl?dir=%2Fgfs.{}%2F{:02}%2Fatmos"
      "&file=gfs.t{:02}z.pgrb2.0p25.f{}&var_UGRD=on&var_VGRD=on&lev_10_m_above_ground=on"
      "&subregion=&leftlon={:.2f}&rightlon={:.2f}&toplat={:.2f}&bottomlat={:.2f}",
      date, hour, hour, step, box.west_deg, east_deg, std::min(box.north_deg, 90.0),
      std::max(box.south_deg, -90.0));
}

GfsRun gfs_run(const Site& site, UtcTime issued, UtcTime until) {
  GfsRun run{gfs_run_by(issued), hours(0), {}};
  if (until <= run.begun) return run;
  const hours wanted = std::chrono::ceil<hours>(until - run.begun);
  run.last_step = std::min(gfs_last_step, (wanted + gfs_step - hours(1)) / gfs_step * gfs_step);
  for (hours step{0}; step <= run.last_step; step += gfs_step)
    run.addresses.push_back(gfs_address(site, run.begun, formatted("{:03}", step.count())));
  return run;
}

}  // namespace slackwater::api
