#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api/show/report/html_page.h"
#include "api/show/report/slack.h"
#include "fields/base/frame.h"
#include "fields/base/local_time.h"
#include "fields/base/time.h"

namespace slackwater::api {

/// The forecast current over time and depth, with the truth beside it where it is known (the
/// demonstration). NaN where there is no value. Depths of 1 to 2 m apart give a smooth picture.
struct ReportProfile {
  std::vector<UtcTime> time;              ///< ascending
  std::vector<double> depth_m;            ///< ascending, below mean sea level
  double water_depth_m = 0;               ///< the bed, drawn as a line
  std::vector<Horizontal> current_m_s;    ///< time x depth, depth fastest; towards
  std::vector<double> sigma_m_s;          ///< same shape, of each component; may be empty
  std::vector<Horizontal> truth_m_s;      ///< same shape; may be empty
  std::optional<UtcTime> hodograph_time;  ///< the hour the hodograph opens with; else the middle
};

/// The skill of one method over one range of leads.
struct ReportSkill {
  std::string method;   ///< "forecast", "persistence", ...
  std::string lead;     ///< "0-24 h"; rows of one lead stand together in the order given
  double rmse_m_s = 0;  ///< of the vector
  std::optional<std::pair<double, double>> interval_95_m_s;
};

/// One line of a series panel.
struct ReportLine {
  std::string name;            ///< "forecast", "truth"
  std::vector<double> values;  ///< per time; NaN where none
  std::vector<double> low;     ///< lower edge of the band (10 %); may be empty
  std::vector<double> high;    ///< upper edge (90 %)
  bool is_truth = false;       ///< drawn dashed, above the others
};

/// A panel of lines over the same times, e.g. wind speed.
struct ReportSeries {
  std::string title;  ///< "Wind at 10 m"
  std::string axis;   ///< with its unit: "speed (m/s)"
  std::vector<ReportLine> lines;
  std::vector<double> towards_deg;  ///< arrows above the panel, clockwise from north; may be empty
};

/// The speed of the current at one depth, with its band, and when it is slack.
struct ReportSpeedAtDepth {
  std::string label;                ///< "10 m"
  std::vector<double> low_m_s;      ///< 10 %, per time; NaN where none
  std::vector<double> likely_m_s;   ///< median
  std::vector<double> high_m_s;     ///< 90 %
  std::vector<double> towards_deg;  ///< clockwise from north, per time
  std::vector<SlackWindow> slack;
  ReportTable slack_table;  ///< the same in words, a row each; the tables of all depths have the
                            ///< same columns
};

/// What is read first: the speed at a depth that the reader chooses.
struct ReportSpeed {
  std::vector<UtcTime> time;
  std::vector<ReportSpeedAtDepth> depths;  ///< at least one
  std::size_t first = 0;                   ///< of `depths`: shown until another is chosen
  double slack_below_m_s = 0.5;
  /// Why nothing is said of slack and of the tide; empty: something is.
  std::string no_tide;
};

/// Everything the page shows. Plain data: the page computes nothing but the depth mean of the
/// hodograph.
struct ReportInput {
  std::string title;     ///< "Current forecast for Saint-Brieuc"
  std::string site;      ///< "48.850 N 2.550 W, 35 m of water"
  std::string headline;  ///< the sentence a coordinator reads first
  bool degraded = false;
  std::vector<std::pair<std::string, std::string>>
      facts;                               ///< ("Issued", "2025-03-10 05:00 UTC"), ...
  std::string time_zone;                   ///< its name: local time beside UTC; may be empty
  std::vector<ClockChange> clock_changes;  ///< of that zone over the page's times
  std::optional<UtcTime> issued;  ///< drawn as a vertical line where it falls into the plots
  std::string decisions_html;     ///< before the answer, escaped already; may be empty
  std::string answer_title;       ///< "At 10 m on 2025-03-11 (UTC)"; empty: no answer
  std::vector<std::pair<std::string, std::string>> answer;  ///< ("Strongest", "0.82 m/s ..."), ...
  std::optional<ReportSpeed> speed;
  std::optional<ReportProfile> profile;
  std::vector<ReportSkill> skill;
  std::string skill_note;            ///< what was scored against what
  std::vector<UtcTime> series_time;  ///< of all series
  std::vector<ReportSeries> series;
  std::string series_note;       ///< what lines and bands are; empty: the page's own words
  std::string after_plots_html;  ///< before the tables, escaped already; may be empty
  std::vector<ReportTable> tables;
  std::string folded_title;         ///< of the part that is folded away
  std::vector<ReportTable> folded;  ///< its tables; none: no such part
  std::vector<std::string> attributions;
  std::string generated;  ///< "2025-03-10 05:00:12 UTC by slackwater 0.1.0"
};

/// The page as one HTML text that opens with no network: styles, data and the plotting library are
/// inside. Where the library was not at hand when the program was built, the page says so in a
/// sentence and shows the tables and a table of the profile instead. All text is escaped. Throws
/// ContractViolation if arrays do not fit each other.
[[nodiscard]] std::string report_html(const ReportInput& input);
/// The same with this text as the plotting library; empty: the page without plots.
[[nodiscard]] std::string report_html(const ReportInput& input, std::string_view plotting_library);

/// Writes the page to `file` (through a neighbouring temporary file, so that a reader never sees
/// half a page). Throws Error(unavailable) where it cannot be written.
void write_report(const ReportInput& input, const std::filesystem::path& file);

}  // namespace slackwater::api
