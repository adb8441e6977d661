#include "api/pipeline/fetch/download_lines.h"

#include "api/pipeline/fetch/gfs_run.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

std::string subset_line(const WantedFile& f) {
  std::string line = "copernicusmarine subset -i " + f.dataset_id;
  if (f.part) line += " --dataset-part " + *f.part;
  for (const std::string& variable : f.variables) line += " -v " + variable;
  line += formatted(" -x {:.3f} -X {:.3f} -y {:.3f} -Y {:.3f}", f.box.west_deg, f.box.east_deg,
                    f.box.south_deg, f.box.north_deg);
  if (f.deepest_m) line += formatted(" -z 0 -Z {:.0f}", *f.deepest_m);
  if (f.from) line += " -t " + compact_time(*f.from) + " -T " + compact_time(*f.to);
  return line + " --coordinates-selection-method outside -o downloads -f " + f.file;
}

}  // namespace

std::vector<std::string> gfs_wind_lines(const Site& site, UtcTime issued, UtcTime until) {
  const GfsRun run = gfs_run(site, issued, until);
  if (run.addresses.empty())
    return {"# wind forecast: none wanted, the forecast ends before the newest run of " +
            format_utc(run.begun)};
  // One request a second: NOMADS serves 120 a minute (NWS service change notice 21-32).
  return {
      "# wind forecast: NOAA GFS, run of " + format_utc(run.begun) +
          ", kept there for about ten days (10u and 10v of another model serve as well, e.g. ECMWF "
          "open data)",
      formatted("mkdir -p downloads && (for h in $(seq -f %03g 0 {} {}); do curl -fsS --retry "
                "3 \"{}\" || exit 1; sleep 1; done) > downloads/{}_wind_forecast.grib2",
                gfs_step.count(), run.last_step.count(), gfs_address(site, run.begun, "$h"),
                site.id)};
}

std::vector<std::string> download_lines(const ingest::ProductCatalogue& products, const Site& site,
                                        const WantedTimes& wanted) {
  std::vector<std::string> lines;
  const UtcDay kept_from = archives_begin(wanted.issued);
  if (UtcTime(wanted.day) - wanted.history < UtcTime(kept_from))
    lines.push_back("# before " + format_day(kept_from) +
                    ": these archives hold about two years; older days are in the multi-year "
                    "products of the catalogue (MULTIYEAR)");
  for (const WantedFile& f : wanted_files(products, site, wanted)) {
    if (f.run) continue;
    if (f.file.empty()) {
      lines.push_back("# " + f.kind + ": " + f.why_not);
      continue;
    }
    lines.push_back("# " + f.kind + ": " + f.product_id +
                    (f.since ? " from " + format_day(*f.since) +
                                   " (days before are of another model, or not kept)"
                             : std::string()));
    lines.push_back(subset_line(f));
  }
  const auto wind = gfs_wind_lines(site, wanted.issued,
                                   UtcTime(wanted.day) + std::chrono::days(1) + wanted.horizon);
  lines.insert(lines.end(), wind.begin(), wind.end());
  return lines;
}

}  // namespace slackwater::api
