#include "api/show/rehearse/adapt_mission.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "api/json/plot_json.h"
#include "api/show/rehearse/rehearsal_json.h"
#include "fields/base/check.h"
#include "fields/base/numbers/quantile.h"
#include "fields/base/text.h"
#include "twin/chance/success_interval.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using twin::ReserveFate;
using twin::TriedIntensity;

constexpr ReserveFate fates[] = {ReserveFate::kept, ReserveFate::called_home, ReserveFate::broken,
                                 ReserveFate::not_home};

json tried_json(const TriedIntensity& one) {
  const std::size_t flights = one.fates.size();
  const twin::SuccessInterval interval = twin::success_interval(one.kept(), flights);
  json out{{"density", number(one.thinned_by.density)},
           {"order", one.thinned_by.density < 1 ? json(name_of(one.thinned_by.order)) : json()},
           {"flights", flights},
           {"probability", number(static_cast<double>(one.kept()) / static_cast<double>(flights))},
           {"interval_95", {number(interval.low), number(interval.high)}},
           {"state_of_charge", quantiles_json(one.charge_left)},
           {"duration_s", quantiles_json(one.duration_s)},
           {"coverage", quantiles_json(one.coverage)}};
  for (const ReserveFate fate : fates) out[name_of(fate)] = one.count(fate);
  return out;
}

/// "0.21 0.24 0.27".
std::string quantiles_text(const std::vector<double>& values, double unit, bool is_fine) {
  std::string text;
  for (const double share : {0.1, 0.5, 0.9}) {
    const double value = quantile_of(values, share).value_or(0) / unit;
    text += is_fine ? formatted("{:7.2f}", value) : formatted("{:7.1f}", value);
  }
  return text;
}

}  // namespace

json intensity_json(const AdaptedStart& adapted) {
  const twin::IntensityChoice& choice = adapted.choice;
  json tried = json::array();
  for (const TriedIntensity& one : choice.tried) tried.push_back(tried_json(one));
  return {{"start", format_utc(adapted.start)},
          {"keep_share", number(adapted.keep_share)},
          {"members", choice.members},
          {"needed", choice.needed},
          {"chosen", choice.chosen ? tried[*choice.chosen].at("density") : json(nullptr)},
          {"reason", choice.reason},
          {"tried", tried}};
}

std::vector<std::string> intensity_texts(const AdaptedStart& adapted) {
  const twin::IntensityChoice& choice = adapted.choice;
  std::vector<std::string> lines;
  lines.push_back(formatted("How closely it can look at {}, the reserve kept in {} of {} futures:",
                            format_utc(adapted.start).substr(0, 16) + "Z", choice.needed,
                            choice.members));
  lines.push_back(
      "  density   kept  called home  broken  not home   charge left 10 50 90 %   minutes 10 50 90 "
      "%"
      "     covered 10 50 90 %");
  for (std::size_t i = 0; i < choice.tried.size(); ++i) {
    const TriedIntensity& one = choice.tried[i];
    lines.push_back(formatted(
        "{} {:7.2f} {:6} {:12} {:7} {:9}   {}  {}  {}", choice.chosen == i ? ">" : " ",
        one.thinned_by.density, one.kept(), one.count(ReserveFate::called_home),
        one.count(ReserveFate::broken), one.count(ReserveFate::not_home),
        quantiles_text(one.charge_left, 1, true), quantiles_text(one.duration_s, 60, false),
        quantiles_text(one.coverage, 1, true)));
  }
  lines.push_back(choice.reason);
  return lines;
}

std::string adapted_mission_yaml(const Config& mission, const std::vector<std::string>& roles,
                                 const AdaptedStart& adapted) {
  const twin::IntensityChoice& choice = adapted.choice;
  expects(choice.chosen.has_value(), "adapted_mission_yaml: nothing was chosen");
  const twin::Intensity by = choice.tried[*choice.chosen].thinned_by;
  YamlValue adapted_mission = mission.value();
  YamlValue agents;
  const auto overs = mission.optional_child("agents");
  for (const std::string& role : roles) {
    const auto said = overs ? overs->optional_child(role) : std::nullopt;
    const auto own = said ? said->optional_child("intensity") : std::nullopt;
    YamlValue agent = said ? said->value() : YamlValue();
    agent.put("intensity",
              value_of(twin::thinned(own ? twin::read_intensity(*own) : twin::Intensity{}, by)));
    agents.put(role, std::move(agent));
  }
  adapted_mission.put("start", format_utc(adapted.start)).put("agents", std::move(agents));
  return "# " + choice.reason + "\n" + yaml_of(adapted_mission);
}

}  // namespace slackwater::api
