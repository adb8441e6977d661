#include "twin/risk/risk_register.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace slackwater::twin {
namespace {

constexpr std::array below{0.01, 0.05, 0.2, 0.5};
struct LikelihoodWords {
  std::string_view name;
  std::string_view range;
};
constexpr std::array<LikelihoodWords, 5> likelihoods{{{"rare", "below 1 %"},
                                                      {"unlikely", "1 to 5 %"},
                                                      {"possible", "5 to 20 %"},
                                                      {"likely", "20 to 50 %"},
                                                      {"expected", "50 % and more"}}};
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

RiskLevel level_of(Likelihood likelihood, int worst_grade) noexcept {
  const int product = (static_cast<int>(likelihood) + 1) * worst_grade;
  return product < 6 ? RiskLevel::low : product < 15 ? RiskLevel::medium : RiskLevel::high;
}

std::string_view name_of(RiskLevel level) noexcept {
  return levels[static_cast<std::size_t>(level)];
}

std::string likelihood_text(const RiskEntry& entry) {
  const auto words = [](double probability) -> const LikelihoodWords& {
    return likelihoods[static_cast<std::size_t>(likelihood_of(probability))];
  };
  const LikelihoodWords& low = words(entry.probability.low);
  const LikelihoodWords& high = words(entry.probability.high);
  if (&low == &high) return std::string(low.name) + " (" + std::string(low.range) + ")";
  return std::string(low.name) + " to " + std::string(high.name);
}

std::string level_text(const RiskEntry& entry) {
  std::string text(name_of(entry.at_least));
  if (entry.at_worst != entry.at_least) text += " to " + std::string(name_of(entry.at_worst));
  return text;
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
    entry.at_least = level_of(likelihood_of(entry.probability.low), grade);
    entry.at_worst = level_of(likelihood_of(entry.probability.high), grade);
    out.push_back(std::move(entry));
  }
  const auto gravity = [](const RiskEntry& entry) {
    const int grade = entry.consequence ? entry.consequence->worst_grade() : unstated_grade;
    return std::tuple(entry.at_least, entry.at_worst, entry.share(), grade);
  };
  std::stable_sort(out.begin(), out.end(),
                   [&](const RiskEntry& a, const RiskEntry& b) { return gravity(a) > gravity(b); });
  return out;
}

}  // namespace slackwater::twin
