#include "api/show/detect/seen_page.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "api/perception/jpeg.h"
#include "api/program/version.h"
#include "api/show/report/html_page.h"
#include "fields/base/check.h"
#include "fields/base/encode/base64.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

constexpr std::size_t most_on_page = 200;
constexpr int widest_px = 720;

constexpr const char* style = R"(<style>
.strip { display: grid; grid-template-columns: repeat(auto-fill, minmax(280px, 1fr)); gap: 12px; }
.strip figure { margin: 0; }
.strip img { width: 100%; display: block; }
.strip .seen { position: relative; }
.strip svg { position: absolute; inset: 0; width: 100%; height: 100%; }
.strip rect { fill: none; vector-effect: non-scaling-stroke; stroke-width: 2; }
.strip .find { stroke: #ffd400; }
.strip .truth { stroke: #00e5ff; stroke-dasharray: 5 4; visibility: hidden; }
#truth:checked ~ .strip .truth { visibility: visible; }
.strip figcaption { font-size: var(--text-small); color: var(--quiet); }
.key { font-size: var(--text-small); }
</style>
)";

twin::Picture halved(const twin::Picture& picture) {
  twin::Picture half;
  half.wide = picture.wide / 2;
  half.high = picture.high / 2;
  half.rgb.reserve(std::size_t{3} * static_cast<std::size_t>(half.wide) *
                   static_cast<std::size_t>(half.high));
  for (int j = 0; j < half.high; ++j)
    for (int i = 0; i < half.wide; ++i)
      for (int k = 0; k < 3; ++k) {
        const int sum = picture.at(2 * i, 2 * j)[k] + picture.at(2 * i + 1, 2 * j)[k] +
                        picture.at(2 * i, 2 * j + 1)[k] + picture.at(2 * i + 1, 2 * j + 1)[k];
        half.rgb.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
  return half;
}

/// In the order of time.
std::vector<std::size_t> chosen(const RunFinds& finds) {
  const auto& pictures = finds.pictures();
  std::vector<std::size_t> all(pictures.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (all.size() <= most_on_page) return all;
  std::vector<std::size_t> kept, others;
  const auto take = [&](const auto& is_one) {
    for (const std::size_t i : all)
      if (kept.size() < most_on_page && is_one(pictures[i])) kept.push_back(i);
  };
  take([](const DetectedPicture& one) { return !one.finds.empty(); });
  take([](const DetectedPicture& one) { return one.finds.empty() && !one.shown.empty(); });
  for (const std::size_t i : all)
    if (pictures[i].finds.empty() && pictures[i].shown.empty()) others.push_back(i);
  const std::size_t room = most_on_page - kept.size();
  for (std::size_t i = 0; i < std::min(room, others.size()); ++i)
    kept.push_back(others[others.size() > room ? i * others.size() / room : i]);
  std::sort(kept.begin(), kept.end());
  return kept;
}

std::string rect_of(const PixelBox& box, const char* name, const std::string& title) {
  return formatted(R"(<rect class="{}" x="{:.1f}" y="{:.1f}")", name, box.left, box.top) +
         formatted(R"( width="{:.1f}" height="{:.1f}">)", box.right - box.left,
                   box.bottom - box.top) +
         "<title>" + escaped_html(title) + "</title></rect>";
}

std::string light_words(double gain) {
  if (gain < 1) return "bright";
  return gain > 1 ? formatted("dark, amplified {:.1f} times", gain) : "light as needed";
}

std::string figure_of(const DetectedPicture& picture, const Thumbnail& thumbnail) {
  std::vector<std::string> found;
  std::string boxes;
  for (const ShownDefect& defect : picture.shown)
    boxes += rect_of(defect.box, "truth",
                     formatted("planted: {}, {:.0f} mm", defect.of, 1000 * defect.size_m));
  for (const PlacedFind& placed : picture.finds) {
    const std::string words = formatted("{}, confidence {:.2f}, {:.0f} mm", placed.find.of,
                                        placed.find.confidence, 1000 * placed.size_m);
    boxes += rect_of(placed.find.box, "find", words);
    found.push_back(words);
  }
  const std::string what = found.empty() ? "nothing found" : joined(found, "; ");
  std::string out = R"(<figure><div class="seen"><img loading="lazy" alt=")" + escaped_html(what) +
                    R"(" src="data:image/jpeg;base64,)" + base64_of(thumbnail.jpeg) + R"(">)";
  out +=
      formatted(R"(<svg viewBox="0 0 {} {}" aria-hidden="true">)", thumbnail.wide, thumbnail.high) +
      boxes + "</svg></div><figcaption>";
  const std::string range = std::isfinite(picture.range_m)
                                ? formatted("{:.1f} m away", picture.range_m)
                                : "nothing in reach";
  return out +
         formatted("{} ({:.0f} s), {}, {}: {}", format_utc(picture.time), picture.t_s, range,
                   light_words(picture.gain), escaped_html(what)) +
         "</figcaption></figure>\n";
}

ReportTable findings_table(const RunFinds& finds) {
  ReportTable table;
  table.title = "What was found";
  table.columns = {"",        "kind",   "surface",    "time (UTC)", "depth m",
                   "size mm", "from m", "confidence", "pictures",   "in truth"};
  for (const RunFinding& one : finds.findings())
    table.rows.push_back({std::to_string(table.rows.size() + 1), one.of, one.surface,
                          format_utc(one.time), formatted("{:.1f}", one.place_m.z),
                          formatted("{:.0f}", 1000 * one.size_m), formatted("{:.1f}", one.range_m),
                          formatted("{:.2f}", one.confidence), std::to_string(one.pictures),
                          one.defect ? formatted("defect {}", *one.defect) : "false alarm"});
  table.note =
      "Confidence is the detector's own measure, no probability. Places and sizes go by the true "
      "range and pose.";
  return table;
}

ReportTable score_table(const RunFinds& finds) {
  ReportTable table;
  table.title = "How much of what was planted";
  table.columns = {"kind", "in view", "found", "false alarms"};
  for (const KindFound& one : finds.score())
    table.rows.push_back({one.of, std::to_string(one.in_view), std::to_string(one.found),
                          std::to_string(one.false_alarms)});
  table.note = formatted(
      "In view: shown by at least {} pixels of one picture. On rendered pictures: an estimate.",
      RunFinds::least_pixels);
  return table;
}

}  // namespace

Thumbnail thumbnail_of(const twin::Picture& picture) {
  Thumbnail thumbnail{{}, picture.wide, picture.high};
  constexpr int quality = 75;
  twin::Picture small = picture;
  while (small.wide > widest_px) small = halved(small);
  thumbnail.jpeg = jpeg_of(small, quality);
  return thumbnail;
}

std::string seen_page(const RunFinds& finds, const std::vector<Thumbnail>& thumbnails,
                      const WhoLooked& who, const std::string& title) {
  expects(thumbnails.size() == finds.pictures().size(), "a thumbnail of each picture");
  HtmlPage page;
  page.title = title + ": what was seen";
  page.site = formatted("{} on {}, looked at by {}", who.sensor, who.vehicle, who.detector);
  std::size_t in_view = 0, found = 0, false_alarms = 0;
  for (const KindFound& one : finds.score()) {
    in_view += one.in_view;
    found += one.found;
    false_alarms += one.false_alarms;
  }
  page.headline = formatted("{} of {} planted defects in view found, {}", found, in_view,
                            counted(false_alarms, "false alarm"));
  if (in_view == 0)
    page.headline = formatted("no planted defect of these kinds in view, {}",
                              counted(false_alarms, "false alarm"));
  page.facts = {{"Pictures", std::to_string(finds.pictures().size())},
                {"Findings", std::to_string(finds.findings().size())}};
  const std::vector<std::size_t> kept = chosen(finds);
  page.tables_html = style;
  page.tables_html += table_html(score_table(finds));
  if (!finds.findings().empty()) page.tables_html += table_html(findings_table(finds));
  page.tables_html +=
      "<section><h2>Pictures</h2><input type=\"checkbox\" id=\"truth\"> <label for=\"truth\" "
      "class=\"key\">show what is there (dashed); what the detector found is drawn "
      "through</label>";
  if (kept.size() < finds.pictures().size())
    page.tables_html +=
        formatted("<p class=\"note\">{} of {} pictures: those with finds or defects first.</p>",
                  kept.size(), finds.pictures().size());
  page.tables_html += "<div class=\"strip\">\n";
  for (const std::size_t i : kept)
    page.tables_html += figure_of(finds.pictures()[i], thumbnails[i]);
  page.tables_html += "</div></section>\n";
  page.is_without_plots = true;
  page.generated = "by slackwater " + code_version();
  return page_html(page, {});
}

}  // namespace slackwater::api
