#include "api/pipeline/ingest/downloads.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "api/pipeline/ingest/gfs_download.h"
#include "fields/base/text.h"

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

std::string compact_time(UtcTime time) {
  std::string text = format_utc(time);
  text.pop_back();  // copernicusmarine takes UTC without the Z
  return text;
}

std::string subset_line(const Download& d, const Site& site, UtcTime from, UtcTime to) {
  // Half a degree around the site: more than two cells of the coarsest product.
  const BoundingBox box = site.box(0.25);
  std::string line = "copernicusmarine subset -i " + d.dataset_id;
  if (d.part) line += " --dataset-part " + *d.part;
  for (const std::string& variable : d.variables) line += " -v " + variable;
  line += formatted(" -x {:.3f} -X {:.3f} -y {:.3f} -Y {:.3f}", box.west_deg, box.east_deg,
                    box.south_deg, box.north_deg);
  if (d.has_depth) {
    const double deepest = site.water_depth_m ? std::ceil(*site.water_depth_m / 10) * 10 + 10 : 200;
    line += formatted(" -z 0 -Z {:.0f}", deepest);
  }
  if (d.kind != DownloadKind::bathymetry)
    line += " -t " + compact_time(from) + " -T " + compact_time(to);
  // By the dataset's name it is known later what the stamps mean (ingest/cf/dataset_period.h).
  line += " --coordinates-selection-method outside -o downloads -f " + site.id + "_" +
          std::string(name_of_kind(d.kind)) + "_" + d.dataset_id + ".nc";
  return line;
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

/// What the archives of forecasts hold: the product user manuals say two years, rolling.
constexpr std::chrono::days forecast_archive{730};

}  // namespace

std::vector<std::string> download_lines(const ingest::ProductCatalogue& products, const Site& site,
                                        const WantedTimes& wanted) {
  const UtcTime past_from = UtcTime(wanted.day) - wanted.history;
  const UtcTime day_end = UtcTime(wanted.day) + std::chrono::days(1);
  std::vector<std::string> lines;
  const UtcDay kept_from = day_of(wanted.issued) - forecast_archive;
  if (past_from < UtcTime(kept_from))
    lines.push_back("# before " + format_day(kept_from) +
                    ": these archives hold about two years; older days are in the multi-year "
                    "products of the catalogue (MULTIYEAR)");
  const std::vector<Download> all = products.downloads();
  for (const DownloadKind kind : {DownloadKind::current, DownloadKind::level, DownloadKind::wave,
                                  DownloadKind::bathymetry, DownloadKind::wind}) {
    const std::string name(name_of_kind(kind));
    const Download* best = best_of(all, kind, site);
    if (best == nullptr) {
      lines.push_back("# " + name + ": no Copernicus Marine dataset covers the site");
      continue;
    }
    UtcTime from = past_from;
    std::string comment = "# " + name + ": " + best->product_id;
    if (best->since && from < UtcTime(*best->since) && *best->since <= wanted.day) {
      from = UtcTime(*best->since);
      comment +=
          " from " + format_day(*best->since) + " (days before are of another model, or not kept)";
    }
    lines.push_back(std::move(comment));
    lines.push_back(
        subset_line(*best, site, from, best->horizon_h > 0 ? day_end + wanted.horizon : day_end));
  }
  const auto wind = gfs_wind_lines(site, wanted.issued, day_end + wanted.horizon);
  lines.insert(lines.end(), wind.begin(), wind.end());
  return lines;
}

}  // namespace slackwater::api
