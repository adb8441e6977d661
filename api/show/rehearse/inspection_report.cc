#include "api/show/rehearse/inspection_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "api/show/rehearse/over_flights.h"
#include "api/show/rehearse/rehearsal_json.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using twin::InspectionOutcome;

std::string with_count(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what;
}

json score_json(const twin::DetectionScore& score) {
  json by_kind = json::object();
  for (const twin::DefectKind kind : twin::all_defect_kinds()) {
    const auto& of = score.kinds[static_cast<std::size_t>(kind)];
    if (of.planted + of.false_alarms == 0) continue;
    by_kind[twin::name_of(kind)] = {
        {"planted", of.planted}, {"found", of.found}, {"false_alarms", of.false_alarms}};
  }
  const auto optional = [](const std::optional<double>& value) {
    return value ? number(*value) : json(nullptr);
  };
  return {{"planted", score.all.planted},
          {"found", score.all.found},
          {"false_alarms", score.all.false_alarms},
          {"detection_rate", optional(score.detection_rate)},
          {"false_alarms_per_100_m2", optional(score.false_alarms_per_100_m2)},
          {"size_error_rms_m", optional(score.size_error_rms_m)},
          {"by_kind", by_kind}};
}

}  // namespace

std::string covered_text(const InspectionOutcome& outcome) {
  std::string text = formatted("{:.0f} of {:.0f} m2 covered ({:.0f} %)", outcome.covered_m2(),
                               outcome.area_m2(), 100 * outcome.share());
  if (const std::optional<bool> is_seen = outcome.is_seen())
    text += *is_seen ? ", seen as asked" : ", NOT SEEN as asked: " + outcome.left;
  return text;
}

std::string inspection_text(const InspectionOutcome& outcome) {
  std::string text = covered_text(outcome);
  std::string parts;
  for (const InspectionOutcome::Part& part : outcome.parts)
    parts += (parts.empty() ? ": " : ", ") + part.surface + " by the " + part.instrument +
             formatted(" {:.0f} %", 100 * part.share());
  text += parts;
  if (outcome.score.all.planted + outcome.score.all.false_alarms > 0)
    text += "; " + with_count(outcome.score.all.found, "found") + ", " +
            with_count(outcome.score.missed(), "missed") + ", " +
            with_count(outcome.score.all.false_alarms, "false alarms");
  return text;
}

json inspection_json(const InspectionOutcome& outcome) {
  json parts = json::array();
  for (const InspectionOutcome::Part& part : outcome.parts)
    parts.push_back({{"surface", part.surface},
                     {"kind", twin::name_of(part.kind)},
                     {"instrument", part.instrument},
                     {"area_m2", number(part.area_m2)},
                     {"seen_m2", number(part.seen_m2)},
                     {"covered_m2", number(part.covered_m2)},
                     {"share", number(part.share())},
                     {"asked", number(part.asked)},
                     {"least_detail_m", number(part.least_detail_m)},
                     {"median_detail_m", number(part.median_detail_m)}});
  return {{"share", number(outcome.share())},
          {"done", outcome.left.empty()},
          {"seen", outcome.is_seen() ? json(*outcome.is_seen()) : json(nullptr)},
          {"left", outcome.left},
          {"looks", outcome.looks},
          {"rays", outcome.rays},
          {"worked_s", number(outcome.worked_s)},
          {"surfaces", parts},
          {"defects", score_json(outcome.score)}};
}

json inspection_json(const StartOutcome& start, std::size_t vehicle) {
  const OverFlights all(start, vehicle, &twin::VehicleAccount::inspection);
  if (all.empty()) return nullptr;
  json parts = json::array();
  for (std::size_t p = 0; p < all.first().parts.size(); ++p) {
    const InspectionOutcome::Part& first = all.first().parts[p];
    parts.push_back({{"surface", first.surface},
                     {"instrument", first.instrument},
                     {"area_m2", number(first.area_m2)},
                     {"asked", number(first.asked)},
                     {"share", all.quantiles([p](const auto& o) { return o.parts[p].share(); })}});
  }
  const auto rate = [](const auto& o) { return o.score.detection_rate.value_or(0); };
  return {
      {"share", all.quantiles([](const auto& o) { return o.share(); })},
      {"surfaces", parts},
      {"detection_rate", all.first().score.all.planted == 0 ? json(nullptr) : all.quantiles(rate)}};
}

namespace {

/// Done is not seen: in how many flights what is asked was covered.
std::string seen_text(const OverFlights<InspectionOutcome>& all) {
  if (!all.first().is_seen()) return ", no share is asked for";
  std::size_t seen = 0, flights = 0;
  for (const InspectionOutcome* outcome : all) {
    ++flights;
    seen += outcome->is_seen() == true ? 1 : 0;
  }
  return formatted(", seen as asked in {} of {}", seen, flights);
}

}  // namespace

std::vector<std::string> inspection_texts(const StartOutcome& start) {
  std::vector<std::string> texts;
  if (start.flights.empty()) return texts;
  for (std::size_t v = 0; v < start.flights.front().vehicles.size(); ++v) {
    const OverFlights all(start, v, &twin::VehicleAccount::inspection);
    if (all.empty()) continue;
    const auto share = [&](double at) {
      return 100 * all.quantile(at, [](const auto& o) { return o.share(); });
    };
    std::size_t planted = 0, found = 0;
    for (const InspectionOutcome* outcome : all) {
      planted += outcome->score.all.planted;
      found += outcome->score.all.found;
    }
    texts.push_back(start.flights.front().vehicles[v].name +
                    formatted(": {:.0f} % of {:.0f} m2 covered (P10 {:.0f} %, P90 {:.0f} %)",
                              share(0.5), all.first().area_m2(), share(0.1), share(0.9)) +
                    seen_text(all) +
                    (planted == 0 ? std::string()
                                  : formatted("; of made-up defects {:.0f} % found",
                                              100.0 * static_cast<double>(found) /
                                                  static_cast<double>(planted))));
  }
  return texts;
}

}  // namespace slackwater::api
