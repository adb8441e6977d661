#include "api/show/coverage/pictures.h"

#include <algorithm>
#include <set>

#include "api/show/coverage/sheet.h"
#include "api/show/coverage/still.h"
#include "api/show/report/html_page.h"
#include "fields/base/encode/html.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// Grounds of the three states, told apart by lightness and by pattern.
const char* patterns_html() {
  return "<svg class=\"patterns\" aria-hidden=\"true\" width=\"0\" height=\"0\"><defs>"
         "<pattern id=\"seen-poorly\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\" "
         "patternTransform=\"rotate(45)\"><rect class=\"ground\" width=\"5\" height=\"5\"/>"
         "<rect class=\"stripe\" width=\"2\" height=\"5\"/></pattern>"
         "<pattern id=\"not-seen\" width=\"8\" height=\"8\" patternUnits=\"userSpaceOnUse\">"
         "<rect class=\"ground\" width=\"8\" height=\"8\"/><circle class=\"dot\" cx=\"2\" "
         "cy=\"2\" r=\"0.8\"/><circle class=\"dot\" cx=\"6\" cy=\"6\" r=\"0.8\"/></pattern>"
         "</defs></svg>";
}

std::string legend_html(const InspectionCoverage& coverage,
                        const std::vector<CoverageMark>& marks) {
  const auto shares = coverage.shares();
  std::string html = "<ul class=\"legend\">";
  const auto item = [&](const std::string& swatch, const std::string& words) {
    html += "<li><svg aria-hidden=\"true\" viewBox=\"0 0 22 16\" width=\"22\" height=\"16\">" +
            swatch + "</svg>" + escaped_html(words) + "</li>";
  };
  for (std::size_t s = 0; s < patch_states; ++s)
    item(formatted("<rect class=\"state{} edge\" x=\"1\" y=\"1\" width=\"20\" height=\"14\"/>", s),
         coverage.words[s] + (" " + percent_text(shares[s])));
  std::set<std::string> shown;
  for (const CoverageMark& mark : marks)
    if (shown.insert(mark.shape).second) item(shape_svg(mark.shape, 11, 8), mark.words);
  return html + "</ul>";
}

}  // namespace

std::string percent_text(double share) {
  const double whole = 100 * share;
  if (whole > 99.5 && whole < 100) return formatted("{:.1f} %", std::min(99.9, whole));
  if (whole > 0 && whole < 0.5) return formatted("{:.1f} %", std::max(0.1, whole));
  return formatted("{:.0f} %", whole);
}

std::string asked_share_text(const InspectionCoverage& coverage) {
  return coverage.done_at > 0 ? ", asked for " + percent_text(coverage.done_at) : std::string();
}

std::string pictures_html(const InspectionCoverage& coverage,
                          const std::vector<CoverageMark>& marks, const std::string& sentence) {
  return "<article><h3>" + escaped_html(coverage.surface) + "</h3><p>" + escaped_html(sentence) +
         "</p>" + legend_html(coverage, marks) + "<div class=\"pair\"><figure>" +
         sheet_svg(coverage, marks) +
         "<figcaption>Unrolled, seen from outside.</figcaption></figure><figure>" +
         still_svg(coverage, marks) +
         "<figcaption>In space, in parallel from 25° above.</figcaption></figure></div></article>";
}

std::string coverage_section_html(const std::string& title, const std::string& pictures,
                                  const std::string& note) {
  return "<section class=\"coverage\" id=\"coverage\"><h2>" + escaped_html(title) + "</h2>" +
         patterns_html() + pictures + "<p class=\"note\">" + escaped_html(note) +
         "</p></section>\n";
}

}  // namespace slackwater::api
