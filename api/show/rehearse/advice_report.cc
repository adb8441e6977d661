#include "api/show/rehearse/advice_report.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "api/json/plot_json.h"
#include "api/show/report/html_page.h"
#include "fields/base/text.h"

namespace slackwater::api {

nlohmann::json advice_json(const std::vector<Advice>& advice) {
  using nlohmann::json;
  json out = json::array();
  for (const Advice& one : advice) {
    json entry{{"what", one.what}};
    if (!one.impossible.empty()) {
      entry["impossible"] = one.impossible;
    } else {
      entry["flights"] = one.flights;
      entry["done"] = one.done;
      entry["done_as_is"] = one.done_as_is;
      entry["gained"] = one.gained;
      entry["lost"] = one.lost;
      entry["interval_95"] = {number(one.low), number(one.high)};
    }
    out.push_back(std::move(entry));
  }
  return out;
}

std::string text_of(const Advice& advice) {
  if (!advice.impossible.empty()) return advice.what + ": not possible, " + advice.impossible;
  return advice.what + formatted(": {} of {} succeed instead of {}", advice.done, advice.flights,
                                 advice.done_as_is);
}

std::string advice_table_html(const std::string& title, const std::vector<Advice>& advice) {
  if (advice.empty()) return "";
  ReportTable table;
  table.title = title;
  table.note =
      "The same futures, one thing changed. Success: done, and where something is asked to be "
      "seen, seen. Gained and lost: futures that succeed only with the change, or only without it.";
  table.columns = {"Change", "Success", "Instead of", "Gained", "Lost"};
  for (const Advice& one : advice) {
    if (!one.impossible.empty()) {
      table.rows.push_back({one.what, "not possible: " + one.impossible, "-", "-", "-"});
      continue;
    }
    table.rows.push_back({one.what, formatted("{} of {}", one.done, one.flights),
                          formatted("{}", one.done_as_is), formatted("{}", one.gained),
                          formatted("{}", one.lost)});
  }
  return table_html(table);
}

}  // namespace slackwater::api
