#include "api/show/decisions/decisions_csv.h"

#include "fields/base/encode/csv.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

std::string row_of(const DecisionAnswer& one) {
  const store::DecisionRow& row = one.row;
  const WhatCame& what = one.what;
  const auto yes = [](bool is_so) { return std::string(is_so ? "yes" : "no"); };
  return joined(std::vector<std::string>{std::to_string(row.id),
                                         csv_cell(row.site_id),
                                         csv_cell_of_people(row.task),
                                         csv_cell_of_people(row.turbine),
                                         format_utc(row.start),
                                         row.work ? csv_cell(hours_of(*row.work)) : "",
                                         std::string(name_of(row.decided)),
                                         csv_cell_of_people(row.by),
                                         format_utc(row.recorded_at),
                                         row.by_clock ? "clock" : "stated",
                                         yes(one.is_late),
                                         yes(one.counts),
                                         std::to_string(row.forecast),
                                         row.forecast_sha256,
                                         format_utc(row.forecast_issued),
                                         row.probability ? csv_cell(*row.probability) : "",
                                         row.verdict,
                                         csv_cell(row.unsaid),
                                         std::string(name_of(what.came)),
                                         csv_cell(what.broken),
                                         what.broken_at ? format_utc(*what.broken_at) : "",
                                         csv_cell(what.why),
                                         csv_cell(joined(what.not_checked, "; ")),
                                         csv_cell_of_people(row.note),
                                         csv_cell_of_people(row.hand_over)},
                ",");
}

}  // namespace

std::string decisions_csv(const DecisionsAnswer& answer) {
  std::string text =
      "id,site,task,turbine,start,work_h,decided,by,recorded_at,recorded_by,late,counts,"
      "forecast_id,forecast_sha256,forecast_issued,probability,verdict,why_nothing_said,came,"
      "broken,broken_at,why_not_known,not_checked,note,hand_over\n";
  for (const DecisionAnswer& one : answer.decisions) text += row_of(one) + "\n";
  return text;
}

}  // namespace slackwater::api
