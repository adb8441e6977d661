#include "twin/risk/alpha_factor.h"

#include <algorithm>

#include "fields/base/numbers/ascends.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

LimitVariable variable_of(const Config& config) {
  const std::string key = config.text("variable");
  std::vector<std::string> keys;
  for (const LimitWord& word : limit_words()) {
    if (key == word.key) return word.variable;
    keys.emplace_back(word.key);
  }
  config.refuse("variable", "found " + key + ", expected one of " + joined(keys, ", "));
}

}  // namespace

AlphaFactor AlphaTable::at(double period_h, double limit) const {
  const char* unit = word_of(variable).unit;
  if (limit < limits.front())
    return {
        {},
        formatted("the table has no factor for limits below {:g} {}: judge such a limit by itself",
                  limits.front(), unit)};
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const Row& one) { return period_h <= one.period_h; });
  if (row == rows.end())
    return {{},
            formatted(
                "the task ends {:.0f} h after the forecast was issued; the table goes up to {:g} h",
                period_h, rows.back().period_h)};
  std::size_t i = 0;
  while (i + 1 < limits.size() && limits[i + 1] <= limit) ++i;
  if (i + 1 == limits.size()) return {row->factor.back(), ""};
  const double share = (limit - limits[i]) / (limits[i + 1] - limits[i]);
  return {row->factor[i] + share * (row->factor[i + 1] - row->factor[i]), ""};
}

AlphaTable read_alpha_table(const Config& config) {
  AlphaTable table;
  table.name = config.text("name");
  table.source = config.text("source");
  table.status = config.optional_text("status").value_or("");
  table.variable = variable_of(config);
  table.limits = config.numbers("limits", word_of(table.variable).range);
  if (table.limits.empty() || !ascends(table.limits))
    config.refuse("limits", "expected one limit or more, ascending");
  for (const Config& entry : config.children("rows")) {
    AlphaTable::Row row;
    row.period_h = entry.number("up_to_h", {0.1, 240});
    row.factor = entry.numbers("alpha", {0.01, 1});
    if (row.factor.size() != table.limits.size())
      entry.refuse("alpha", formatted("found {} factors, expected {}, one for each of `limits`",
                                      row.factor.size(), table.limits.size()));
    if (!table.rows.empty() && row.period_h <= table.rows.back().period_h)
      entry.refuse("up_to_h", "rows ascend with the period; found one that does not");
    table.rows.push_back(std::move(row));
  }
  if (table.rows.empty()) config.refuse("rows", "missing; give one row or more");
  config.expect_all_read();
  return table;
}

}  // namespace slackwater::twin
