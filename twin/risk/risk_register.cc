#include "twin/risk/risk_register.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace slackwater::twin {
namespace {

constexpr std::array below{0.01, 0.05, 0.2, 0.5};
constexpr std::array<std::string_view, 5> likelihoods{"rare (below 1 %)", "unlikely (1 to 5 %)",
                                                      "possible (5 to 20 %)", "likely (20 to 50 %)",
                                                      "expected (50 % and more)"};
constexpr std::array<std::string_view, 3> levels{"low", "medium", "high"};
constexpr int unstated_grade = 3;

/// The worse of all that tasks say of a cause, by whom it harms.
std::optional<Consequence> worse_of(std::span<const Consequence> all, RiskCause cause) {
  std::optional<Consequence> out;
  for (const Consequence& one : all) {
    if (one.cause != cause) continue;
    if (!out) out = one;
    for (std::size_t i = 0; i < harmed_count; ++i)
      out->grade[i] = std::max(out->grade[i], one.grade[i]);
  }
  return out;
}

}  // namespace

Likelihood likelihood_of(double probability) noexcept {
  const auto at = std::upper_bound(below.begin(), below.end(), probability);
  return static_cast<Likelihood>(at - below.begin());
}

std::string_view text_of(Likelihood likelihood) noexcept {
  return likelihoods[static_cast<std::size_t>(likelihood)];
}

RiskLevel level_of(Likelihood likelihood, int worst_grade) noexcept {
  const int product = (static_cast<int>(likelihood) + 1) * worst_grade;
  return product < 6 ? RiskLevel::low : product < 15 ? RiskLevel::medium : RiskLevel::high;
}

std::string_view name_of(RiskLevel level) noexcept {
  return levels[static_cast<std::size_t>(level)];
}

std::vector<RiskEntry> risk_register(std::span<const RiskCauses> flights,
                                     std::span<const Consequence> consequences, double level) {
  std::vector<RiskEntry> out;
  for (std::size_t i = 0; i < risk_cause_count; ++i) {
    RiskEntry entry;
    entry.cause = static_cast<RiskCause>(i);
    entry.flights = flights.size();
    entry.befell = static_cast<std::size_t>(
        std::count_if(flights.begin(), flights.end(),
                      [&](const RiskCauses& befell) { return befell.has(entry.cause); }));
    entry.probability = success_interval(entry.befell, entry.flights, level);
    entry.consequence = worse_of(consequences, entry.cause);
    const int grade = entry.consequence ? entry.consequence->worst_grade() : unstated_grade;
    entry.level = level_of(likelihood_of(entry.share()), grade);
    entry.at_worst = level_of(likelihood_of(entry.probability.high), grade);
    out.push_back(std::move(entry));
  }
  const auto gravity = [](const RiskEntry& entry) {
    const int grade = entry.consequence ? entry.consequence->worst_grade() : unstated_grade;
    return std::tuple(entry.level, entry.at_worst, entry.share(), grade);
  };
  std::stable_sort(out.begin(), out.end(),
                   [&](const RiskEntry& a, const RiskEntry& b) { return gravity(a) > gravity(b); });
  return out;
}

}  // namespace slackwater::twin
