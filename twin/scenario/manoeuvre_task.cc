#include "twin/scenario/manoeuvre_task.h"

#include <array>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/mission/reach.h"
#include "twin/mission/read_seconds.h"
#include "twin/scenario/write_number.h"

namespace slackwater::twin {
namespace {

using constants::degree;

constexpr std::array<const char*, 5> words{"turning_circle", "zig_zag", "spiral", "pull_out",
                                           "steps"};
constexpr std::size_t most_helms = 200, most_steps = 10000;

/// A time that has no default.
double required_seconds(const Config& task, const std::string& key, Range range) {
  if (!has_seconds(task, key))
    task.refuse(key + "_s", "missing; give " + key + "_s: 60, or " + key + ": 1min");
  return read_seconds(task, key, range);
}

bool read_to_port(const Config& task) {
  const std::string side = task.optional_text("side").value_or("starboard");
  if (side != "starboard" && side != "port")
    task.refuse("side", "found " + side + ", expected starboard or port");
  return side == "port";
}

/// `helm_deg` or `helm_share`, above 0: the side says the sign.
void read_helm(const Config& task, ManoeuvreTask& manoeuvre) {
  const auto in_degrees = task.optional_number("helm_deg", {0.01, 90});
  const auto as_share = task.optional_number("helm_share", {0.001, 1});
  if (in_degrees && as_share)
    task.refuse("helm_share", "found beside helm_deg; give one of the two");
  manoeuvre.helms_are_shares = as_share.has_value();
  if (in_degrees || as_share)
    manoeuvre.helm_place = place_of_key(task, as_share ? ".helm_share" : ".helm_deg");
  if (in_degrees) manoeuvre.helms = {*in_degrees * degree};
  if (as_share) manoeuvre.helms = {*as_share};
}

void read_turning_circle(const Config& task, ManoeuvreTask& manoeuvre) {
  manoeuvre.heading_change_rad =
      task.optional_number("heading_change_deg", {90, 7200}).value_or(540) * degree;
}

void read_zig_zag(const Config& task, ManoeuvreTask& manoeuvre) {
  manoeuvre.heading_change_rad =
      task.optional_number("heading_change_deg", {1, 90}).value_or(20) * degree;
  manoeuvre.executes =
      static_cast<std::size_t>(task.optional_integer("executes", 2, 100).value_or(5));
}

void read_pull_out(const Config& task, ManoeuvreTask& manoeuvre) {
  manoeuvre.turn_s = required_seconds(task, "turn", {1, 86400});
}

void read_spiral(const Config& task, ManoeuvreTask& manoeuvre) {
  const bool as_shares = task.has("helms_share");
  if (as_shares && task.has("helms_deg"))
    task.refuse("helms_share", "found beside helms_deg; give one of the two");
  const char* const key = as_shares ? "helms_share" : "helms_deg";
  manoeuvre.helms_are_shares = as_shares;
  manoeuvre.helm_place = place_of_key(task, std::string(".") + key);
  manoeuvre.helms = task.numbers(key, as_shares ? Range{-1, 1} : Range{-90, 90});
  if (manoeuvre.helms.size() < 2 || manoeuvre.helms.size() > most_helms)
    task.refuse(key, formatted("found {} helms, expected 2 to {} in their order, such as "
                               "[10, 5, 0, -5, -10, -5, 0, 5, 10] (helms_deg, of a rudder; "
                               "helms_share: shares of it, or of the thrusters' yaw moment)",
                               manoeuvre.helms.size(), most_helms));
  if (!as_shares)
    for (double& helm : manoeuvre.helms) helm *= degree;
  manoeuvre.each_s = required_seconds(task, "each", {1, 86400});
}

KeptStep read_step(const Config& config) {
  KeptStep step;
  step.place = place_of_key(config, ".at_s");
  step.at_s = config.number("at_s", {0, 30 * 86400.0});
  if (const auto heading = config.optional_number("heading_deg", {-360, 360}))
    step.heading_rad = *heading * degree;
  step.speed_m_s = config.optional_number("speed_m_s", {0, 60});
  step.depth_m = config.optional_number("depth_m", reached_depth_m);
  if (!step.heading_rad && !step.speed_m_s && !step.depth_m)
    config.refuse("at_s", "found a step of nothing; give heading_deg, speed_m_s or depth_m");
  return step;
}

void read_steps(const Config& task, ManoeuvreTask& manoeuvre) {
  manoeuvre.lasts_s = required_seconds(task, "duration", {1, 30 * 86400.0});
  for (const Config& config : task.children("table")) {
    KeptStep step = read_step(config);
    const auto& before = manoeuvre.steps;
    if (!before.empty() && !(step.at_s > before.back().at_s))
      config.refuse("at_s",
                    formatted("found {:g} after {:g}; list steps in the order of their time",
                              step.at_s, before.back().at_s));
    if (!(step.at_s < manoeuvre.lasts_s))
      config.refuse("at_s", formatted("found {:g}, and the task lasts {:g} s; give it a longer "
                                      "duration, or leave the step out",
                                      step.at_s, manoeuvre.lasts_s));
    manoeuvre.steps.push_back(std::move(step));
  }
  if (manoeuvre.steps.empty() || manoeuvre.steps.size() > most_steps)
    task.refuse("table", formatted("found {} steps, expected 1 to {}: [{{at_s: 60, heading_deg: "
                                   "30}}]",
                                   manoeuvre.steps.size(), most_steps));
}

void put_helm(const ManoeuvreTask& task, YamlValue& value) {
  value.put("side", task.to_port ? "port" : "starboard");
  if (task.helms.empty()) return;
  if (task.helms_are_shares)
    value.put("helm_share", task.helms.front());
  else
    value.put("helm_deg", degrees_for(task.helms.front()));
}

YamlValue step_value(const KeptStep& step) {
  YamlValue value;
  value.put("at_s", step.at_s);
  if (step.heading_rad) value.put("heading_deg", degrees_for(*step.heading_rad));
  if (step.speed_m_s) value.put("speed_m_s", *step.speed_m_s);
  if (step.depth_m) value.put("depth_m", *step.depth_m);
  return value;
}

}  // namespace

const char* name_of(ManoeuvreKind kind) noexcept { return words[static_cast<std::size_t>(kind)]; }

std::optional<ManoeuvreKind> manoeuvre_named(std::string_view word) noexcept {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (word == words[i]) return static_cast<ManoeuvreKind>(i);
  return std::nullopt;
}

double longest_s(const ManoeuvreTask& task) noexcept {
  switch (task.kind) {
    case ManoeuvreKind::steps:
      return task.lasts_s;
    case ManoeuvreKind::spiral:
      return task.approach_s + task.each_s * static_cast<double>(task.helms.size());
    default:
      return task.approach_s + task.turn_s + task.lasts_s;
  }
}

ManoeuvreTask read_manoeuvre(const Config& task, ManoeuvreKind kind) {
  ManoeuvreTask manoeuvre;
  manoeuvre.kind = kind;
  manoeuvre.place = manoeuvre.helm_place = place_of_key(task, ".do");
  manoeuvre.speed_m_s = task.optional_number("speed_m_s", {0.01, 60});
  if (kind == ManoeuvreKind::steps) {
    read_steps(task, manoeuvre);
    return manoeuvre;
  }
  if (has_seconds(task, "approach"))
    manoeuvre.approach_s = read_seconds(task, "approach", {5, 86400});
  if (kind == ManoeuvreKind::spiral) {
    read_spiral(task, manoeuvre);
    return manoeuvre;
  }
  manoeuvre.to_port = read_to_port(task);
  read_helm(task, manoeuvre);
  manoeuvre.lasts_s = required_seconds(task, "lasts", {1, 86400});
  if (kind == ManoeuvreKind::turning_circle) read_turning_circle(task, manoeuvre);
  if (kind == ManoeuvreKind::zig_zag) read_zig_zag(task, manoeuvre);
  if (kind == ManoeuvreKind::pull_out) read_pull_out(task, manoeuvre);
  return manoeuvre;
}

void put_manoeuvre(const ManoeuvreTask& task, YamlValue& value) {
  if (task.speed_m_s) value.put("speed_m_s", *task.speed_m_s);
  if (task.kind == ManoeuvreKind::steps) {
    value.put("duration_s", task.lasts_s);
    std::vector<YamlValue> steps;
    for (const KeptStep& step : task.steps) steps.push_back(step_value(step));
    value.put("table", std::move(steps));
    return;
  }
  value.put("approach_s", task.approach_s);
  if (task.kind == ManoeuvreKind::spiral) {
    std::vector<double> helms = task.helms;
    if (!task.helms_are_shares)
      for (double& helm : helms) helm = degrees_for(helm);
    value.put(task.helms_are_shares ? "helms_share" : "helms_deg", YamlValue::numbers(helms))
        .put("each_s", task.each_s);
    return;
  }
  put_helm(task, value);
  value.put("lasts_s", task.lasts_s);
  if (task.kind == ManoeuvreKind::pull_out) value.put("turn_s", task.turn_s);
  if (task.heading_change_rad > 0)
    value.put("heading_change_deg", degrees_for(task.heading_change_rad));
  if (task.kind == ManoeuvreKind::zig_zag)
    value.put("executes", static_cast<double>(task.executes));
}

}  // namespace slackwater::twin
