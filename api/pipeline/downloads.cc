#include "api/pipeline/downloads.h"
#include "fields/base/text.h"

#include <algorithm>
#include <cmath>
#include <tuple>

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
  line += " --coordinates-selection-method outside -o downloads -f " + site.id + "_" +
          std::string(name_of_kind(d.kind)) + ".nc";
  return line;
}

}  // namespace

std::vector<std::string> download_lines(const ingest::ProductCatalogue& products, const Site& site,
                                        UtcDay day, Duration horizon) {
  using std::chrono::days;
  std::vector<std::string> lines;
  const std::vector<Download> all = products.downloads();
  for (const DownloadKind kind : {DownloadKind::current, DownloadKind::level, DownloadKind::wave,
                                  DownloadKind::bathymetry, DownloadKind::wind}) {
    const auto fits = [&](const Download& d) {
      return d.kind == kind && d.domain.contains(site.point);
    };
    // With tide and depth before finer without: a forecast without the tide is no forecast on a
    // shelf.
    const auto better = [](const Download& a, const Download& b) {
      return std::tuple(!a.has_tide, a.priority, !a.has_depth) <
             std::tuple(!b.has_tide, b.priority, !b.has_depth);
    };
    std::vector<Download> fitting;
    std::copy_if(all.begin(), all.end(), std::back_inserter(fitting), fits);
    if (fitting.empty()) {
      lines.push_back("# " + std::string(name_of_kind(kind)) +
                      ": no Copernicus Marine dataset covers the site");
      continue;
    }
    const Download& best = *std::min_element(fitting.begin(), fitting.end(), better);
    const UtcTime from = UtcTime(day) - days(3);
    const UtcTime to =
        best.horizon_h > 0 ? UtcTime(day) + days(1) + horizon : UtcTime(day) + days(1);
    lines.push_back("# " + std::string(name_of_kind(kind)) + ": " + best.product_id);
    lines.push_back(subset_line(best, site, from, to));
  }
  lines.emplace_back(
      "# wind forecast: none in Copernicus Marine; fetch 10u and 10v as GRIB from a weather model "
      "(ECMWF "
      "open data, ICON, GFS) and ingest it beside these files");
  return lines;
}

}  // namespace slackwater::api
