#include "api/show/rehearse/risk_report.h"

#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "api/show/report/html_page.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using twin::Harmed;
using twin::RiskEntry;

std::string harm_text(const RiskEntry& risk) {
  if (!risk.consequence) return "nobody says how bad";
  const twin::Consequence& harm = *risk.consequence;
  return formatted("{} {} of 5", name_of(harm.worst()), harm.worst_grade());
}

std::string share_text(const RiskEntry& risk) {
  return formatted("{} of {} ({:.0f} to {:.0f} %)", risk.befell, risk.flights,
                   100 * risk.probability.low, 100 * risk.probability.high);
}

json consequence_json(const twin::Consequence& consequence) {
  json out = json::object();
  for (std::size_t i = 0; i < twin::harmed_count; ++i)
    out[std::string(name_of(static_cast<Harmed>(i)))] = consequence.grade[i];
  out["status"] = consequence.status;
  out["source"] = consequence.source.empty() ? json(nullptr) : json(consequence.source);
  return out;
}

}  // namespace

json risks_json(const std::vector<RiskEntry>& risks) {
  json out = json::array();
  for (const RiskEntry& risk : risks)
    out.push_back({{"cause", name_of(risk.cause)},
                   {"meaning", meaning_of(risk.cause)},
                   {"flights", risk.flights},
                   {"befell", risk.befell},
                   {"probability", number(risk.share())},
                   {"interval_95", {number(risk.probability.low), number(risk.probability.high)}},
                   {"likelihood", likelihood_text(risk)},
                   {"consequence", risk.consequence ? consequence_json(*risk.consequence) : json()},
                   {"level_at_least", name_of(risk.at_least)},
                   {"level_at_worst", name_of(risk.at_worst)}});
  return out;
}

std::vector<std::string> risk_texts(const std::vector<RiskEntry>& risks) {
  std::vector<std::string> texts;
  for (const RiskEntry& risk : risks) {
    if (risk.befell == 0) continue;
    texts.push_back(std::string(meaning_of(risk.cause)) + ": " + share_text(risk) + ", " +
                    harm_text(risk) + ": " + level_text(risk));
  }
  return texts;
}

std::vector<std::string> risk_cells(const RiskEntry& risk) {
  return {std::string(meaning_of(risk.cause)), share_text(risk), likelihood_text(risk),
          harm_text(risk), level_text(risk)};
}

std::string risk_table_html(const std::string& title, const std::vector<RiskEntry>& risks) {
  if (risks.empty()) return "";
  ReportTable table;
  table.title = title;
  table.note =
      "How often in the futures flown, with bounds that hold at 95 %; how bad it would be, from 1 "
      "(slight) to 5 (grave), as the task says it: estimates, unless replaced by your own "
      "register. "
      "Likelihood class times the worst class: below 6 low, below 15 medium, else high. Where the "
      "flights leave more than one class open, the first and the last of them.";
  table.columns = {"Cause", "Befell", "Likelihood", "Worst harm", "Risk"};
  for (const RiskEntry& risk : risks) table.rows.push_back(risk_cells(risk));
  return table_html(table);
}

}  // namespace slackwater::api
