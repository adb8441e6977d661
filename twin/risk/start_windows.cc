#include "twin/risk/start_windows.h"

#include <algorithm>

#include "fields/base/check.h"

namespace slackwater::twin {

std::vector<StartWindow> windows_of(std::span<const StartChance> chances,
                                    std::span<const double> probability,
                                    std::span<const std::uint8_t> marks) {
  expects(probability.size() == chances.size() && marks.size() == chances.size(),
          "a probability and a mark for each start");
  std::vector<StartWindow> windows;
  for (const StepRange& run : runs_of(marks)) {
    StartWindow window;
    window.first = window.best = run.begin;
    window.last = run.end - 1;
    window.least = 1;
    for (std::size_t s = run.begin; s < run.end; ++s) {
      window.least = std::min(window.least, probability[s]);
      window.mean += probability[s] / static_cast<double>(run.steps());
      if (probability[s] > window.most) {
        window.most = probability[s];
        window.best = s;
      }
      window.by_threshold += chances[s].by_threshold ? 1 : 0;
      window.by_alpha += chances[s].by_alpha.value_or(false) ? 1 : 0;
    }
    windows.push_back(window);
  }
  return windows;
}

std::string_view name_of(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::go:
      return "go";
    case Verdict::marginal:
      return "marginal";
    case Verdict::no_go:
      return "no-go";
  }
  return "";
}

Verdict verdict_of(double probability, const VerdictRule& rule) noexcept {
  if (probability >= rule.go) return Verdict::go;
  return probability >= rule.marginal ? Verdict::marginal : Verdict::no_go;
}

}  // namespace slackwater::twin
