#include "api/door/people/run_desk.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/agent/conduct.h"
#include "twin/helm/shared_stick.h"

namespace slackwater::people {
namespace {

using twin::Refusal;
using twin::RefusalReason;

constexpr std::size_t most_places = 200;
constexpr Milliseconds stick_ahead_ms = 1'000, order_ahead_ms = 5'000;
/// Between a station that set its clock by `time` and the session, over a slow link.
constexpr Milliseconds clocks_differ_ms = 500;
constexpr std::int64_t most_number = std::int64_t{1} << 53U;  // what JavaScript can count

const std::string supervisors = "the supervisors";

std::string words_of(const HelmNow& helm) { return std::string(name_of(helm.state)); }

std::string words_of(const twin::CameraPointing& camera) {
  return formatted("pan {:.0f} tilt {:.0f} deg, zoom {:.1f}", camera.pan_rad / constants::degree,
                   camera.tilt_rad / constants::degree, camera.zoom);
}

/// For the record: "wind 12.0 m/s from 240 deg, waves 2.0 m".
std::string words_of(const twin::WeatherAsked& asked) {
  std::vector<std::string> words;
  if (asked.wind_10m_m_s)
    words.push_back(formatted("wind {:.1f} m/s from {:.0f} deg", std::abs(*asked.wind_10m_m_s),
                              from_direction_deg(*asked.wind_10m_m_s)));
  if (asked.significant_wave_height_m)
    words.push_back(formatted("waves {:.1f} m", *asked.significant_wave_height_m));
  if (asked.current_m_s)
    words.push_back(formatted("current {:.2f} m/s to {:.0f} deg", std::abs(*asked.current_m_s),
                              to_direction_deg(*asked.current_m_s)));
  if (asked.visibility_m) words.push_back(formatted("visibility {:.0f} m", *asked.visibility_m));
  if (asked.water_visibility_m)
    words.push_back(formatted("visibility under water {:.1f} m", *asked.water_visibility_m));
  return words.empty() ? "as the run has it" : joined(words, ", ");
}

}  // namespace

Said refused(RefusalReason reason, std::string text) {
  Said said;
  said.refused = Refusal{reason, std::move(text)};
  return said;
}

twin::Triple<double> place_of(const StationSays& says) {
  return {says.number("north_m", -farthest_m, farthest_m),
          says.number("east_m", -farthest_m, farthest_m),
          -says.number("up_m", -farthest_m, farthest_m)};
}

RunDesk::RunDesk(const api::RunInHand& hand) : hand_(hand), helms_(hand.arbiter) {
  open(hand.run.agents());
}

void RunDesk::open(std::span<const twin::Agent> agents) {
  for (std::size_t i = helms_.size(); i < agents.size(); ++i) {
    helms_.open(agents[i].name);
    agents_.push_back(&agents[i]);
  }
}

const std::vector<RunDesk::Deed>& RunDesk::deeds() {
  static const std::vector<Deed> deeds{
      {"ask", Role::drives, &RunDesk::ask},
      {"give_back", Role::drives, &RunDesk::give_back},
      {"allow", Role::drives, &RunDesk::allow},
      {"grant", Role::drives, &RunDesk::grant},
      {"deny", Role::drives, &RunDesk::deny},
      {"raw", Role::drives, &RunDesk::raw},
      {"stick", Role::drives, &RunDesk::stick},
      {"thrusters", Role::drives, &RunDesk::thrusters},
      {"camera", Role::drives, &RunDesk::camera},
      {"waypoints", Role::drives, &RunDesk::waypoints},
      {"hold", Role::drives, &RunDesk::hold},
      {"home", Role::drives, &RunDesk::home},
      {"resume", Role::drives, &RunDesk::resume},
      {"take_back", Role::supervises, &RunDesk::take_back},
      {"pause", Role::supervises, &RunDesk::pause},
      {"go_on", Role::supervises, &RunDesk::go_on},
      {"step", Role::supervises, &RunDesk::step},
      {"spawn", Role::supervises, &RunDesk::spawn},
      {"weather", Role::supervises, &RunDesk::weather},
  };
  return deeds;
}

const RunDesk::Deed* RunDesk::deed_of(std::string_view what) noexcept {
  const auto found = std::find_if(deeds().begin(), deeds().end(),
                                  [&](const Deed& deed) { return deed.what == what; });
  return found == deeds().end() ? nullptr : &*found;
}

Said RunDesk::handle(const Asked& asked) {
  const std::string& what = asked.says.what();
  const Deed* deed = deed_of(what);
  if (deed == nullptr)
    return refused(RefusalReason::unreadable,
                   formatted("found \"{}\", which this session does not know; its words are in "
                             "api/docs/session_wire.md",
                             what));
  if (asked.seat.role < deed->least)
    return refused(RefusalReason::unauthorised,
                   formatted("{} needs the role of {}, and yours is {}", what, name_of(deed->least),
                             name_of(asked.seat.role)));
  return (this->*deed->act)(asked);
}

void RunDesk::mind_run(bool has_supervisor) {
  if (has_supervisor == has_run_ && (!has_run_ || hand_.arbiter.run_holder() == supervisors))
    return;
  if (has_supervisor)
    hand_.arbiter.take_over_run(supervisors, hand_.arbiter.time_s());
  else
    (void)hand_.arbiter.release_run(supervisors, hand_.arbiter.time_s());
  has_run_ = has_supervisor;
}

std::int64_t RunDesk::last_number(unsigned seat) const {
  const auto found = counts_.find(seat);
  return found == counts_.end() ? 0 : found->second.number;
}

RunDesk::About RunDesk::about(const Asked& asked) const {
  const std::vector<VehicleNow>& vehicles = asked.run.vehicles;
  const auto most = static_cast<std::int64_t>(std::min(agents_.size(), vehicles.size())) - 1;
  const auto place = static_cast<std::size_t>(asked.says.whole("vehicle", 0, most));
  return {place, agents_[place], &vehicles[place]};
}

Said RunDesk::begun(const About& about) const {
  Said said;
  said.vehicle = about.agent->name;
  said.before = words_of(helms_.now(about.vehicle));
  return said;
}

std::optional<Refusal> RunDesk::stale(const Asked& asked, Milliseconds most_ahead) {
  const std::int64_t number = asked.says.whole("number", 1, most_number);
  const std::int64_t at = asked.says.whole("at", -most_number, most_number);
  const std::int64_t until = asked.says.whole("until", -most_number, most_number);
  std::int64_t& last = counts_[asked.seat.number].number;
  if (number <= last)
    return Refusal{RefusalReason::stale,
                   formatted("found command {} after {}; count on from the number in `welcome`",
                             number, last)};
  last = number;
  if (asked.now > until)
    return Refusal{RefusalReason::stale,
                   formatted("found a command that was valid until {:.1f} s ago; it is not carried "
                             "out; check the link, and send a new one",
                             seconds(asked.now - until))};
  if (until - at > most_ahead)
    return Refusal{RefusalReason::stale,
                   formatted("found a command that is valid for {:.1f} s, expected at most {:.1f} "
                             "s; give it a shorter `until`",
                             seconds(until - at), seconds(most_ahead))};
  if (at > asked.now + clocks_differ_ms)
    return Refusal{RefusalReason::stale,
                   formatted("found a command given {:.1f} s from now; set the station's clock by "
                             "`time`",
                             seconds(at - asked.now))};
  return std::nullopt;
}

std::optional<Refusal> RunDesk::no_helm(const Asked& asked, std::size_t vehicle) const {
  if (helms_.holds(asked.seat, vehicle)) return std::nullopt;
  const HelmNow& helm = helms_.now(vehicle);
  const Seat* holder = asked.seats.find(helm.seat);
  const std::string whose = holder != nullptr ? formatted("{} in seat {}", holder->name, helm.seat)
                            : helm.agent.empty() ? "nobody"
                                                 : helm.agent;
  return Refusal{RefusalReason::unauthorised,
                 formatted("{} has the helm of {}; ask for it first", whose, helms_.name(vehicle))};
}

/// A supervisor directs whatever no person drives, and has its helm from then on.
std::optional<Refusal> RunDesk::no_say(const Asked& asked, std::size_t vehicle) {
  const bool is_nobodys = helms_.now(vehicle).seat == 0;
  if (asked.seat.role == Role::supervises && is_nobodys)
    return helms_.take_over(asked.seat, vehicle, asked.now);
  return no_helm(asked, vehicle);
}

void RunDesk::submit(const Asked& asked, std::size_t vehicle, twin::CommandWhat what, Said& said) {
  const std::string client = client_of(asked.seat);
  twin::Command command;
  command.agent = vehicle;
  command.what = std::move(what);
  command.source = client;
  command.sequence = ++counts_[asked.seat.number].sequence;
  command.received_s = hand_.arbiter.time_s();
  said.after = std::string(twin::name_of(command.what));
  said.refused = hand_.arbiter.submit(client, std::move(command), hand_.arbiter.time_s());
  if (said.refused) return;
  helms_.note_input(asked.seat, vehicle, asked.now);
  said.step = asked.run.step + 1;
}

template <typename Act>
Said RunDesk::of_helm(const Asked& asked, const Act& act) {
  const About of = about(asked);
  Said said = begun(of);
  said.refused = act(of.vehicle);
  said.after = words_of(helms_.now(of.vehicle));
  return said;
}

Said RunDesk::ask(const Asked& asked) {
  return of_helm(asked, [&](std::size_t i) { return helms_.ask(asked.seat, i, asked.now); });
}
Said RunDesk::give_back(const Asked& asked) {
  return of_helm(asked, [&](std::size_t i) { return helms_.give_back(asked.seat, i); });
}
Said RunDesk::allow(const Asked& asked) {
  return of_helm(asked, [&](std::size_t i) { return helms_.allow(asked.seat, i, asked.now); });
}
Said RunDesk::grant(const Asked& asked) {
  return of_helm(
      asked, [&](std::size_t i) { return helms_.grant(asked.seat, i, asked.seats, asked.now); });
}
Said RunDesk::deny(const Asked& asked) {
  return of_helm(asked, [&](std::size_t i) { return helms_.deny(asked.seat, i, asked.now); });
}

/// The vehicle holds: whoever takes it back has not told it yet where to go.
Said RunDesk::take_back(const Asked& asked) {
  const std::string reason = asked.says.text("reason", 200);
  const About of = about(asked);
  Said said = begun(of);
  said.refused = helms_.take_over(asked.seat, of.vehicle, asked.now);
  if (said.refused) return said;
  Said hold;  // of a vehicle that cannot hold the helm is taken all the same
  submit(asked, of.vehicle, twin::HoldHere{}, hold);
  said.step = hold.step;
  said.after = "held by the supervisor: " + reason;
  if (hold.refused) said.after += "; it does not hold: " + hold.refused->text;
  said.why = reason;
  return said;
}

Said RunDesk::raw(const Asked& asked) {
  const bool is_on = asked.says.flag("is_on", true);
  Said said = of_helm(asked, [&](std::size_t i) { return helms_.set_raw(asked.seat, i, is_on); });
  said.after = is_on ? "raw thrusters" : "no raw thrusters";
  return said;
}

Said RunDesk::stick(const Asked& asked) {
  const About of = about(asked);
  Said said = begun(of);
  said.is_on_record = false;
  said.refused = stale(asked, stick_ahead_ms);
  if (!said.refused) said.refused = no_helm(asked, of.vehicle);
  if (said.refused) return said;
  const std::vector<double> wanted = asked.says.numbers("velocity", 4);
  if (wanted.size() != 4)
    throw Error(ErrorKind::invalid_input,
                formatted("stick: velocity: found {} numbers, expected surge, sway, heave and yaw",
                          wanted.size()));
  const twin::StickLimits limits{
      of.agent->conduct ? of.agent->conduct->plan.envelope : twin::Envelope(), of.now->home_m,
      of.agent->water->environment().structures};
  const twin::SharedStick shared =
      twin::shared_stick({wanted[0], wanted[1], wanted[2], wanted[3]}, of.now->known, limits);
  if (shared.is_slowed) said.shaped.emplace_back("speed");
  if (shared.is_kept_off) said.shaped.emplace_back("stand_off");
  if (shared.is_kept_in) said.shaped.emplace_back("fence");
  submit(asked, of.vehicle, twin::SetVelocity{shared.velocity}, said);
  return said;
}

Said RunDesk::thrusters(const Asked& asked) {
  const About of = about(asked);
  Said said = begun(of);
  said.is_on_record = false;
  said.refused = stale(asked, stick_ahead_ms);
  if (!said.refused) said.refused = no_helm(asked, of.vehicle);
  if (!said.refused && !helms_.now(of.vehicle).is_raw)
    said.refused = Refusal{RefusalReason::unauthorised,
                           "raw thrusters are not confirmed; neither clearance nor limits look at "
                           "them; confirm them first (`raw`)"};
  if (said.refused) return said;
  submit(asked, of.vehicle, twin::SetThrusters{asked.says.numbers("share", twin::most_mounts)},
         said);
  return said;
}

Said RunDesk::waypoints(const Asked& asked) {
  const About of = about(asked);
  Said said = begun(of);
  const bool is_trial = asked.says.flag("is_trial", false);
  said.is_on_record = !is_trial;
  twin::Reroute reroute;
  for (const StationSays& place : asked.says.list("places", most_places))
    reroute.waypoints.push_back({place_of(place), place.number("speed_m_s", 0, 100)});
  reroute.loop = asked.says.flag("is_loop", false);
  if (is_trial) {
    twin::Command command;
    command.agent = of.vehicle;
    command.what = std::move(reroute);
    command.received_s = hand_.arbiter.time_s();
    said.refused = twin::refusal_of(command, *of.agent, hand_.arbiter.standing(of.vehicle),
                                    std::nullopt, command.received_s);
    return said;
  }
  said.refused = stale(asked, order_ahead_ms);
  if (!said.refused) said.refused = no_say(asked, of.vehicle);
  if (said.refused) return said;
  const std::size_t count = reroute.waypoints.size();
  submit(asked, of.vehicle, std::move(reroute), said);
  said.after = formatted("{} waypoints", count);
  return said;
}

Said RunDesk::order(const Asked& asked, twin::CommandWhat what, bool needs_helm) {
  const About of = about(asked);
  Said said = begun(of);
  said.refused = stale(asked, order_ahead_ms);
  if (!said.refused && needs_helm) said.refused = no_say(asked, of.vehicle);
  if (!said.refused && !needs_helm && !helms_.holds(asked.seat, of.vehicle))
    said.refused = helms_.take_over(asked.seat, of.vehicle, asked.now);
  if (!said.refused) submit(asked, of.vehicle, std::move(what), said);
  return said;
}

Said RunDesk::hold(const Asked& asked) {
  return order(asked, twin::HoldHere{}, asked.seat.role != Role::supervises);
}
Said RunDesk::home(const Asked& asked) { return order(asked, twin::GoHome{}, true); }
Said RunDesk::resume(const Asked& asked) { return order(asked, twin::Resume{}, true); }

Said RunDesk::camera(const Asked& asked) {
  const twin::CameraPointing pointing{asked.says.number("pan_deg", -180, 180) * constants::degree,
                                      asked.says.number("tilt_deg", -90, 90) * constants::degree,
                                      asked.says.number("zoom", 1, twin::most_zoom)};
  Said said = order(asked, twin::PointCamera{pointing}, true);
  said.before = words_of(asked.run.vehicles.at(about(asked).vehicle).camera);
  said.after = words_of(pointing);
  return said;
}

/// All of it at once: what a message leaves out is as the run has it by itself.
Said RunDesk::weather(const Asked& asked) {
  const StationSays& says = asked.says;
  twin::WeatherAsked wanted;
  if (const auto wind = says.object_if("wind"))
    wanted.wind_10m_m_s = vector_from_direction(wind->number("speed_m_s", 0, 1000),
                                                wind->number("from_deg", -360, 360));
  if (const auto current = says.object_if("current"))
    wanted.current_m_s = vector_to_direction(current->number("speed_m_s", 0, 1000),
                                             current->number("to_deg", -360, 360));
  wanted.significant_wave_height_m = says.number_if("waves_m", 0, 1000);
  wanted.visibility_m = says.number_if("visibility_m", 0, 1e9);
  wanted.water_visibility_m = says.number_if("water_visibility_m", 0, 1e9);
  wanted.over_s = says.number_if("over_s", 0, 1e9).value_or(wanted.over_s);
  Said said;
  said.before = asked.run.around ? words_of(asked.run.around->asked) : std::string();
  said.after = words_of(wanted);
  said.refused = hand_.arbiter.set_weather(supervisors, wanted, hand_.arbiter.time_s());
  if (said.refused) return said;
  weather_by_ = asked.seat.name;
  said.step = asked.run.step + 1;
  return said;
}

Said RunDesk::pause(const Asked& asked) {
  Said said;
  said.before = hand_.control.is_paused() ? "paused" : "running";
  hand_.control.pause();
  paused_by_ = asked.seat.name;
  said.after = "paused";
  return said;
}

Said RunDesk::go_on(const Asked&) {
  Said said;
  said.before = hand_.control.is_paused() ? "paused" : "running";
  hand_.control.resume();
  paused_by_.clear();
  said.after = "running";
  return said;
}

Said RunDesk::step(const Asked& asked) {
  const auto steps = static_cast<std::uint64_t>(asked.says.whole("steps", 1, 100'000));
  Said said;
  said.step = hand_.control.allow_steps(steps);
  if (!said.step)
    said.refused = Refusal{RefusalReason::unauthorised, "the run is not paused; pause it first"};
  said.after = formatted("{} steps", steps);
  return said;
}

Said RunDesk::spawn(const Asked& asked) {
  twin::Newcomer newcomer;
  newcomer.model = asked.says.text("model", 100);
  newcomer.name = asked.says.text("name", 100);
  newcomer.position_m = place_of(asked.says);
  newcomer.heading_rad = asked.says.number("heading_deg", -360, 360) * constants::degree;
  Said said;
  said.vehicle = newcomer.name;
  said.refused =
      hand_.arbiter.spawn(supervisors, newcomer, hand_.newcomer_yard, hand_.arbiter.time_s());
  said.after = "a " + newcomer.model + " joins";
  if (!said.refused) said.step = asked.run.step + 1;
  return said;
}

}  // namespace slackwater::people
