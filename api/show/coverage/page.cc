#include "api/show/coverage/page.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "api/show/coverage/marks.h"
#include "api/show/coverage/pictures.h"
#include "api/show/report/html_page.h"
#include "fields/base/numbers/quantile.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// Lengths of details and defects: "3 mm", "0.25 m".
std::string length_text(double length_m) {
  if (std::isinf(length_m)) return "nothing made out";
  if (!std::isfinite(length_m)) return "-";
  if (length_m < 0.0095) return formatted("{:.2g} mm", 1000 * length_m);
  if (length_m < 0.1) return formatted("{:.0f} mm", 1000 * length_m);
  return length_m < 10 ? formatted("{:.2f} m", length_m) : formatted("{:.0f} m", length_m);
}

std::string signed_length_text(double length_m) {
  return (length_m < 0 ? "-" : "+") + length_text(std::abs(length_m));
}

std::string length_text(const std::optional<double>& length_m) {
  return length_m ? length_text(*length_m) : "-";
}

std::string severity_text(twin::DefectKind kind, double severity) {
  if (!std::isfinite(severity)) return "-";
  return twin::severity_unit_of(kind) == twin::SeverityUnit::share
             ? formatted("{:.0f} %", 100 * severity)
             : length_text(severity);
}

/// Where on its sheet: "bearing 214°, depth 12.3 m", "along 12.0 m, down 3.1 m".
std::string where_text(const InspectionCoverage& coverage, const CoverageMark& mark) {
  const CoverageSheet& sheet = coverage.sheet;
  const std::string along = sheet.is_all_round
                                ? formatted("bearing {:03.0f}°", sheet.bearing_deg(mark.along_m))
                                : formatted("along {:.1f} m", mark.along_m);
  if (!sheet.has_depth()) return along + formatted(", across {:.1f} m", mark.down_m);
  const double depth_m = -mark.place_m.z();
  return along + (depth_m >= 0 ? formatted(", depth {:.1f} m", depth_m)
                               : formatted(", height {:.1f} m", -depth_m));
}

std::string asked_text(const InspectionCoverage& c) {
  return formatted("{} or finer, at most {:g}° off square, {} {}", length_text(c.asked_detail_m),
                   c.asked_incidence_deg, c.asked_looks, c.asked_looks == 1 ? "look" : "looks");
}

std::vector<std::vector<CoverageMark>> all_marks(const std::vector<InspectionCoverage>& coverages,
                                                 bool shows_truth) {
  std::vector<std::vector<CoverageMark>> marks;
  std::size_t reported = 0, missed = 0;
  for (const InspectionCoverage& coverage : coverages)
    marks.push_back(marks_of(coverage, shows_truth, reported, missed));
  return marks;
}

/// Detail against range: bins of equal width with P10, P50 and P90 of what was seen in them.
json range_json(const InspectionCoverage& coverage) {
  constexpr std::size_t bins = 30;
  double least = 1e300, most = 0;
  for (const CoveragePatch& patch : coverage.patches) {
    if (!std::isfinite(patch.range_m)) continue;
    least = std::min(least, patch.range_m);
    most = std::max(most, patch.range_m);
  }
  json out = json::array();
  if (most <= 0) return out;
  const double width = std::max((most - least) / bins, 1e-6);
  std::vector<std::vector<double>> details(bins);
  for (const CoveragePatch& patch : coverage.patches)
    if (std::isfinite(patch.range_m) && std::isfinite(patch.detail_m))
      details[std::min(bins - 1, static_cast<std::size_t>((patch.range_m - least) / width))]
          .push_back(1000 * patch.detail_m);
  for (std::size_t b = 0; b < bins; ++b)
    if (!details[b].empty())
      out.push_back({number(least + (static_cast<double>(b) + 0.5) * width),
                     number(*quantile_of(details[b], 0.1)), number(*quantile_of(details[b], 0.5)),
                     number(*quantile_of(details[b], 0.9))});
  return out;
}

/// Share covered so far (%), by the time of each patch's best look, at most 200 points.
json time_json(const InspectionCoverage& coverage) {
  std::vector<std::pair<double, double>> seen;
  for (const CoveragePatch& patch : coverage.patches)
    if (patch.state == PatchState::covered) seen.emplace_back(patch.t_s, patch.area_m2);
  std::sort(seen.begin(), seen.end());
  json out = json::array();
  if (!seen.empty()) out.push_back({number(seen.front().first), 0});
  double area_m2 = 0;
  const std::size_t every = std::max<std::size_t>(1, seen.size() / 200);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    area_m2 += seen[i].second;
    if ((i + 1) % every == 0 || i + 1 == seen.size())
      out.push_back({number(seen[i].first), number(100 * area_m2 / coverage.area_m2)});
  }
  return out;
}

ReportTable coverage_table(const std::vector<InspectionCoverage>& coverages) {
  ReportTable table;
  table.title = "Coverage";
  table.note =
      "Detail: the smallest size that can be seen, in the best look at each patch. Covered: seen "
      "as finely, as squarely and as often as asked.";
  table.columns = {"Surface",       "Instrument",      "Vehicle",       "Area",
                   "Covered",       "Not well enough", "Not seen",      "Asked for",
                   "Seen as asked", "Least detail",    "Median detail", "A patch is covered at"};
  for (const InspectionCoverage& c : coverages) {
    const auto shares = c.shares();
    table.rows.push_back(
        {c.surface, c.instrument, c.vehicle, formatted("{:.1f} m2", c.area_m2),
         percent_text(shares[0]), percent_text(shares[1]), percent_text(shares[2]),
         percent_text(c.done_at), c.done_at > 0 ? (c.is_done() ? "yes" : "no") : "-",
         length_text(c.least_detail_m), length_text(c.median_detail_m), asked_text(c)});
  }
  return table;
}

std::string time_text(UtcTime epoch, double t_s) {
  return format_utc(epoch + Duration(static_cast<Duration::rep>(std::floor(t_s)) * 1000));
}

ReportTable reported_table(const std::vector<InspectionCoverage>& coverages, UtcTime epoch,
                           bool shows_truth) {
  ReportTable table;
  table.title = "Findings";
  table.columns = {"No.",     "What",   "Surface",    "Where", "Size",
                   "How far", "Detail", "Instrument", "UTC"};
  if (shows_truth)
    for (const char* column : {"In truth", "True size", "Size error", "Off by"})
      table.columns.emplace_back(column);
  table.note =
      "As reported. How far: depth, thickness or burial lost; share of an anode, of a chain's "
      "diameter or of fasteners.";
  const auto marks = all_marks(coverages, shows_truth);
  for (std::size_t i = 0; i < coverages.size(); ++i)
    for (const CoverageMark& mark : marks[i]) {
      const Finding& f = *mark.finding;
      if (!f.is_reported()) continue;
      std::vector<std::string> row{mark.label,
                                   words_of(f.kind),
                                   coverages[i].surface,
                                   where_text(coverages[i], mark),
                                   length_text(f.size_m),
                                   severity_text(f.kind, f.severity),
                                   length_text(f.detail_m),
                                   coverages[i].instrument,
                                   time_text(epoch, f.t_s)};
      if (shows_truth) {
        const bool is_there = f.outcome == FindingOutcome::found;
        row.emplace_back(words_of(f.outcome));
        row.push_back(length_text(f.true_size_m));
        row.push_back(is_there ? signed_length_text(f.size_m - f.true_size_m) : "-");
        row.push_back(is_there ? formatted("{:.2f} m", (f.reported_m - f.true_m).norm()) : "-");
      }
      table.rows.push_back(std::move(row));
    }
  return table;
}

ReportTable missed_table(const std::vector<InspectionCoverage>& coverages) {
  ReportTable table;
  table.title = "Planted and missed";
  table.note = "Known only because the truth was asked for.";
  table.columns = {"No.", "What", "Surface", "Where", "True size", "How far", "Instrument", "Why"};
  const auto marks = all_marks(coverages, true);
  for (std::size_t i = 0; i < coverages.size(); ++i)
    for (const CoverageMark& mark : marks[i]) {
      const Finding& f = *mark.finding;
      if (f.is_reported()) continue;
      table.rows.push_back({mark.label, words_of(f.kind), coverages[i].surface,
                            where_text(coverages[i], mark), length_text(f.true_size_m),
                            severity_text(f.kind, f.true_severity), coverages[i].instrument,
                            words_of(f.outcome)});
    }
  return table;
}

}  // namespace

std::string coverage_text(const InspectionCoverage& coverage) {
  return coverage.instrument + " of " + coverage.vehicle +
         formatted(": {} of {:.1f} m2 covered", percent_text(coverage.shares()[0]),
                   coverage.area_m2) +
         asked_share_text(coverage) + "; covered is what was seen at " + asked_text(coverage) + ".";
}

std::string coverage_html(const std::vector<InspectionCoverage>& coverages, bool shows_truth) {
  if (coverages.empty()) return {};
  const auto marks = all_marks(coverages, shows_truth);
  std::string articles;
  for (std::size_t i = 0; i < coverages.size(); ++i)
    articles += pictures_html(coverages[i], marks[i], coverage_text(coverages[i]));
  std::string note =
      "Marks stand where something was reported; the numbers are those of the table of findings.";
  if (shows_truth)
    note += " The truth is shown: M are planted defects that nobody reported, where they are.";
  return coverage_section_html("What was seen", articles, note);
}

std::string coverage_plots_html(const std::vector<InspectionCoverage>& coverages) {
  if (coverages.empty()) return {};
  return plot_html("detail-range", "Detail against distance",
                   "The smallest size that can be seen (mm), in the best look at each patch: the "
                   "median, and a band from P10 to P90. Dashed: asked for. Up is coarser.") +
         plot_html("covered-time", "Covered against time",
                   "Of the area of each surface (%), by the time of each patch's best look. "
                   "Dashed: asked for.");
}

json coverage_json(const std::vector<InspectionCoverage>& coverages) {
  json all = json::array();
  for (const InspectionCoverage& c : coverages)
    all.push_back({{"name", c.name()},
                   {"asked_mm", number(1000 * c.asked_detail_m)},
                   {"done_at", number(100 * c.done_at)},
                   {"range", range_json(c)},
                   {"time", time_json(c)}});
  return all;
}

std::string coverage_tables_html(const std::vector<InspectionCoverage>& coverages, UtcTime epoch,
                                 bool shows_truth) {
  if (coverages.empty()) return {};
  ReportTable reported = reported_table(coverages, epoch, shows_truth);
  if (reported.rows.empty()) reported.note = "None.";
  std::string html = table_html(coverage_table(coverages)) + table_html(reported);
  if (!shows_truth) return html;
  ReportTable missed = missed_table(coverages);
  if (missed.rows.empty()) missed.note = "None.";
  return html + table_html(missed);
}

}  // namespace slackwater::api
