#include <algorithm>
#include <vector>

#include "fields/base/advice.h"
#include "fields/base/text.h"
#include "twin/inspection/defect/defect_facts.h"

namespace slackwater::twin {
namespace {

PotentialRule read_potential(const Config& c) {
  PotentialRule rule;
  constexpr Range potentials{-1600, 0};
  rule.fresh_mv = c.number("fresh_mv", potentials);
  rule.limit_mv = c.number("limit_mv", potentials);
  rule.bare_mv = c.number("bare_mv", potentials);
  rule.utilisation = c.number("utilisation", {0.1, 0.99});
  (void)c.text("source");
  (void)c.text("status");
  if (!(rule.fresh_mv < rule.limit_mv && rule.limit_mv < rule.bare_mv))
    c.refuse("limit_mv", formatted("found {:g} mV, expected it between fresh_mv, {:g}, and "
                                   "bare_mv, {:g}",
                                   rule.limit_mv, rule.fresh_mv, rule.bare_mv));
  return rule;
}

}  // namespace

const char* severity_key_of(DefectKind kind) noexcept {
  return severity_unit_of(kind) == SeverityUnit::share ? "severity_share" : "severity_m";
}

double most_severity_of(DefectKind kind) noexcept {
  return severity_unit_of(kind) == SeverityUnit::share ? 1 : 50;
}

Range read_span(const Config& config, const char* key, double most) {
  const std::vector<double> ends = config.numbers(key, {0, most});
  if (ends.empty() || ends.size() > 2)
    config.refuse(
        key, formatted("found {} numbers, expected one, or two: from what to what", ends.size()));
  const Range span{ends.front(), ends.back()};
  if (!(span.low > 0)) config.refuse(key, "found 0, expected more than 0");
  if (span.high < span.low)
    config.refuse(
        key, formatted("goes from {:g} to {:g}; give the smaller one first", span.low, span.high));
  return span;
}

DefectKind read_defect_kind(const Config& config) {
  const std::string word = config.text("kind");
  if (const auto kind = defect_kind_named(word)) return *kind;
  std::vector<std::string> known;
  for (const DefectKind kind : all_defect_kinds()) known.emplace_back(name_of(kind));
  config.refuse("kind", "found " + word + did_you_mean(word, known) + ", expected one of " +
                            joined(known, ", "));
}

DefectFacts read_defect_facts(const Config& config) {
  DefectFacts facts;
  std::array<bool, defect_kinds> has{};
  for (const Config& entry : config.children("kinds")) {
    const DefectKind kind = read_defect_kind(entry);
    const auto i = static_cast<std::size_t>(kind);
    if (has[i]) entry.refuse("kind", formatted("{} stands here twice", name_of(kind)));
    has[i] = true;
    DefectFacts::OfKind& of = facts.kinds[i];
    of.size_m = read_span(entry, "size_m", most_defect_size_m);
    of.severity = read_span(entry, severity_key_of(kind), most_severity_of(kind));
    of.up_to_height_m =
        entry.optional_number("up_to_height_m", {-1000, 500}).value_or(of.up_to_height_m);
    of.from_top_m = entry.optional_number("from_top_m", {0, 500}).value_or(of.from_top_m);
    of.source = entry.text("source");
    of.status = entry.text("status");
  }
  for (const DefectKind kind : all_defect_kinds())
    if (!has[static_cast<std::size_t>(kind)])
      config.refuse("kinds",
                    formatted("has nothing on {}; each kind needs its ranges", name_of(kind)));
  const Config fresh = config.child("when_new");
  facts.wall_m = fresh.number("wall_m", {0.001, 1});
  facts.burial_m = fresh.number("burial_m", {0, 20});
  facts.chain_diameter_m = fresh.number("chain_diameter_m", {0.01, 0.5});
  (void)fresh.text("source");
  (void)fresh.text("status");
  facts.potential = read_potential(config.child("potential"));
  config.expect_all_read();
  return facts;
}

double potential_mv(const PotentialRule& rule, double depletion) noexcept {
  const double x = std::clamp(depletion, 0.0, 1.0), u = rule.utilisation;
  if (x <= u) return rule.fresh_mv + (rule.limit_mv - rule.fresh_mv) * x / u;
  return rule.limit_mv + (rule.bare_mv - rule.limit_mv) * (x - u) / (1 - u);
}

double depletion_of(const PotentialRule& rule, double mv) noexcept {
  const double u = rule.utilisation;
  const double x = mv <= rule.limit_mv
                       ? u * (mv - rule.fresh_mv) / (rule.limit_mv - rule.fresh_mv)
                       : u + (1 - u) * (mv - rule.limit_mv) / (rule.bare_mv - rule.limit_mv);
  return std::clamp(x, 0.0, 1.0);
}

}  // namespace slackwater::twin
