#include "twin/risk/past_verdicts.h"

#include <algorithm>
#include <vector>

namespace slackwater::twin {
namespace {

std::size_t class_of(double probability, const VerdictRule& rule) {
  constexpr double hardly = 0.1;
  const Verdict verdict = verdict_of(probability, rule);
  return verdict == Verdict::no_go && probability < hardly ? 3 : static_cast<std::size_t>(verdict);
}

}  // namespace

PastVerdicts& PastVerdicts::operator+=(const PastVerdicts& more) noexcept {
  mornings = std::max(mornings, more.mornings);
  goes += more.goes;
  goes_held += more.goes_held;
  lost += more.lost;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    classes[c].starts += more.classes[c].starts;
    classes[c].said += more.classes[c].said;
    classes[c].held += more.classes[c].held;
  }
  return *this;
}

PastVerdicts past_verdicts(std::span<const PastStarts> mornings, const VerdictRule& rule) {
  PastVerdicts out;
  for (std::size_t m = 0; m < mornings.size(); ++m) {
    if (mornings[m].empty()) continue;
    std::vector<PastStarts> others(mornings.begin(), mornings.end());
    others[m].clear();
    const ChanceCalibration calibration = chance_calibration(others);
    ++out.mornings;
    double best = -1;
    bool best_held = false;
    for (const PastStart& start : mornings[m]) {
      const double said = calibration(start.said);
      SaidAndCame& of = out.classes[class_of(said, rule)];
      ++of.starts;
      of.said += said;
      of.held += start.held ? 1 : 0;
      if (said > best) {
        best = said;
        best_held = start.held;
      }
    }
    if (verdict_of(best, rule) == Verdict::go) {
      ++out.goes;
      out.goes_held += best_held ? 1 : 0;
    } else {
      out.lost += best_held ? 1 : 0;
    }
  }
  return out;
}

}  // namespace slackwater::twin
