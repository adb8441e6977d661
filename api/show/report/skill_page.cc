#include "api/show/report/skill_page.h"

#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "api/show/report/assets.h"
#include "fields/base/check.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

json line_json(const SkillLine& line) {
  const std::size_t leads = line.lead_h.size();
  expects(line.rmse_m_s.size() == leads && line.low_m_s.size() == leads &&
              line.high_m_s.size() == leads,
          "a line of skill has an error and an interval for every hour of lead");
  return {{"method", line.method},
          {"lead", numbers(line.lead_h)},
          {"rmse", numbers(line.rmse_m_s)},
          {"low", numbers(line.low_m_s)},
          {"high", numbers(line.high_m_s)}};
}

json track_json(const SkillTrack& track) {
  const std::size_t cells = track.time.size() * track.depth_m.size();
  const std::size_t drawn = track.time.size() * track.drawn_depth_m.size();
  expects(track.misfit_m_s.size() == cells, "a misfit for every time and depth");
  expects(track.forecast_m_s.size() == drawn && track.truth_m_s.size() == drawn,
          "forecast and truth at every time and drawn depth");
  return {{"label", track.label},
          {"time", times(track.time)},
          {"depth", numbers(track.depth_m)},
          {"bed", number(track.water_depth_m)},
          {"misfit", numbers(track.misfit_m_s)},
          {"drawn", numbers(track.drawn_depth_m)},
          {"forecast", vectors(track.forecast_m_s)},
          {"truth", vectors(track.truth_m_s)}};
}

json policy_json(const SkillPolicy& policy) {
  expects(policy.below.size() == policy.probability.size(), "a share for every quantile");
  expects(
      policy.pooled_misfit_m_s.size() == policy.pooled_lead_h.size() * policy.pooled_depth_m.size(),
      "a pooled misfit for every hour and depth");
  json lines = json::array();
  for (const SkillLine& line : policy.by_lead) lines.push_back(line_json(line));
  json tracks = json::array();
  for (const SkillTrack& track : policy.tracks) tracks.push_back(track_json(track));
  return {{"wind", policy.wind},
          {"lines", lines},
          {"probability", numbers(policy.probability)},
          {"below", numbers(policy.below)},
          {"pit", numbers(policy.pit)},
          {"pooled",
           {{"lead", numbers(policy.pooled_lead_h)},
            {"depth", numbers(policy.pooled_depth_m)},
            {"bed", number(policy.water_depth_m)},
            {"misfit", numbers(policy.pooled_misfit_m_s)}}},
          {"tracks", tracks}};
}

std::string data_json(const SkillPage& page) {
  json policies = json::array();
  for (const SkillPolicy& policy : page.policies) policies.push_back(policy_json(policy));
  return script_safe({{"policies", policies}});
}

std::string choice_html(const std::string& id, const std::string& label) {
  return "<p class=\"control\"><label for=\"" + id + "\">" + label + "</label> <select id=\"" + id +
         "\"></select></p>";
}

/// A section with two square charts side by side.
std::string squares_html(const std::string& title, const std::vector<std::string>& ids,
                         const std::string& note) {
  std::string out =
      "<section class=\"plot\"><h2>" + escaped_html(title) + "</h2><div class=\"pair\">";
  for (const std::string& id : ids) {
    out += "<div id=\"" + id + "\" class=\"chart square\" role=\"img\" aria-label=\"" +
           escaped_html(title) + "\"></div>";
  }
  return out + "</div><p class=\"note\">" + escaped_html(note) + "</p></section>\n";
}

std::string plots_html(const SkillPage& page) {
  std::string out = choice_html("policy", "Wind beyond day D");
  out += plot_html(
      "skill-by-lead", "Skill by lead: forecast and baselines",
      "Root mean square vector error (m/s) over all levels, columns and pairs of days, "
      "by hours after the end of day D; lower is better. Shaded: 95 % interval of the "
      "forecast from blocks of neighbouring pairs, none for fewer than five. A baseline "
      "\"in part\" has fewer days or values than the forecast: its line compares with the "
      "line \"forecast beside\" it. oracle-mean knows the forecast day itself: a "
      "yardstick, not a forecast.");
  out +=
      squares_html("Reliability of the spread", {"reliability", "pit"},
                   "Left: how often the truth fell below the forecast's quantiles, east and "
                   "north pooled; a spread of the right size lies on the diagonal. Right: share of "
                   "truths in each tenth of the forecast distribution; ideal is flat at 10 %. High "
                   "in the middle: the spread is too wide; high at both ends: too narrow.");
  out += choice_html("track", "Forecast of day D");
  out += squares_html("Hodographs: forecast against truth",
                      {"hodograph-0", "hodograph-1", "hodograph-2", "hodograph-3"},
                      "The tip of the current vector through the hours of the forecast, at " +
                          page.place +
                          ", seen from above: right is east, up is north, m/s. Solid: forecast; "
                          "dashed: truth. Labels are hours after the end of day D; the ring is the "
                          "first hour.");
  out += plot_html("misfit", "Misfit over time and depth",
                   "Colour: root mean square vector error of the chosen forecast over columns "
                   "(m/s). Depth is counted from mean sea level down to the bed; valid times are "
                   "UTC.");
  out += plot_html("pooled-misfit", "Misfit by lead and depth, all forecasts",
                   "Colour: root mean square vector error over columns and forecasts (m/s).");
  return out;
}

}  // namespace

std::string skill_page_html(const SkillPage& page) {
  return skill_page_html(page, report_plotting_library());
}

std::string skill_page_html(const SkillPage& page, std::string_view plotting_library) {
  HtmlPage html;
  html.title = page.title;
  html.site = page.site;
  html.headline = page.headline;
  if (page.beaten) html.alarm = "The forecast does not beat its best baseline.";
  html.facts = page.facts;
  html.data_json = data_json(page);
  if (!page.policies.empty()) html.plots_html = plots_html(page);
  for (const ReportTable& table : page.tables) html.tables_html += table_html(table);
  html.attributions = page.attributions;
  html.generated = page.generated;
  html.script = skill_script();
  return page_html(html, plotting_library);
}

void write_skill_page(const SkillPage& page, const std::filesystem::path& file) {
  write_page(skill_page_html(page), file);
}

}  // namespace slackwater::api
