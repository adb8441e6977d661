#include <algorithm>

#include "api/door/people/session.h"

// What the stations of a session are told. With the lock held.

namespace slackwater::people {
namespace {

using api::http::Worth;
using nlohmann::json;

constexpr Milliseconds stalled_ms = 1'000;
constexpr std::size_t rows_in_welcome = 100;

}  // namespace

void Session::tell(Station& station, const json& json) { people::tell(station, json); }

void Session::tell_all(const json& json) {
  const std::string text = text_of(json);
  for (auto& [socket, station] : stations_) {
    if (station.seat == 0 || station.is_turned_out) continue;
    (void)station.socket->send({true, text, nullptr, Worth::essential});
  }
}

bool Session::has_those(bool is_brief) const {
  return std::any_of(stations_.begin(), stations_.end(), [&](const auto& one) {
    return one.second.seat != 0 && one.second.flow.is_brief() == is_brief;
  });
}

void Session::tell_those(bool is_brief, const json& json) {
  const std::string text = text_of(json);
  for (auto& [socket, station] : stations_) {
    if (station.seat == 0 || station.is_turned_out || station.flow.is_brief() != is_brief) continue;
    (void)station.socket->send({true, text, nullptr, Worth::essential});
  }
}

ShownHelm Session::shown(std::size_t vehicle) const {
  ShownHelm shown{desk_->helms().now(vehicle), {}, {}, {}};
  if (vehicle >= now_.vehicles.size()) return shown;
  const VehicleNow& now = now_.vehicles[vehicle];
  shown.mode = now.mode;
  shown.cause = now.cause;
  if (now.home_at_s)  // on the clock of the session, to the second: it is shown counting down
    shown.home_at =
        (barrier_at_ + static_cast<Milliseconds>(1000 * (*now.home_at_s - now_.time_s))) / 1000 *
        1000;
  return shown;
}

std::string Session::run_state() const {
  if (is_over_) return "over";
  if (!hand_) return "starting";
  if (hand_->control.is_paused()) return "paused";
  // A run may be slower than the clock: its own pace says what is long.
  return clock() - barrier_at_ > stalled_ms + 3 * barrier_after_ ? "stalled" : "running";
}

json Session::run_json() const {
  const std::string state = run_state();
  json by = nullptr;
  if (state == "paused" && desk_)
    by = desk_->paused_by().empty() ? "another door" : desk_->paused_by();
  if (state == "stalled") {
    const std::string whom = hand_->control.awaited().whom();
    by = whom.empty() ? "the machine" : whom;
  }
  return {{"is", "run"}, {"state", state}, {"by", by}};
}

void Session::welcome(Station& station, const Seats::Taken& taken) {
  const Seat& seat = *seats_.find(taken.seat);
  json welcome = run_facts_;
  welcome["is"] = "welcome";
  welcome["seat"] = seat.number;
  welcome["name"] = seat.name;
  welcome["role"] = name_of(seat.role);
  welcome["resume"] = taken.resume;
  welcome["clock"] = clock();
  welcome["number"] = desk_ ? desk_->last_number(seat.number) : 0;
  json vehicles = json::array(), helms = json::array(), status = json::array();
  if (desk_) {
    const auto agents = desk_->agents();
    for (std::size_t i = 0; i < agents.size() && i < now_.vehicles.size(); ++i) {
      vehicles.push_back(vehicle_json(*agents[i], i, now_.vehicles[i]));
      helms.push_back(helm_json(i, shown(i)));
      status.push_back(status_json(i, now_.vehicles[i]));
    }
  }
  json seats = json::array();
  for (const Seat& one : seats_.all()) seats.push_back(seat_json(one));
  json rows = json::array();
  const auto& all = record_.all();
  for (std::size_t i = all.size(); i-- > 0 && rows.size() < rows_in_welcome;)
    if (is_told(all[i])) rows.push_back(action_json(all[i]));
  std::reverse(rows.begin(), rows.end());
  welcome["vehicles"] = vehicles;
  welcome["helms"] = helms;
  welcome["status"] = status;
  welcome["seats"] = seats;
  welcome["actions"] = rows;
  welcome["run"] = run_json();
  welcome["looks"] = gathering_.looks_json();
  welcome["notes"] = gathering_.notes_json();
  welcome["lines"] = json::array();
  for (std::size_t i = 0; i < now_.vehicles.size(); ++i)
    if (!now_.vehicles[i].line_m.empty())
      welcome["lines"].push_back(line_json(i, now_.vehicles[i]));
  welcome["thrusts"] = json::array();
  for (std::size_t i = 0; i < now_.vehicles.size(); ++i)
    welcome["thrusts"].push_back(thrust_json(i, now_.vehicles[i]));
  for (const char* const each : {"surfaces", "covered", "findings"}) welcome[each] = json::array();
  for (const auto& [vehicle, told] : inspections_) {
    for (const json& surface : told.surfaces) welcome["surfaces"].push_back(surface);
    for (const json& covered : told.covered) welcome["covered"].push_back(covered);
    welcome["findings"].push_back(told.findings);
  }
  welcome["weather"] = weather_now();
  welcome["pictures"] = pictures_json();
  welcome["traffic"] = now_.around ? traffic_json(*now_.around) : json(nullptr);
  tell(station, welcome);
  // Of what is told less often than it changes the newcomer has a later state than the others.
  lines_told_.clear();
  thrusts_told_.clear();
  thrust_rows_told_.clear();
}

void Session::tell_seats() {
  json seats = json::array();
  for (const Seat& one : seats_.all()) seats.push_back(seat_json(one));
  if (seats == seats_told_) return;
  seats_told_ = seats;
  tell_all({{"is", "seats"}, {"seats", seats}});
}

void Session::tell_helms() {
  if (!desk_) return;
  for (std::size_t i = 0; i < desk_->helms().size() && i < now_.vehicles.size(); ++i) {
    const ShownHelm is = shown(i);
    if (i < helms_told_.size() && helms_told_[i] == is) continue;
    if (i >= helms_told_.size()) helms_told_.resize(i + 1);
    helms_told_[i] = is;
    tell_all(helm_json(i, is));
  }
}

void Session::tell_status(bool is_second) {
  json reserves = json::array();
  for (std::size_t i = 0; i < now_.vehicles.size(); ++i) {
    const json status = status_json(i, now_.vehicles[i]);
    if (i >= status_told_.size()) status_told_.emplace_back();
    json& told = status_told_[i];
    json but_reserve = status;
    if (told.is_object())
      for (const char* const late : {"reserve", "margin_s"}) but_reserve[late] = told[late];
    if (but_reserve != told) {
      told = is_second ? status : but_reserve;
      tell_all(told);
    } else if (is_second && status != told) {
      told = status;
      tell_those(false, told);
      reserves.push_back(reserve_json(i, now_.vehicles[i]));
    }
  }
  if (!reserves.empty()) tell_those(true, {{"is", "reserves"}, {"reserves", reserves}});
}

void Session::tell_lines() {
  lines_told_.resize(now_.vehicles.size());
  for (std::size_t i = 0; i < now_.vehicles.size(); ++i) {
    json line = line_json(i, now_.vehicles[i]);
    if (line == lines_told_[i] || (lines_told_[i].is_null() && line["nodes"].empty())) continue;
    lines_told_[i] = line;
    tell_all(line);
  }
}

void Session::tell_thrusts() {
  if (!has_those(false)) return;
  thrusts_told_.resize(now_.vehicles.size());
  for (std::size_t i = 0; i < now_.vehicles.size(); ++i) {
    json thrust = thrust_json(i, now_.vehicles[i]);
    if (thrust == thrusts_told_[i]) continue;
    thrusts_told_[i] = thrust;
    tell_those(false, thrust);
  }
}

void Session::tell_thrusts_briefly() {
  if (!has_those(true)) return;
  thrust_rows_told_.resize(now_.vehicles.size());
  json rows = json::array();
  for (std::size_t i = 0; i < now_.vehicles.size(); ++i) {
    json row = thrust_row_json(i, now_.vehicles[i]);
    if (row == thrust_rows_told_[i]) continue;
    rows.push_back(row);
    thrust_rows_told_[i] = std::move(row);
  }
  if (!rows.empty()) tell_those(true, {{"is", "thrusts"}, {"thrusts", rows}});
}

void Session::tell_gathering() {
  if (json looks = gathering_.looks_json(); looks != looks_told_) {
    tell_all({{"is", "looks"}, {"looks", looks}});
    looks_told_ = std::move(looks);
  }
  if (json notes = gathering_.notes_json(); notes != notes_told_) {
    tell_all({{"is", "notes"}, {"notes", notes}});
    notes_told_ = std::move(notes);
  }
}

json Session::weather_now() const {
  if (!now_.around || !desk_) return nullptr;
  return weather_json(*now_.around, now_.time_s, farm_now_, desk_->weather_by());
}

void Session::tell_around() {
  if (!now_.around) return;
  const auto tell_new = [this](json is, json& told) {
    if (is == told || is.is_null()) return;
    told = std::move(is);
    tell_all(told);
  };
  tell_new(weather_now(), weather_told_);
  tell_new(traffic_json(*now_.around), traffic_told_);
}

void Session::tell_run() {
  const json run = run_json();
  if (run == run_told_) return;
  run_told_ = run;
  json told = run;
  told["time_s"] = now_.time_s;
  tell_all(told);
}

}  // namespace slackwater::people
