#include "api/show/rehearse/cleaning_report.h"

#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "api/show/rehearse/over_flights.h"
#include "api/show/rehearse/rehearsal_json.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using twin::CleaningOutcome;

json mass_json(const CleaningOutcome& cleaning, double volume_m3) {
  return cleaning.density_kg_m3 > 0 ? number(cleaning.density_kg_m3 * volume_m3) : json(nullptr);
}

std::string area_text(double cleaned_m2, double area_m2) {
  return formatted("{:.1f} of {:.1f} m2", cleaned_m2, area_m2);
}

}  // namespace

std::string cleaning_text(const CleaningOutcome& c) {
  return area_text(c.cleaned_m2, c.area_m2) +
         formatted(
             " clean ({:.1f} %, asked for {:g} %), {:.3f} m3 of growth off, {:.3f} m3 left, "
             "{} {} needed",
             100 * c.share(), 100 * c.done_at, c.removed_m3, c.left_m3, c.passes_needed,
             c.passes_needed == 1 ? "pass" : "passes");
}

json cleaning_json(const CleaningOutcome& c) {
  json bands = json::array();
  for (const CleaningOutcome::Band& band : c.bands)
    bands.push_back({{"from_depth_m", number(band.top_m)},
                     {"to_depth_m", number(band.bottom_m)},
                     {"area_m2", number(band.area_m2)},
                     {"cleaned_m2", number(band.cleaned_m2)},
                     {"growth_removed_m3", number(band.removed_m3)},
                     {"growth_left_m3", number(band.left_m3)}});
  return {{"area_m2", number(c.area_m2)},
          {"cleaned_m2", number(c.cleaned_m2)},
          {"share", number(c.share())},
          {"done_at", number(c.done_at)},
          {"done", c.is_done()},
          {"growth_removed_m3", number(c.removed_m3)},
          {"growth_left_m3", number(c.left_m3)},
          {"growth_removed_kg", mass_json(c, c.removed_m3)},
          {"passes_needed", c.passes_needed},
          {"tool_time_s", number(c.worked_s)},
          {"by_depth", bands}};
}

json cleaning_json(const StartOutcome& start, std::size_t vehicle) {
  const OverFlights all(start, vehicle, &twin::VehicleAccount::cleaning);
  if (all.empty()) return nullptr;
  const CleaningOutcome& first = all.first();
  json bands = json::array();
  for (std::size_t b = 0; b < first.bands.size(); ++b)
    bands.push_back(
        {{"from_depth_m", number(first.bands[b].top_m)},
         {"to_depth_m", number(first.bands[b].bottom_m)},
         {"area_m2", number(first.bands[b].area_m2)},
         {"cleaned_m2", all.quantiles([b](const auto& c) { return c.bands[b].cleaned_m2; })},
         {"growth_left_m3", all.quantiles([b](const auto& c) { return c.bands[b].left_m3; })}});
  return {{"area_m2", number(first.area_m2)},
          {"done_at", number(first.done_at)},
          {"passes_needed", first.passes_needed},
          {"cleaned_m2", all.quantiles([](const auto& c) { return c.cleaned_m2; })},
          {"share", all.quantiles([](const auto& c) { return c.share(); })},
          {"growth_removed_m3", all.quantiles([](const auto& c) { return c.removed_m3; })},
          {"growth_left_m3", all.quantiles([](const auto& c) { return c.left_m3; })},
          {"growth_removed_kg", first.density_kg_m3 > 0 ? all.quantiles([](const auto& c) {
             return c.density_kg_m3 * c.removed_m3;
           })
                                                        : json(nullptr)},
          {"tool_time_s", all.quantiles([](const auto& c) { return c.worked_s; })},
          {"by_depth", bands}};
}

std::vector<std::string> cleaning_texts(const StartOutcome& start) {
  std::vector<std::string> texts;
  if (start.flights.empty()) return texts;
  for (std::size_t v = 0; v < start.flights.front().vehicles.size(); ++v) {
    const OverFlights all(start, v, &twin::VehicleAccount::cleaning);
    if (all.empty()) continue;
    const auto share = [&](double at) {
      return 100 * all.quantile(at, [](const auto& c) { return c.share(); });
    };
    texts.push_back(start.flights.front().vehicles[v].name +
                    formatted(": {:.0f} % of {:.1f} m2 clean (P10 {:.0f} %, P90 {:.0f} %, asked "
                              "for {:g} %)",
                              share(0.5), all.first().area_m2, share(0.1), share(0.9),
                              100 * all.first().done_at));
  }
  return texts;
}

std::string cleaned_text(const CleaningOutcome& cleaning) {
  return area_text(cleaning.cleaned_m2, cleaning.area_m2) +
         formatted(" ({:.0f} %)", 100 * cleaning.share());
}

}  // namespace slackwater::api
