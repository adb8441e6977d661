#include "api/pipeline/fetch/wanted_files.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>

#include "api/pipeline/fetch/gfs_run.h"

namespace slackwater::api {
namespace {

using ingest::Download;
using ingest::DownloadKind;

std::string_view name_of_kind(DownloadKind kind) {
  switch (kind) {
    case DownloadKind::current:
      return "currents";
    case DownloadKind::wave:
      return "waves";
    case DownloadKind::wind:
      return "wind";
    case DownloadKind::bathymetry:
      return "bathymetry";
    case DownloadKind::level:
      return "level";
  }
  return "";
}

/// The dataset of a kind to fetch for a site, or null.
const Download* best_of(const std::vector<Download>& all, DownloadKind kind, const Site& site) {
  // With tide and depth before finer without: a forecast without the tide is no forecast on a
  // shelf.
  const auto rank = [](const Download& d) {
    return std::tuple(!d.has_tide, d.priority, !d.has_depth);
  };
  const Download* best = nullptr;
  for (const Download& d : all) {
    if (d.kind != kind || !d.covers(site.point)) continue;
    if (best == nullptr || rank(d) < rank(*best)) best = &d;
  }
  return best;
}

double deepest_m(const Site& site) {
  return site.water_depth_m ? std::ceil(*site.water_depth_m / 10) * 10 + 10 : 200;
}

WantedFile file_of(const Download& d, const Site& site, const WantedTimes& wanted) {
  const UtcTime day_end = UtcTime(wanted.day) + std::chrono::days(1);
  WantedFile file;
  file.kind = name_of_kind(d.kind);
  file.product_id = d.product_id;
  file.dataset_id = d.dataset_id;
  file.part = d.part;
  file.variables = d.variables;
  // Half a degree around the site: more than two cells of the coarsest product.
  file.box = site.box(0.25);
  if (d.has_depth) file.deepest_m = deepest_m(site);
  if (d.kind != DownloadKind::bathymetry) {
    file.from = UtcTime(wanted.day) - wanted.history;
    // A product goes no further than it does.
    const auto reach = std::chrono::duration_cast<Duration>(
        std::chrono::duration<double, std::ratio<3600>>(d.horizon_h));
    file.to = d.horizon_h > 0
                  ? std::min(day_end + wanted.horizon, UtcTime(day_of(wanted.issued)) + reach)
                  : day_end;
    file.to = std::max(*file.to, day_end);
    if (d.since && *file.from < UtcTime(*d.since) && *d.since <= wanted.day) {
      file.since = d.since;
      file.from = UtcTime(*d.since);
    }
  }
  // By the dataset's name it is known later what the stamps mean (ingest/cf/dataset_period.h).
  file.file = site.id + "_" + file.kind + "_" + d.dataset_id + ".nc";
  return file;
}

WantedFile wind_forecast(const Site& site, UtcTime issued, UtcTime until) {
  const GfsRun run = gfs_run(site, issued, until);
  WantedFile file;
  file.kind = "wind forecast";
  file.product_id = "NOAA GFS";
  file.box = site.box(0.5);
  file.run = run.begun;
  file.from = run.begun;
  file.to = until;
  file.addresses = run.addresses;
  if (file.addresses.empty())
    file.why_not = "the forecast ends before the newest run of " + format_utc(run.begun);
  else
    file.file = site.id + "_wind_forecast.grib2";
  return file;
}

}  // namespace

std::vector<WantedFile> wanted_files(const ingest::ProductCatalogue& products, const Site& site,
                                     const WantedTimes& wanted) {
  std::vector<WantedFile> files;
  const std::vector<Download> all = products.downloads();
  for (const DownloadKind kind : {DownloadKind::current, DownloadKind::level, DownloadKind::wave,
                                  DownloadKind::bathymetry, DownloadKind::wind}) {
    if (const Download* best = best_of(all, kind, site)) {
      files.push_back(file_of(*best, site, wanted));
    } else {
      WantedFile& none = files.emplace_back();
      none.kind = name_of_kind(kind);
      none.why_not = "no Copernicus Marine dataset covers the site";
    }
  }
  files.push_back(wind_forecast(site, wanted.issued,
                                UtcTime(wanted.day) + std::chrono::days(1) + wanted.horizon));
  return files;
}

std::string compact_time(UtcTime time) {
  std::string text = format_utc(time);
  text.pop_back();
  return text;
}

UtcDay archives_begin(UtcTime issued) { return day_of(issued) - std::chrono::days(730); }

}  // namespace slackwater::api
