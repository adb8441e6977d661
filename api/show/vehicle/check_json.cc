#include "api/show/vehicle/check_json.h"

#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "api/show/rehearse/manoeuvre_report.h"
#include "fields/base/constants.h"
#include "twin/body/vehicle_kind.h"

namespace slackwater::api {
namespace {

using constants::degree;
using nlohmann::json;

json modes_json(const std::vector<std::complex<double>>& modes) {
  json all = json::array();
  for (const std::complex<double>& mode : modes)
    all.push_back({number(mode.real()), number(mode.imag())});
  return all;
}

json course_json(const twin::KeptCourse& course, bool floats) {
  const auto judged = [&](double value) {
    return course.is_judged ? number(value) : json(nullptr);
  };
  return {{"kept", is_kept(course)},
          {"lost", is_lost(course)},
          {"lasts_s", number(course.lasts_s)},
          {"judged", course.is_judged},
          {"heading_off_deg", judged(course.heading_off_rad / degree)},
          {"heading_swing_deg", judged(course.heading_swing_rad / degree)},
          {"pitch_swing_deg", judged(course.pitch_swing_rad / degree)},
          {"depth_off_m", floats ? json(nullptr) : judged(course.depth_off_m)},
          {"speed_m_s", judged(course.made_m_s)},
          {"over_at_s", number(course.over_at_s)}};
}

json speed_json(const AtSpeed& at, bool floats) {
  json out{{"speed_m_s", number(at.speed_m_s)},
           {"cruise", at.is_cruise},
           {"top", at.is_top},
           {"power_w", number(at.power_w)},
           {"lasts_s", number(at.lasts_s)},
           {"range_m", number(at.range_m)}};
  if (at.modes)
    out["eigenvalues_per_s"] = {{"vertical", modes_json(at.modes->vertical)},
                                {"horizontal", modes_json(at.modes->horizontal)}};
  if (at.course) out["autopilot"] = course_json(*at.course, floats);
  if (at.level)
    out["level_flight"] = {{"pitch_deg", number(at.level->pitch_rad / degree)},
                           {"elevator_deg", number(at.level->elevator_rad / degree)},
                           {"held", at.level->is_held}};
  return out;
}

json balance_json(const VehicleCheck& check) {
  const twin::Balance& b = check.balance;
  json out{{"heel_deg", number(b.heel_rad / degree)}, {"trim_deg", number(b.trim_rad / degree)}};
  if (check.floats()) {
    out["gm_across_m"] = number(b.stability_m);
    out["gm_along_m"] = number(b.stability_long_m);
    out["draught_m"] = number(b.draught_m);
    out["least_freeboard_m"] = number(b.least_freeboard_m);
  } else {
    out["bg_m"] = number(b.stability_m);
    out["net_buoyancy_n"] = number(b.net_buoyancy_n);
  }
  return out;
}

json open_loop_json(const twin::OpenLoop& alone) {
  return {{"stable", alone.is_stable()},          {"pitch_per_s", number(alone.pitch_per_s)},
          {"yaw_per_s", number(alone.yaw_per_s)}, {"roll_per_s", number(alone.roll_per_s)},
          {"goes_over", alone.goes_over},         {"goes_over_at_m_s", number(alone.over_at_m_s)},
          {"words", twin::words_of(alone)}};
}

}  // namespace

json check_json(const VehicleCheck& check) {
  json speeds = json::array(), manoeuvres = json::array();
  for (const AtSpeed& at : check.speeds) speeds.push_back(speed_json(at, check.floats()));
  for (const FlownManoeuvre& one : check.manoeuvres)
    manoeuvres.push_back({{"name", one.name},
                          {"account", one.account ? manoeuvre_json(*one.account) : json(nullptr)},
                          {"why_not", one.why_not}});
  return {{"file", check.file.filename().string()},
          {"id", check.vehicle.id},
          {"name", check.vehicle.name},
          {"kind", twin::name_of(check.vehicle.kind)},
          {"mass_kg", number(check.vehicle.body.mass_kg)},
          {"warnings", check.vehicle.warnings},
          {"at_rest", check.flies() ? json(nullptr) : balance_json(check)},
          {"cruise_speed_m_s", number(check.vehicle.cruise_speed_m_s)},
          {"top_speed_m_s", number(check.top_speed_m_s)},
          {"controls_held", check.flies() ? json(nullptr) : open_loop_json(check.open_loop)},
          {"speeds", speeds},
          {"manoeuvres", manoeuvres}};
}

}  // namespace slackwater::api
