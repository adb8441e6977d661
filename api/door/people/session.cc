#include "api/door/people/session.h"

#include "api/door/http/field_list.h"
#include "api/door/http/problem.h"
#include "api/door/http/trust.h"
#include "api/door/people/run_place.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::people {
namespace {

using api::http::Request;
using api::http::Response;
using api::http::WebSocket;
using api::http::Worth;
using nlohmann::json;

constexpr std::string_view bearer = "bearer.";
constexpr Milliseconds stick_pause_ms = 1'000;
constexpr Milliseconds lines_every_ms = 200, brief_thrusts_every_ms = 500;
/// A station that holds a helm and says nothing for so long is taken to be lost: pages say
/// something each two seconds.
constexpr Milliseconds unheard_ms = 5'000;
/// Of what a run as fast as it goes leaves for the session: more than its frames show.
constexpr auto look_every = std::chrono::milliseconds(10);

std::string token_in(const Request& request) {
  std::string token;
  api::http::for_each_item(request.protocols, [&](std::string_view name) {
    if (token.empty() && name.starts_with(bearer)) token = std::string(name.substr(bearer.size()));
  });
  return token;
}

}  // namespace

Session::Session(SessionSettings settings, TokenBook book)
    : settings_(std::move(settings)),
      began_(std::chrono::steady_clock::now()),
      seats_(std::move(book)),
      record_(settings_.keep),
      ticker_([this] {
        if (!tick()) return false;
        mind_farm();
        mind_inspections();
        return true;
      }) {}

Session::~Session() { end(); }

Milliseconds Session::clock() const {
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() -
                                                               began_)
      .count();
}

// --- the run ---

void Session::begin(const api::RunInHand& hand) {
  look_ = std::make_unique<RunLook>(hand);
  {
    const std::lock_guard lock(mutex_);
    now_ = look_->look();
    hand_.emplace(hand);
    desk_ = std::make_unique<RunDesk>(hand);
    desk_->mind_run(seats_.has(Role::supervises));
    barrier_at_ = clock();
    if (hand.environment->turbines)
      farm_ = std::make_shared<FarmOutput>(*hand.environment->turbines);
    json structures = json::array();
    const auto& standing = hand.environment->structures;
    for (std::size_t i = 0; i < standing.size(); ++i)
      structures.push_back(structure_json(standing[i], i));
    run_facts_ = {
        {"session", settings_.id},
        {"title", settings_.name},
        {"step_s", hand.run.step_s()},
        {"start", format_utc(hand.start)},
        {"origin", {{"lat", hand.origin.latitude_deg()}, {"lon", hand.origin.longitude_deg()}}},
        {"structures", structures}};
    run_facts_.update(place_facts(run_place(hand), places_of(hand.run.states())));
    begin_inspections();
  }
  hand.run.at_barrier(
      [this, &control = hand.control](const twin::StepTime&) { look_at_run(control); });
}

void Session::look_at_run(const twin::RunControl& control) {
  const auto now = std::chrono::steady_clock::now();
  // At the pace of a clock, and by hand, each barrier counts: it may be the last one for long.
  const bool is_racing = !control.due() && !control.is_paused();
  if (is_racing && now < looked_at_ + look_every) return;
  looked_at_ = now;
  RunNow seen = look_->look();
  const std::lock_guard lock(look_mutex_);
  left_ = std::move(seen);
}

void Session::end() {
  const std::lock_guard lock(mutex_);
  if (is_over_) return;
  for (auto& [socket, station] : stations_) end_stick(station);
  is_over_ = true;
  hand_.reset();
  desk_.reset();
  tell_run();
  for (auto& [socket, station] : stations_) turn_out(station, CloseCode::over, "the run is over");
}

// --- from the stations ---

std::vector<std::string> Session::protocols() const { return {std::string(protocol_name)}; }

std::optional<Response> Session::refusal_of(std::string_view token, const std::string& path) const {
  const std::lock_guard lock(mutex_);
  if (is_over_)
    return api::http::problem(410, "The run of this session is over; begin another one.", path);
  if (!hand_)
    return api::http::problem(503, "The run of this session has not begun; try again in a moment.",
                              path);
  if (auto no_seat = seats_.refusal(token, settings_.now()))
    return api::http::problem(no_seat->status, no_seat->text, path);
  return std::nullopt;
}

std::optional<Response> Session::refusal_to_read(std::string_view token,
                                                 const std::string& path) const {
  auto refused = refusal_of(token, path);
  if (refused && refused->status == 409) return std::nullopt;
  return refused;
}

json Session::summary() const {
  const std::lock_guard lock(mutex_);
  return {{"id", settings_.id},
          {"name", settings_.name},
          {"state", run_state()},
          {"seats", seats_.all().size()}};
}

std::optional<Response> Session::refusal(const Request& request) const {
  if (auto strange = refusal_of_origin(request)) return strange;
  return refusal_of(token_in(request), request.path);
}

void Session::opened(const std::shared_ptr<WebSocket>& socket, const Request& request,
                     const std::string&) {
  const std::lock_guard lock(mutex_);
  Station& station = stations_[socket.get()];
  station.socket = socket;
  station.token = token_in(request);
  station.since = station.heard_at = clock();
  if (is_over_) turn_out(station, CloseCode::over, "the run is over");
}

void Session::received_text(WebSocket& socket, std::string_view text) {
  const std::lock_guard lock(mutex_);
  const auto found = stations_.find(&socket);
  if (found == stations_.end() || found->second.is_turned_out) return;
  Station& station = found->second;
  station.heard_at = clock();
  if (station.is_unheard) {
    station.is_unheard = false;
    if (const Seat* seat = seats_.find(station.seat); desk_ && seat != nullptr)
      desk_->helms().back(*seat, station.heard_at);
  }
  const auto said = hear(station, text, station.heard_at);
  if (const auto* why = std::get_if<TurnOut>(&said)) return turn_out(station, why->code, why->text);
  const auto& says = std::get<StationSays>(said);
  try {
    heard(station, says);
  } catch (const Error& e) {
    tell(station, refused_json(says, "unreadable", e.message()));
  }
}

void Session::received_bytes(WebSocket& socket, std::span<const std::uint8_t>) {
  const std::lock_guard lock(mutex_);
  const auto found = stations_.find(&socket);
  if (found != stations_.end())
    turn_out(found->second, CloseCode::malformed,
             "found a binary message, expected JSON in text messages");
}

void Session::closed(WebSocket& socket) {
  const std::lock_guard lock(mutex_);
  const auto found = stations_.find(&socket);
  if (found == stations_.end()) return;
  Station& station = found->second;
  cut_off(station);
  stations_.erase(found);
}

/// Its seat is kept for a while, without it.
void Session::cut_off(Station& station) {
  end_stick(station);
  const unsigned number = std::exchange(station.seat, 0U);
  if (seats_.find(number) == nullptr) return;
  seats_.cut_off(number, clock());
  gathering_.gone(number);
  if (desk_) desk_->helms().lose(*seats_.find(number), clock(), seats_.find(number)->kept_until);
  Said said;
  said.after = "cut off";
  record(*seats_.find(number), "cut_off", said);
}

void Session::heard(Station& station, const StationSays& says) {
  const std::string& what = says.what();
  if (what == "hello") return hello(station, says);
  if (station.seat == 0)
    return turn_out(station, CloseCode::malformed, "found " + what + ", expected hello first");
  seats_.confirm(station.seat);
  if (keeps_in_touch(station, says, clock())) return;
  if (what == "look") return gathering_.look(*seats_.find(station.seat), says);
  if (what == "attend") return attend(station, says);
  if (Gathering::knows(what)) return gather(station, says);
  if (what == "say") {
    if (!station.deeds.take(clock())) return turn_out(station, CloseCode::too_many, many_deeds);
    const Seat& seat = *seats_.find(station.seat);
    if (seat.role == Role::looks_on)
      return tell(station, refused_json(says, twin::name_of(twin::RefusalReason::unauthorised),
                                        "say needs the role of operator, and yours is spectator"));
    const std::string text = says.text("text", 200);
    tell_all({{"is", "said"}, {"seat", seat.number}, {"text", text}});
    Said said;
    said.after = text;
    record(seat, "say", said);
    return tell(station, {{"is", "answer"}, {"id", says.id()}, {"taken", true}});
  }
  if (what == "leave") {
    const unsigned seat = station.seat;
    end_stick(station);
    station.seat = 0;
    drop_seat(seat, "left");
    station.is_turned_out = true;
    return station.socket->close(1000, "you left");
  }
  desk_work(station, says);
}

void Session::hello(Station& station, const StationSays& says) {
  if (station.seat != 0)
    throw Error(ErrorKind::invalid_input, "hello: found a second one; this station has its seat");
  const std::string name = says.text_or_empty("name", 100);
  const bool is_brief = says.flag("brief", false);
  auto outcome = seats_.take(station.token, name, settings_.now());
  if (const auto* none = std::get_if<NoSeat>(&outcome))
    return turn_out(station, CloseCode::token_ended, none->text);
  station.token.clear();
  const auto& taken = std::get<Seats::Taken>(outcome);
  for (auto& [socket, other] : stations_) {
    if (other.seat != taken.seat) continue;
    end_stick(other);
    other.seat = 0;
    turn_out(other, CloseCode::taken_up_elsewhere, "this seat was taken up at another station");
  }
  station.seat = taken.seat;
  station.flow.be_brief(is_brief);
  const Seat& seat = *seats_.find(taken.seat);
  if (desk_) {
    if (taken.is_back) desk_->helms().back(seat, clock());
    desk_->mind_run(seats_.has(Role::supervises));
  }
  Said said;
  said.after = taken.is_back ? "back" : "joined";
  record(seat, said.after == "back" ? "come_back" : "join", said);
  welcome(station, taken);
  tell_seats();
  tell_helms();
}

void Session::gather(Station& station, const StationSays& says) {
  if (!station.deeds.take(clock())) return turn_out(station, CloseCode::too_many, many_deeds);
  const Seat seat = *seats_.find(station.seat);
  const Said said = gathering_.handle(seat, says, now_);
  gathering_.mind(now_);
  record(seat, says.what(), said);
  if (said.refused)
    return tell(station,
                refused_json(says, twin::name_of(said.refused->reason), said.refused->text));
  tell(station, {{"is", "answer"}, {"id", says.id()}, {"taken", true}});
  tell_gathering();
}

void Session::desk_work(Station& station, const StationSays& says) {
  const Seat seat = *seats_.find(station.seat);
  const bool is_stick = says.what() == "stick" || says.what() == "thrusters";
  if (!is_stick && !says.flag("is_trial", false) && !station.deeds.take(clock()))
    return turn_out(station, CloseCode::too_many, many_deeds);
  if (!desk_) throw Error(ErrorKind::invalid_input, "the run is not under way");
  const Said said = desk_->handle({seat, says, seats_, now_, clock()});
  if (is_stick)
    note_stick(station, says, said);
  else if (said.is_on_record) {
    end_stick(station);
    record(seat, says.what(), said);
  }
  json answer{{"is", "answer"}, {"id", says.id()}, {"taken", !said.refused.has_value()}};
  if (said.refused) {
    answer["reason"] = twin::name_of(said.refused->reason);
    answer["text"] = said.refused->text;
  } else {
    if (said.step) answer["step"] = *said.step;
    if (!said.shaped.empty()) answer["shaped"] = said.shaped;
  }
  tell(station, answer);
  if (!is_stick) tell_helms();
}

void Session::turn_out(Station& station, CloseCode code, const std::string& text) {
  if (station.is_turned_out) return;
  people::turn_out(station, {code, text});
  // A socket may take long to close; what it was to the others ends now.
  if (!is_over_) cut_off(station);
}

void Session::drop_seat(unsigned number, const std::string& why) {
  const Seat* found = seats_.find(number);
  if (found == nullptr) return;
  const Seat seat = *found;
  for (auto& [socket, station] : stations_) {
    if (station.seat != number) continue;
    end_stick(station);
    station.seat = 0;
    turn_out(station, CloseCode::token_ended, "your token has ended");
  }
  if (desk_) {
    desk_->helms().gone(seat);
    desk_->forget(number);
  }
  Said said;
  said.after = why;
  record(seat, "leave", said);
  gathering_.gone(number);
  seats_.leave(number);
  if (desk_) desk_->mind_run(seats_.has(Role::supervises));
  tell_seats();
  tell_helms();
}

// --- twenty times a second ---

/// Wakes take milliseconds to work out: nobody waits for that.
void Session::mind_farm() {
  std::shared_ptr<FarmOutput> farm;
  Horizontal wind_m_s;
  {
    const std::lock_guard lock(mutex_);
    if (!farm_ || !now_.around || !now_.around->hub_wind_m_s) return;
    farm = farm_;
    wind_m_s = *now_.around->hub_wind_m_s;
  }
  const FarmNow now = farm->at(wind_m_s);
  const std::lock_guard lock(mutex_);
  farm_now_ = now;
}

bool Session::tick() {
  const std::lock_guard lock(mutex_);
  if (is_over_) return false;
  const Milliseconds now = clock();
  {
    const std::lock_guard look(look_mutex_);
    if (left_) {
      now_ = *std::exchange(left_, std::nullopt);
      gathering_.mind(now_);
      barrier_after_ = now - std::exchange(barrier_at_, now);
    }
  }
  for (auto& [socket, station] : stations_) {
    if (station.is_turned_out) continue;
    if (const auto why = overdue(station, station.seat != 0, now))
      turn_out(station, why->code, why->text);
    else if (!station.is_unheard && now > station.heard_at + unheard_ms) {
      station.is_unheard = true;
      if (const Seat* seat = seats_.find(station.seat); desk_ && seat != nullptr)
        desk_->helms().lose(*seat, now, std::nullopt);
    }
    if (station.stick && now > station.stick->last_at + stick_pause_ms) end_stick(station);
  }
  for (const unsigned seat : seats_.over(now, settings_.now()))
    drop_seat(seat, seats_.find(seat)->is_here ? "token ended" : "did not come back");
  if (desk_) {
    const std::size_t known = desk_->helms().size();
    desk_->open(std::span(now_.agents, now_.vehicles.size()));
    for (std::size_t i = known; i < desk_->helms().size(); ++i) {
      json told = vehicle_json(*desk_->agents()[i], i, now_.vehicles[i]);
      told["is"] = "vehicle";
      tell_all(told);
    }
    for (const HelmChange& change : desk_->helms().look(seats_, now)) {
      const Seat* seat = seats_.find(change.seat);
      if (seat == nullptr) continue;
      Said said;
      said.vehicle = desk_->helms().name(change.vehicle);
      said.after = name_of(desk_->helms().now(change.vehicle).state);
      record(*seat, change.what, said);
    }
  }
  const bool is_second = now >= second_at_ + 1'000;
  if (is_second) second_at_ = now;
  tell_seats();
  tell_helms();
  tell_status(is_second);
  if (now >= lines_at_ + lines_every_ms) {
    lines_at_ = now;
    tell_lines();
    tell_thrusts();
    tell_gathering();
  }
  if (now >= thrusts_at_ + brief_thrusts_every_ms) {
    thrusts_at_ = now;
    tell_thrusts_briefly();
  }
  tell_run();
  if (is_second) tell_around();
  std::vector<Pose> poses;
  for (const VehicleNow& vehicle : now_.vehicles) poses.push_back(vehicle.pose);
  for (auto& [socket, station] : stations_) {
    if (station.seat == 0 || station.is_turned_out) continue;
    FrameHead head;
    head.step = now_.step;
    head.time_s = now_.time_s;
    head.clock_ms = static_cast<std::uint64_t>(now);
    std::string frame = station.flow.next(poses, head);
    if (!frame.empty())
      (void)station.socket->send({false, std::move(frame), nullptr, Worth::best_effort});
    if (!is_second) continue;
    if (const std::uint32_t left_out = station.flow.take_left_out(); left_out > 0)
      tell(station, {{"is", "left_out"}, {"frames", left_out}});
  }
  return true;
}

}  // namespace slackwater::people
