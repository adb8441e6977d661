#include "api/show/coverage/marks.h"

#include "api/show/coverage/tangents.h"
#include "fields/base/encode/html.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

const char* shape_of(FindingOutcome outcome, bool shows_truth) {
  switch (outcome) {
    case FindingOutcome::found:
      return "reported";
    case FindingOutcome::false_alarm:
      return shows_truth ? "false" : "reported";
    case FindingOutcome::never_seen:
      return "unseen";
    case FindingOutcome::seen_too_poorly:
      return "poor";
    case FindingOutcome::overlooked:
      return "overlooked";
  }
  return "reported";
}

}  // namespace

std::vector<CoverageMark> marks_of(const InspectionCoverage& coverage, bool shows_truth,
                                   std::size_t& reported, std::size_t& missed) {
  std::vector<CoverageMark> marks;
  for (const Finding& finding : coverage.findings) {
    if (!finding.is_reported() && !shows_truth) continue;
    CoverageMark mark;
    mark.finding = &finding;
    mark.label =
        finding.is_reported() ? std::to_string(++reported) : "M" + std::to_string(++missed);
    mark.place_m = finding.is_reported() ? finding.reported_m : finding.true_m;
    mark.along_m = finding.along_m;
    mark.down_m = finding.down_m;
    const SheetPlace place = sheet_place(coverage, mark.place_m);
    mark.normal = place.normal;
    // Whoever flies knows where it was reported, not where on the sheet it truly is.
    if (finding.is_reported()) {
      mark.along_m = place.along_m;
      mark.down_m = place.down_m;
    }
    mark.words = shows_truth ? words_of(finding.outcome) : "reported";
    mark.shape = shape_of(finding.outcome, shows_truth);
    marks.push_back(std::move(mark));
  }
  return marks;
}

std::string shape_svg(const std::string& shape, double x, double y) {
  const auto path = [&](const char* fill, const std::string& d) {
    // A halo of paper first: it stands out on every ground.
    return formatted("<path class=\"halo\" d=\"{}\"/><path class=\"{}\" d=\"{}\"/>", d, fill, d);
  };
  if (shape == "reported")
    return path("mark full", formatted("M{:.1f} {:.1f}l5 5-5 5-5-5z", x, y - 5));
  if (shape == "false") return path("mark", formatted("M{:.1f} {:.1f}h9v9h-9z", x - 4.5, y - 4.5));
  if (shape == "unseen")
    return path("mark", formatted("M{:.1f} {:.1f}a5 5 0 1 0 10 0a5 5 0 1 0-10 0z", x - 5, y));
  if (shape == "poor") return path("mark", formatted("M{:.1f} {:.1f}l5.5 9.5h-11z", x, y - 6));
  return path("mark cross", formatted("M{:.1f} {:.1f}l9 9m0-9l-9 9", x - 4.5, y - 4.5));
}

std::string mark_svg(const CoverageMark& mark, double x, double y) {
  return "<g><title>" +
         escaped_html(mark.label + ": " + words_of(mark.finding->kind) + ", " + mark.words) +
         "</title>" + shape_svg(mark.shape, x, y) +
         formatted("<text class=\"number\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text></g>", x + 8, y + 4,
                   mark.label);
}

}  // namespace slackwater::api
