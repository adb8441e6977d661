#include "api/pipeline/ingest/gfs_download.h"

#include <algorithm>

#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using std::chrono::hours;

/// Runs begin at 00, 06, 12 and 18 UTC. Their first files lie on NOMADS 3 h 46 min to 3 h 51 min
/// later (f000 of 2024-07-21 at 03:46: development notes of the RRFS workflow); the rest of five
/// hours is for the later steps.
constexpr hours gfs_run_every{6};
constexpr hours gfs_published_after{5};
/// 3-hourly steps are there as far as a run goes: f000 to f120 hourly, then 3-hourly to f384 (NCEP
/// product inventory, https://www.nco.ncep.noaa.gov/pmb/products/gfs/).
constexpr hours gfs_step{3};
constexpr hours gfs_last_step{384};

/// The newest run that was published by then.
UtcTime gfs_run_by(UtcTime issued) {
  const UtcTime begun = issued - gfs_published_after;
  const UtcTime midnight = UtcTime(day_of(begun));
  return midnight + (begun - midnight) / gfs_run_every * gfs_run_every;
}

/// The form of the address: scripting_grib_filter.html of
/// https://www.cpc.ncep.noaa.gov/products/wesley/ and the pages of https://nomads.ncep.noaa.gov.
/// The cut holds two cells of 0.25 degree on each side of the site.
std::string filter_address(const Site& site, UtcTime run) {
  const BoundingBox box = site.box(0.5);
  const double east_deg = box.east_deg < box.west_deg ? box.east_deg + 360 : box.east_deg;
  const UtcDay day = day_of(run);
  std::string date = format_day(day);
  date.erase(std::remove(date.begin(), date.end(), '-'), date.end());
  const auto hour = std::chrono::floor<hours>(run - UtcTime(day)).count();
  return formatted(
      "https://nomads.ncep.noaa.gov/cgi-bin/filter_gfs_0p25.pl?dir=%2Fgfs.{}%2F{:02}%2Fatmos"
      "&file=gfs.t{:02}z.pgrb2.0p25.f$h&var_UGRD=on&var_VGRD=on&lev_10_m_above_ground=on"
      "&subregion=&leftlon={:.2f}&rightlon={:.2f}&toplat={:.2f}&bottomlat={:.2f}",
      date, hour, hour, box.west_deg, east_deg, std::min(box.north_deg, 90.0),
      std::max(box.south_deg, -90.0));
}

}  // namespace

std::vector<std::string> gfs_wind_lines(const Site& site, UtcTime issued, UtcTime until) {
  const UtcTime run = gfs_run_by(issued);
  if (until <= run)
    return {"# wind forecast: none wanted, the forecast ends before the newest run of " +
            format_utc(run)};
  const hours wanted = std::chrono::ceil<hours>(until - run);
  const hours last = std::min(gfs_last_step, (wanted + gfs_step - hours(1)) / gfs_step * gfs_step);
  // One request a second: NOMADS serves 120 a minute (NWS service change notice 21-32).
  return {
      "# wind forecast: NOAA GFS, run of " + format_utc(run) +
          ", kept there for about ten days (10u and 10v of another model serve as well, e.g. ECMWF "
          "open data)",
      formatted("mkdir -p downloads && (for h in $(seq -f %03g 0 {} {}); do curl -fsS --retry "
                "3 \"{}\" || exit 1; sleep 1; done) > downloads/{}_wind_forecast.grib2",
                gfs_step.count(), last.count(), filter_address(site, run), site.id)};
}

}  // namespace slackwater::api
