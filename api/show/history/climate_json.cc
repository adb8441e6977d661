#include <cmath>
#include <nlohmann/json.hpp>

#include "api/show/history/climate_answer.h"
#include "api/show/history/workability_answer.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

json null_or_text(const std::string& text) { return text.empty() ? json(nullptr) : json(text); }

/// `{from, below}` of each class; the first begins at 0, the last has no end.
json classes_json(const std::vector<double>& edges) {
  json classes = json::array();
  for (std::size_t c = 0; c <= edges.size(); ++c)
    classes.push_back({{"from", c == 0 ? 0.0 : edges[c - 1]},
                       {"below", c == edges.size() ? json(nullptr) : json(edges[c])}});
  return classes;
}

json rose_json(const ClimateKind& kind, const ClimateRose& rose, const History& history) {
  const twin::Rose& counts = rose.counts;
  const std::size_t known = counts.known();
  json sectors = json::array();
  for (std::size_t s = 0; s < counts.sectors.size(); ++s) {
    json by_class = json::array();
    for (const std::size_t steps : counts.sectors[s]) by_class.push_back(share_of(steps, known));
    sectors.push_back({{"middle_deg", middle_deg(s, counts.sectors.size())},
                       {"share", share_of(counts.in_sector(s), known)},
                       {"by_class", std::move(by_class)}});
  }
  return {{"way", kind.way},
          {"direction_standard_name", kind.direction_name},
          {"direction_series", history.series[rose.direction].name},
          {"unit", rose.edges.unit},
          {"classes", classes_json(rose.edges.values)},
          {"sectors", std::move(sectors)},
          {"calm",
           {{"below", rose.calm.values.front()},
            {"unit", rose.calm.unit},
            {"share", share_of(counts.calm, known)}}},
          {"no_direction_share", share_of(counts.no_direction, known)},
          {"known_steps", known},
          {"missing_steps", counts.missing}};
}

const char* reason_of(twin::ReturnSupport support) {
  switch (support) {
    case twin::ReturnSupport::beyond_history:
      return "beyond_history";
    case twin::ReturnSupport::below_threshold:
      return "below_threshold";
    case twin::ReturnSupport::below_year:
      return "below_year";
    case twin::ReturnSupport::no_good_fit:
      return "no_good_fit";
    case twin::ReturnSupport::supported:
      break;
  }
  return "supported";
}

json returns_json(const std::vector<twin::ReturnValue>& returns) {
  json found = json::array();
  for (const twin::ReturnValue& one : returns) {
    const bool is_told = one.support == twin::ReturnSupport::supported;
    found.push_back(
        {{"years", one.years},
         {"support", reason_of(one.support)},
         {"value", is_told ? json(one.value) : json(nullptr)},
         {"interval_90", is_told ? json{one.interval.low, one.interval.high} : json(nullptr)}});
  }
  return found;
}

json peaks_json(const twin::PeaksFit& peaks) {
  const double most = peaks.upper_end();
  return {{"threshold", peaks.threshold},
          {"storms", peaks.storms},
          {"storms_per_year", peaks.storms_per_year},
          {"scale", peaks.fit.scale},
          {"shape", peaks.fit.shape},
          {"shape_interval_90", {peaks.shape.low, peaks.shape.high}},
          {"upper_end", std::isfinite(most) ? json(most) : json(nullptr)},
          {"greatest_seen", peaks.greatest_seen},
          {"returns", returns_json(peaks.returns)}};
}

json maxima_json(const std::optional<twin::MaximaFit>& maxima, const std::string& why_not,
                 const std::string& method) {
  json found = {{"why_not", null_or_text(why_not)}, {"method", method}};
  if (!maxima) return found;
  found["location"] = maxima->fit.location;
  found["scale"] = maxima->fit.scale;
  found["shape"] = maxima->fit.shape;
  found["returns"] = returns_json(maxima->returns);
  return found;
}

json extremes_json(const twin::Extremes& extremes, const ClimateQuestion& question,
                   const StepClock& clock) {
  json peaks = {{"why_not", null_or_text(no_peaks_text(extremes))}, {"method", peaks_method()}};
  if (extremes.peaks) peaks.update(peaks_json(*extremes.peaks));
  json thresholds = json::array();
  for (const twin::PeaksFit& one : extremes.other_thresholds) thresholds.push_back(peaks_json(one));
  json maxima = json::array();
  for (const twin::YearMaximum& one : extremes.maxima)
    maxima.push_back(
        {{"year", one.year}, {"value", one.value}, {"time", format_utc(clock.time_of(one.step))}});
  return {{"years_known", extremes.years_known},
          {"separation_h", extremes.separation_h},
          {"peaks", std::move(peaks)},
          {"thresholds", std::move(thresholds)},
          {"annual_maxima", std::move(maxima)},
          {"gumbel", maxima_json(extremes.gumbel, no_gumbel_text(extremes), gumbel_method())},
          {"gev", maxima_json(extremes.extreme_value,
                              extremes.gumbel ? no_shape_text(extremes) : no_gumbel_text(extremes),
                              extreme_value_method())},
          {"interval_method", interval_method(question)},
          {"resamples", question.storms.resamples},
          {"seed", question.storms.seed}};
}

json part_json(const ClimatePart& part, const ClimateQuestion& question, const History& history) {
  const ClimateKind& kind = kind_of(part.of);
  const StepClock& clock = history.regular.clock;
  json by_month = json::array();
  for (std::size_t m = 0; m < part.known.by_month.size(); ++m) {
    const twin::KnownSteps& month = part.known.by_month[m];
    by_month.push_back({{"month", m + 1}, {"steps", month.steps}, {"known_steps", month.known}});
  }
  return {
      {"of", kind.word},
      {"standard_name", kind.size_name},
      {"series", history.series[part.series].name},
      {"unit", kind.unit},
      {"own_step_h", hours_of(history.regular.own_step[part.series])},
      {"known_steps", part.known.all.known},
      {"missing_steps", part.known.all.steps - part.known.all.known},
      {"coverage_by_month", std::move(by_month)},
      {"mean", part.spread.mean},
      {"p50", part.spread.p50},
      {"p90", part.spread.p90},
      {"p99", part.spread.p99},
      {"greatest",
       {{"value", part.spread.greatest},
        {"time", format_utc(clock.time_of(part.spread.greatest_step))}}},
      {"rose", part.rose ? rose_json(kind, *part.rose, history) : json(nullptr)},
      {"extremes", part.extremes ? extremes_json(*part.extremes, question, clock) : json(nullptr)}};
}

json scatter_json(const std::optional<ClimateScatter>& scatter) {
  if (!scatter) return nullptr;
  json rows = json::array();
  for (const std::vector<std::size_t>& row : scatter->counts.counts) {
    json cells = json::array();
    for (const std::size_t steps : row)
      cells.push_back(1000 * share_of(steps, scatter->counts.known));
    rows.push_back(std::move(cells));
  }
  json found = {{"height_unit", scatter->heights.unit},
                {"heights", classes_json(scatter->heights.values)},
                {"per_mille", std::move(rows)},
                {"known_steps", scatter->counts.known},
                {"missing_steps", scatter->counts.missing}};
  if (scatter->sectors == 0) {
    found["period_unit"] = scatter->periods.unit;
    found["periods"] = classes_json(scatter->periods.values);
    return found;
  }
  found["way"] = kind_of(ClimateOf::waves).way;
  found["middle_deg"] = json::array();
  for (std::size_t s = 0; s < scatter->sectors; ++s)
    found["middle_deg"].push_back(middle_deg(s, scatter->sectors));
  return found;
}

}  // namespace

json climate_json(const History& history, const ClimateQuestion& question,
                  const ClimateAnswer& answer) {
  const StepClock& clock = history.regular.clock;
  json document = {{"source", history.source},
                   {"first", format_utc(clock.first)},
                   {"last", format_utc(clock.time_of(clock.steps - 1))},
                   {"step_h", clock.step_h()},
                   {"steps", clock.steps},
                   {"parts", json::array()},
                   {"height_by_period", scatter_json(answer.by_period)},
                   {"height_by_direction", scatter_json(answer.by_sector)},
                   {"notes", history.notes}};
  for (const ClimatePart& part : answer.parts) {
    document["parts"].push_back(part_json(part, question, history));
    for (const std::string& note : part_notes(part)) document["notes"].push_back(note);
  }
  for (const std::string& note : answer.notes) document["notes"].push_back(note);
  return document;
}

}  // namespace slackwater::api
