#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api/show/report/html_page.h"
#include "fields/base/frame.h"
#include "fields/base/time.h"

namespace slackwater::api {

/// The error of one method by hour of lead.
struct SkillLine {
  std::string method;
  std::vector<double> lead_h;    ///< the end of each hour
  std::vector<double> rmse_m_s;  ///< of the vector
  std::vector<double> low_m_s;   ///< ends of the 95 % interval; NaN where there is none
  std::vector<double> high_m_s;
};

/// One forecast against the truth.
struct SkillTrack {
  std::string label;            ///< "2024-01-17, issued 2024-01-18 05:00 UTC"
  std::vector<UtcTime> time;    ///< valid times
  std::vector<double> depth_m;  ///< levels of the misfit
  double water_depth_m = 0;     ///< the bed, to which the misfit is drawn; 0: not known
  /// Root mean square vector error over columns, time x depth, depth fastest; NaN where none.
  std::vector<double> misfit_m_s;
  std::vector<double> drawn_depth_m;     ///< the depths of the hodographs, at most four
  std::vector<Horizontal> forecast_m_s;  ///< time x drawn depth; NaN where there is no value
  std::vector<Horizontal> truth_m_s;
};

/// All that was scored under one wind policy.
struct SkillPolicy {
  std::string wind;
  std::vector<SkillLine> by_lead;      ///< the forecast first
  std::vector<double> probability;     ///< of the reliability diagram; empty without a spread
  std::vector<double> below;           ///< share of truths below each quantile
  std::vector<double> pit;             ///< share of truths in each equal part of the distribution
  std::vector<double> pooled_lead_h;   ///< hours of the pooled misfit
  std::vector<double> pooled_depth_m;  ///< its levels
  std::vector<double> pooled_misfit_m_s;  ///< hour x depth; NaN where none
  double water_depth_m = 0;               ///< the deepest bed of the tracks
  std::vector<SkillTrack> tracks;
};

/// Everything the page of `verify --html` shows; the page computes nothing.
struct SkillPage {
  std::string title;
  std::string site;
  std::string headline;
  bool beaten = false;  ///< a baseline is better than the forecast: said in bold
  std::vector<std::pair<std::string, std::string>> facts;
  std::string place;  ///< of the hodographs: "47.000 N 5.000 W"
  std::vector<SkillPolicy> policies;
  std::vector<ReportTable> tables;
  std::vector<std::string> attributions;
  std::string generated;
};

/// The page as one HTML text that opens with no network. Throws ContractViolation if arrays do not
/// fit each other.
[[nodiscard]] std::string skill_page_html(const SkillPage& page);
/// The same with this text as the plotting library; empty: the page without plots.
[[nodiscard]] std::string skill_page_html(const SkillPage& page, std::string_view plotting_library);

/// Throws Error(unavailable) where it cannot be written.
void write_skill_page(const SkillPage& page, const std::filesystem::path& file);

}  // namespace slackwater::api
