#include "api/door/people/playback/playback.h"

#include <cmath>

#include "api/door/http/problem.h"
#include "api/door/http/trust.h"
#include "api/door/people/told.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::people {
namespace {

using api::http::Request;
using api::http::Response;
using api::http::WebSocket;
using api::http::Worth;
using nlohmann::json;

constexpr double any_time_s = 1e12;  ///< of a seek: it goes to the nearest of the log

json origin_json(const std::optional<GeoPoint>& origin) {
  if (!origin) return nullptr;
  return {{"lat", origin->latitude_deg()}, {"lon", origin->longitude_deg()}};
}

}  // namespace

Playback::Playback(LoggedRun run, FoundSurround found)
    : run_(std::move(run)),
      found_(std::move(found)),
      began_(std::chrono::steady_clock::now()),
      ticker_([this] {
        tick();
        return true;
      }) {
  const std::lock_guard lock(mutex_);
  json structures = json::array(), vehicles = json::array(), actions = json::array();
  for (std::size_t i = 0; i < run_.structures.size(); ++i)
    structures.push_back(structure_json(run_.structures[i], i));
  for (std::size_t i = 0; i < run_.vehicles.size(); ++i) vehicles.push_back(vehicle_facts(i));
  for (const Action& action : run_.actions) actions.push_back(action_json(action));
  facts_ = {{"is", "welcome"},
            {"session", id},
            {"title", run_.title},
            {"seat", nullptr},
            {"role", name_of(Role::looks_on)},
            {"number", 0},
            {"step_s", run_.step_s},
            {"start", format_utc(run_.start)},
            {"origin", origin_json(run_.origin)},
            {"structures", structures},
            {"vehicles", vehicles},
            {"seats", json::array()},
            {"actions", actions},
            {"playback", {{"from_s", run_.from_s()}, {"to_s", run_.to_s()}}}};
  facts_.update(place_facts());
}

Playback::~Playback() { end(); }

void Playback::end() {
  const std::lock_guard lock(mutex_);
  is_over_ = true;
  for (auto& [socket, viewer] : viewers_)
    turn_out(viewer, {CloseCode::over, "the log is not served any more"});
}

void Playback::wait_for_farewells(std::chrono::milliseconds most) {
  std::unique_lock lock(mutex_);
  gone_.wait_for(lock, most, [&] { return viewers_.empty(); });
}

Milliseconds Playback::clock() const {
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() -
                                                               began_)
      .count();
}

// --- from the stations ---

json Playback::summary() const { return {{"id", id}, {"name", run_.title}, {"state", "recorded"}}; }

std::vector<std::string> Playback::protocols() const { return {std::string(protocol_name)}; }

std::optional<Response> Playback::refusal(const Request& request) const {
  if (!api::http::is_loopback_host(request.host))
    return api::http::problem(
        403, "found the host " + request.host + ", expected 127.0.0.1: a log is for this machine",
        request.path);
  return refusal_of_origin(request);
}

void Playback::opened(const std::shared_ptr<WebSocket>& socket, const Request&,
                      const std::string&) {
  const std::lock_guard lock(mutex_);
  Viewer& viewer = viewers_.try_emplace(socket.get(), run_.from_s(), run_.to_s()).first->second;
  viewer.socket = socket;
  viewer.since = viewer.heard_at = clock();
  if (is_over_) turn_out(viewer, {CloseCode::over, "the log is not served any more"});
}

void Playback::received_text(WebSocket& socket, std::string_view text) {
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(&socket);
  if (found == viewers_.end() || found->second.is_turned_out) return;
  Viewer& viewer = found->second;
  const auto said = hear(viewer, text, clock());
  if (const auto* why = std::get_if<TurnOut>(&said)) return turn_out(viewer, *why);
  const auto& says = std::get<StationSays>(said);
  try {
    heard(viewer, says);
  } catch (const Error& e) {
    tell(viewer, refused_json(says, "unreadable", e.message()));
  }
}

void Playback::received_bytes(WebSocket& socket, std::span<const std::uint8_t>) {
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(&socket);
  if (found != viewers_.end())
    turn_out(found->second,
             {CloseCode::malformed, "found a binary message, expected JSON in text messages"});
}

void Playback::closed(WebSocket& socket) {
  const std::lock_guard lock(mutex_);
  viewers_.erase(&socket);
  gone_.notify_all();
}

void Playback::heard(Viewer& viewer, const StationSays& says) {
  const std::string& what = says.what();
  if (what == "hello") {
    if (viewer.has_said_hello)
      throw Error(ErrorKind::invalid_input, "hello: found a second one; this station is in");
    const std::string name = says.text_or_empty("name", 100);
    viewer.flow.be_brief(says.flag("brief", false));
    return welcome(viewer, name);
  }
  if (!viewer.has_said_hello)
    return turn_out(viewer, {CloseCode::malformed, "found " + what + ", expected hello first"});
  if (keeps_in_touch(viewer, says, clock())) return;
  if (what == "play") {
    play(viewer, says.number_if("rate", PlayHead::least_rate, PlayHead::most_rate).value_or(1));
  } else if (what == "pause") {
    viewer.head.pause(clock());
    viewer.around_at_s = constants::nan;
    show(viewer);
  } else if (what == "seek") {
    seek(viewer, says.number("time_s", -any_time_s, any_time_s));
  } else if (what == "leave") {
    viewer.is_turned_out = true;
    return viewer.socket->close(1000, "you left");
  } else {
    throw Error(
        ErrorKind::invalid_input,
        formatted("found \"{}\", which is nothing to do to a recording; its words are play, "
                  "pause and seek (api/docs/session_wire.md)",
                  what));
  }
  tell(viewer, {{"is", "answer"}, {"id", says.id()}, {"taken", true}});
}

void Playback::play(Viewer& viewer, double rate) {
  // At its end there is nothing left but to begin again.
  if (viewer.head.is_at_end(clock())) seek(viewer, run_.from_s());
  viewer.head.play(rate, clock());
  tell_run(viewer);
}

void Playback::seek(Viewer& viewer, double time_s) {
  viewer.head.seek(time_s, clock());
  const double at_s = viewer.head.at_s(clock());
  viewer.actions_told = run_.actions_by(at_s);
  tell(viewer, {{"is", "seen"}, {"number", number_of_last(viewer.actions_told)}, {"time_s", at_s}});
  viewer.flow.begin_again();
  viewer.is_frame_due = true;
  viewer.around_at_s = constants::nan;
  show(viewer);
}

// --- to the stations ---

void Playback::welcome(Viewer& viewer, const std::string& name) {
  viewer.has_said_hello = true;
  const double at_s = viewer.head.at_s(clock());
  viewer.actions_told = run_.actions_by(at_s);
  viewer.is_frame_due = true;
  json welcome = facts_;
  welcome["name"] = name;
  welcome["clock"] = clock();
  welcome["seen"] = number_of_last(viewer.actions_told);
  welcome["run"] = run_json(viewer);
  json helms = json::array(), status = json::array();
  const Moment moment = moment_of(run_.t_s, at_s);
  for (std::size_t i = 0; i < run_.vehicles.size(); ++i) {
    viewer.told.push_back(status_place(run_.vehicles[i], moment, at_s));
    helms.push_back(helm_then(i, viewer.told[i]));
    status.push_back(status_then(i, viewer.told[i]));
  }
  welcome["helms"] = helms;
  welcome["status"] = status;
  const Around around = around_at(at_s);
  welcome["weather"] = viewer.weather_told = around.weather;
  welcome["traffic"] = viewer.traffic_told = around.traffic;
  viewer.around_at_s = at_s;
  viewer.around_at = clock();
  tell(viewer, welcome);
  send_frame(viewer, at_s);
}

/// All that is new at its head.
void Playback::show(Viewer& viewer) {
  const Milliseconds now = clock();
  const double at_s = viewer.head.at_s(now);
  for (const std::size_t by = run_.actions_by(at_s); viewer.actions_told < by;
       ++viewer.actions_told) {
    json told = action_json(run_.actions[viewer.actions_told]);
    told["is"] = "action";
    tell(viewer, told);
  }
  tell_vehicles(viewer, at_s);
  if (viewer.head.is_playing() && viewer.head.is_at_end(now)) viewer.around_at_s = constants::nan;
  tell_around(viewer, at_s);
  send_frame(viewer, at_s);
  if (viewer.head.is_playing() && viewer.head.is_at_end(now)) viewer.head.pause(now);
  tell_run(viewer);
}

void Playback::tell_vehicles(Viewer& viewer, double at_s) {
  const Moment moment = moment_of(run_.t_s, at_s);
  for (std::size_t i = 0; i < run_.vehicles.size(); ++i) {
    StatusPlace place = status_place(run_.vehicles[i], moment, at_s);
    if (place == viewer.told[i]) continue;
    if (place.helm != viewer.told[i].helm) tell(viewer, helm_then(i, place));
    tell(viewer, status_then(i, place));
    viewer.told[i] = std::move(place);
  }
}

void Playback::tell_run(Viewer& viewer) {
  json run = run_json(viewer);
  json same = run;
  same.erase("time_s");
  if (same == viewer.run_told) return;
  viewer.run_told = std::move(same);
  tell(viewer, run);
}

void Playback::send_frame(Viewer& viewer, double at_s) {
  const Moment moment = moment_of(run_.t_s, at_s);
  std::vector<Pose> poses;
  std::vector<std::uint16_t> there;
  for (const LoggedVehicle& vehicle : run_.vehicles)
    if (const auto pose = pose_at(vehicle.rows, moment)) {
      poses.push_back(*pose);
      there.push_back(pose->vehicle);
    }
  // What is left out of a frame is as it was: one that is not there any more is told by a whole
  // one.
  if (there != viewer.there) viewer.flow.begin_again();
  viewer.there = std::move(there);
  FrameHead head;
  head.time_s = at_s;
  if (run_.step_s > 0) head.step = static_cast<std::uint64_t>(std::llround(at_s / run_.step_s));
  head.clock_ms = static_cast<std::uint64_t>(clock());
  std::string frame = viewer.flow.next(poses, head);
  if (frame.empty()) return;
  viewer.is_frame_due = false;
  (void)viewer.socket->send({false, std::move(frame), nullptr, Worth::best_effort});
}

json Playback::run_json(const Viewer& viewer) const {
  return {{"is", "run"},
          {"state", "recorded"},
          {"by", nullptr},
          {"is_playing", viewer.head.is_playing()},
          {"rate", viewer.head.rate()},
          {"time_s", viewer.head.at_s(clock())}};
}

json Playback::vehicle_facts(std::size_t i) const {
  const LoggedVehicle& vehicle = run_.vehicles[i];
  VehicleNow at_home;
  at_home.home_m = vehicle.home_m;
  json facts = vehicle_json(vehicle.agent, i, at_home);
  if (vehicle.agent.vehicle->body.radius_m > 0) return facts;
  // Its model is not here: what is not known is not told.
  for (const char* const unknown : {"length_m", "width_m", "cruise_m_s"}) facts[unknown] = nullptr;
  facts["kind"] = "";
  return facts;
}

json Playback::status_then(std::size_t i, const StatusPlace& place) const {
  return status_json(i, vehicle_then(run_.vehicles[i], place));
}

json Playback::helm_then(std::size_t i, const StatusPlace& place) const {
  const LoggedHelm& helm = run_.vehicles[i].helms.at(std::max<std::size_t>(place.helm, 1) - 1);
  ShownHelm shown;
  shown.helm.state = helm.phase;
  shown.helm.agent = helm.holder;
  shown.helm.is_raw = helm.is_raw;
  shown.mode = helm.mode;
  shown.cause = helm.cause;
  json told = helm_json(i, shown);
  if (!helm.asker.empty()) told["asker"] = helm.asker;
  return told;
}

std::uint64_t Playback::number_of_last(std::size_t actions) const {
  return actions == 0 ? 0 : run_.actions[actions - 1].number;
}

void Playback::tick() {
  const std::lock_guard lock(mutex_);
  const Milliseconds now = clock();
  for (auto& [socket, viewer] : viewers_) {
    if (viewer.is_turned_out) continue;
    if (const auto why = overdue(viewer, viewer.has_said_hello, now))
      turn_out(viewer, *why);
    else if (viewer.has_said_hello && (viewer.head.is_playing() || viewer.is_frame_due))
      show(viewer);
  }
}

}  // namespace slackwater::people
