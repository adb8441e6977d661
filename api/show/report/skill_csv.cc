#include "api/show/report/skill_csv.h"

#include <optional>

#include "fields/base/encode/csv.h"

namespace slackwater::api {
namespace {

using calibration::SkillEntry;

constexpr const char* head =
    "site,column,variable,day,issued,origin,wind,method,truth,depth_from_m,depth_to_m,"
    "height_above_bed_from_m,height_above_bed_to_m,lead_from_h,lead_to_h,n,unit,rmse,"
    "forecast_rmse,rmse_95_low,rmse_95_high,bias,bias_east,bias_north,speed_bias,mae,scatter_index,"
    "direction_mae_deg,"
    "correlation_abs,correlation_deg,crps,coverage_80\n";

/// One line, cell by cell.
class Line {
 public:
  Line& text(std::string_view value) { return add(csv_cell(value)); }
  Line& number(const std::optional<double>& value) {
    return add(value ? csv_cell(*value) : std::string());
  }
  [[nodiscard]] const std::string& str() const noexcept { return line_; }

 private:
  Line& add(const std::string& cell) {
    if (has_cells_) line_ += ',';
    has_cells_ = true;
    line_ += cell;
    return *this;
  }
  std::string line_;
  bool has_cells_ = false;
};

void add_score(Line& line, const SkillEntry& e) {
  const auto nothing = std::optional<double>();
  if (e.scalar) {
    const calibration::ScalarScore& s = *e.scalar;
    line.text(std::to_string(s.n)).text(calibration::unit_of(e.variable)).number(s.rmse);
    line.number(e.forecast_rmse);
    line.number(e.interval ? std::optional(e.interval->low) : nothing);
    line.number(e.interval ? std::optional(e.interval->high) : nothing);
    line.number(s.bias).number(nothing).number(nothing).number(nothing);
    line.number(s.mae).number(s.scatter_index);
    for (int i = 0; i < 5; ++i) line.number(nothing);
    return;
  }
  const calibration::VectorScore& v = e.vector;
  line.text(std::to_string(v.n)).text(calibration::unit_of(e.variable)).number(v.rmse_m_s);
  line.number(e.forecast_rmse);
  line.number(e.interval ? std::optional(e.interval->low) : nothing);
  line.number(e.interval ? std::optional(e.interval->high) : nothing);
  line.number(nothing).number(v.bias_east_m_s).number(v.bias_north_m_s).number(v.speed_bias_m_s);
  line.number(nothing).number(nothing).number(v.direction_mae_deg);
  line.number(v.correlation_abs).number(v.correlation_deg).number(v.crps_m_s);
  line.number(v.coverage_80);
}

std::string line_of(const SkillEntry& e) {
  const auto nothing = std::optional<double>();
  Line line;
  line.text(e.site).text(e.column ? std::to_string(*e.column) : std::string());
  line.text(e.variable).text(format_day(e.day)).text(format_utc(e.issued)).text(name_of(e.origin));
  line.text(name_of(e.wind)).text(name_of(e.method)).text(e.truth);
  for (const bool above_bed : {false, true}) {
    const bool is_here = e.band && e.band->above_bed == above_bed;
    line.number(is_here ? std::optional(e.band->from_m) : nothing);
    line.number(is_here ? std::optional(e.band->to_m) : nothing);
  }
  line.number(e.lead.from_h).number(e.lead.to_h);
  add_score(line, e);
  return line.str();
}

}  // namespace

std::string skill_csv(const std::vector<SkillEntry>& entries) {
  std::string text = head;
  for (const SkillEntry& entry : entries) text += line_of(entry) + "\n";
  return text;
}

}  // namespace slackwater::api
