#include "twin/inspection/defect/detection_score.h"

#include <cmath>

namespace slackwater::twin {
namespace {

std::optional<double> root_mean(double squares, std::size_t count) {
  if (count == 0) return std::nullopt;
  return std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

DetectionScore score_of(std::span<const Defect> defects, const Findings& findings) {
  DetectionScore score;
  const auto of = [&](DefectKind kind) -> DetectionScore::OfKind& {
    return score.kinds[static_cast<std::size_t>(kind)];
  };
  for (const Defect& defect : defects) {
    ++of(defect.kind).planted;
    ++of(defect.kind).found;
  }
  for (const Miss& miss : findings.missed) --of(miss.defect.kind).found;
  std::size_t sized = 0;
  double squares_m2 = 0, squares = 0;
  for (const Finding& finding : findings.found) {
    if (!finding.defect) {
      ++of(finding.kind).false_alarms;
      continue;
    }
    const double off_m = finding.size_m - finding.true_size_m;
    squares_m2 += off_m * off_m;
    squares += off_m * off_m / (finding.true_size_m * finding.true_size_m);
    ++sized;
  }
  for (const DetectionScore::OfKind& kind : score.kinds) {
    score.all.planted += kind.planted;
    score.all.found += kind.found;
    score.all.false_alarms += kind.false_alarms;
  }
  if (score.all.planted > 0)
    score.detection_rate =
        static_cast<double>(score.all.found) / static_cast<double>(score.all.planted);
  if (findings.read_m2 > 0)
    score.false_alarms_per_100_m2 =
        100 * static_cast<double>(score.all.false_alarms) / findings.read_m2;
  score.size_error_rms_m = root_mean(squares_m2, sized);
  score.size_error_relative_rms = root_mean(squares, sized);
  return score;
}

}  // namespace slackwater::twin
