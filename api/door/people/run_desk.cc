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
constexpr double farthest_m = 1e6;
constexpr std::int64_t most_number = std::int64_t{1} << 53U;  // what JavaScript can count

const std::string supervisors = "the supervisors";

Said refused(RefusalReason reason, std::string text) {
  Said said;
  said.refused = Refusal{reason, std::move(text)};
  return said;
}

std::string words_of(const HelmNow& helm) { return std::string(name_of(helm.state)); }

twin::Triple<double> place_of(const StationSays& says) {
  return {says.number("north_m", -farthest_m, farthest_m),
          says.number("east_m", -farthest_m, farthest_m),
          -says.number("up_m", -farthest_m, farthest_m)};
}

}  // namespace

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
      {"waypoints", Role::drives, &RunDesk::waypoints},
      {"hold", Role::drives, &RunDesk::hold},
      {"home", Role::drives, &RunDesk::home},
      {"resume", Role::drives, &RunDesk::resume},
      {"take_back", Role::supervises, &RunDesk::take_back},
      {"pause", Role::supervises, &RunDesk::pause},
      {"go_on", Role::supervises, &RunDesk::go_on},
      {"step", Role::supervises, &RunDesk::step},
      {"spawn", Role::supervises, &RunDesk::spawn},
  };
  return deeds;
}

const RunDesk::Deed* RunDesk::deed_of(std::string_view what) noexcept {
  const auto found = std::find_if(deeds().begin(), deeds().end(),
                                  [&](const Deed& deed) { return deed.what == what; });
  return found == deeds().end() ? nullptr : &*found;
}

bool RunDesk::knows(std::string_view what) noexcept { return deed_of(what) != nullptr; }

Said RunDesk::handle(const Seat& seat, const StationSays& says, const Seats& seats,
                     const RunNow& run, Milliseconds now) {
  const Deed* deed = deed_of(says.what());
  if (deed == nullptr)
    return refused(RefusalReason::unreadable,
                   formatted("found \"{}\", which this session does not know", says.what()));
  if (seat.role < deed->least)
    return refused(RefusalReason::unauthorised,
                   formatted("{} needs the role of {}, and yours is {}", says.what(),
                             name_of(deed->least), name_of(seat.role)));
  return (this->*deed->act)(seat, says, seats, run, now);
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
  const auto found = numbers_.find(seat);
  return found == numbers_.end() ? 0 : found->second;
}

RunDesk::About RunDesk::about(const StationSays& says, const RunNow& run) const {
  const auto most = static_cast<std::int64_t>(std::min(agents_.size(), run.vehicles.size())) - 1;
  const auto place = static_cast<std::size_t>(says.whole("vehicle", 0, most));
  return {place, agents_[place], &run.vehicles[place]};
}

Said RunDesk::begun(const About& about) const {
  Said said;
  said.vehicle = about.agent->name;
  said.before = words_of(helms_.now(about.vehicle));
  return said;
}

std::optional<Refusal> RunDesk::stale(const Seat& seat, const StationSays& says, Milliseconds now,
                                      Milliseconds most_ahead) {
  const std::int64_t number = says.whole("number", 1, most_number);
  const std::int64_t until = says.whole("until", -most_number, most_number);
  std::int64_t& last = numbers_[seat.number];
  if (number <= last)
    return Refusal{RefusalReason::stale,
                   formatted("found command {} after {}; count on from the number in `welcome`",
                             number, last)};
  last = number;
  if (now > until)
    return Refusal{RefusalReason::stale,
                   formatted("found a command that was valid until {:.1f} s ago; it is not carried "
                             "out; check the link, and send a new one",
                             static_cast<double>(now - until) / 1000)};
  if (until > now + most_ahead)
    return Refusal{
        RefusalReason::stale,
        formatted("found a command that is valid for {:.1f} s, expected at most {:.1f} "
                  "s; set the station's clock by `time`",
                  static_cast<double>(until - now) / 1000, static_cast<double>(most_ahead) / 1000)};
  return std::nullopt;
}

std::optional<Refusal> RunDesk::no_helm(const Seat& seat, std::size_t vehicle) const {
  if (helms_.holds(seat, vehicle)) return std::nullopt;
  const HelmNow& helm = helms_.now(vehicle);
  const std::string whose = helm.seat != 0       ? formatted("seat {} has the helm", helm.seat)
                            : helm.agent.empty() ? "nobody has the helm"
                                                 : helm.agent + " has the helm";
  return Refusal{RefusalReason::unauthorised,
                 formatted("{} of {}; ask for it first", whose, helms_.name(vehicle))};
}

void RunDesk::submit(const Seat& seat, std::size_t vehicle, twin::CommandWhat what,
                     const RunNow& run, Milliseconds now, Said& said) {
  const std::string client = client_of(seat);
  twin::Command command;
  command.agent = vehicle;
  command.what = std::move(what);
  command.source = client;
  command.sequence = ++sequences_[client];
  command.received_s = hand_.arbiter.time_s();
  said.after = std::string(twin::name_of(command.what));
  said.refused = hand_.arbiter.submit(client, std::move(command), hand_.arbiter.time_s());
  if (said.refused) return;
  helms_.note_input(seat, vehicle, now);
  said.step = run.step + 1;
}

Said RunDesk::ask(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                  Milliseconds now) {
  const About of = about(says, run);
  Said said = begun(of);
  said.refused = helms_.ask(seat, of.vehicle, now);
  said.after = words_of(helms_.now(of.vehicle));
  return said;
}

Said RunDesk::give_back(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                        Milliseconds) {
  const About of = about(says, run);
  Said said = begun(of);
  said.refused = helms_.give_back(seat, of.vehicle);
  said.after = words_of(helms_.now(of.vehicle));
  return said;
}

Said RunDesk::allow(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                    Milliseconds now) {
  const About of = about(says, run);
  Said said = begun(of);
  said.refused = helms_.allow(seat, of.vehicle, now);
  said.after = words_of(helms_.now(of.vehicle));
  return said;
}

Said RunDesk::grant(const Seat& seat, const StationSays& says, const Seats& seats,
                    const RunNow& run, Milliseconds now) {
  const About of = about(says, run);
  Said said = begun(of);
  said.refused = helms_.grant(seat, of.vehicle, seats, now);
  said.after = words_of(helms_.now(of.vehicle));
  return said;
}

Said RunDesk::deny(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                   Milliseconds now) {
  const About of = about(says, run);
  Said said = begun(of);
  said.refused = helms_.deny(seat, of.vehicle, now);
  said.after = words_of(helms_.now(of.vehicle));
  return said;
}

/// The vehicle holds: whoever takes it back has not told it yet where to go.
Said RunDesk::take_back(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                        Milliseconds now) {
  const About of = about(says, run);
  const std::string reason = says.text("reason", 200);
  Said said = begun(of);
  said.refused = helms_.take_over(seat, of.vehicle, now);
  if (!said.refused) submit(seat, of.vehicle, twin::HoldHere{}, run, now, said);
  said.after = said.refused ? said.after : "held by the supervisor: " + reason;
  return said;
}

Said RunDesk::raw(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                  Milliseconds) {
  const About of = about(says, run);
  Said said = begun(of);
  const bool is_on = says.flag("is_on", true);
  said.refused = helms_.set_raw(seat, of.vehicle, is_on);
  said.after = is_on ? "raw thrusters" : "no raw thrusters";
  return said;
}

Said RunDesk::stick(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                    Milliseconds now) {
  const About of = about(says, run);
  Said said = begun(of);
  said.is_on_record = false;
  said.refused = stale(seat, says, now, stick_ahead_ms);
  if (!said.refused) said.refused = no_helm(seat, of.vehicle);
  if (said.refused) return said;
  const std::vector<double> asked = says.numbers("velocity", 4);
  if (asked.size() != 4)
    throw Error(ErrorKind::invalid_input,
                formatted("stick: velocity: found {} numbers, expected surge, sway, heave and yaw",
                          asked.size()));
  const twin::StickLimits limits{
      of.agent->conduct ? of.agent->conduct->plan.envelope : twin::Envelope(), of.now->home_m,
      of.agent->water->environment().structures};
  const twin::SharedStick shared =
      twin::shared_stick({asked[0], asked[1], asked[2], asked[3]}, of.now->known, limits);
  if (shared.is_slowed) said.shaped.emplace_back("speed");
  if (shared.is_kept_off) said.shaped.emplace_back("stand_off");
  if (shared.is_kept_in) said.shaped.emplace_back("fence");
  submit(seat, of.vehicle, twin::SetVelocity{shared.velocity}, run, now, said);
  return said;
}

Said RunDesk::thrusters(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                        Milliseconds now) {
  const About of = about(says, run);
  Said said = begun(of);
  said.is_on_record = false;
  said.refused = stale(seat, says, now, stick_ahead_ms);
  if (!said.refused) said.refused = no_helm(seat, of.vehicle);
  if (!said.refused && !helms_.now(of.vehicle).is_raw)
    said.refused = Refusal{RefusalReason::unauthorised,
                           "raw thrusters are not confirmed; neither clearance nor limits look at "
                           "them; confirm them first (`raw`)"};
  if (said.refused) return said;
  submit(seat, of.vehicle, twin::SetThrusters{says.numbers("share", twin::most_mounts)}, run, now,
         said);
  return said;
}

Said RunDesk::waypoints(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                        Milliseconds now) {
  const About of = about(says, run);
  Said said = begun(of);
  const bool is_trial = says.flag("is_trial", false);
  said.is_on_record = !is_trial;
  twin::Reroute reroute;
  for (const StationSays& place : says.list("places", most_places))
    reroute.waypoints.push_back({place_of(place), place.number("speed_m_s", 0, 100)});
  reroute.loop = says.flag("is_loop", false);
  if (is_trial) {
    twin::Command command;
    command.agent = of.vehicle;
    command.what = std::move(reroute);
    command.received_s = hand_.arbiter.time_s();
    said.refused = twin::refusal_of(command, *of.agent, hand_.arbiter.standing(of.vehicle),
                                    std::nullopt, command.received_s);
    return said;
  }
  said.refused = stale(seat, says, now, order_ahead_ms);
  if (!said.refused) said.refused = no_helm(seat, of.vehicle);
  if (said.refused) return said;
  const std::size_t count = reroute.waypoints.size();
  submit(seat, of.vehicle, std::move(reroute), run, now, said);
  said.after = formatted("{} waypoints", count);
  return said;
}

Said RunDesk::simple(const Seat& seat, const StationSays& says, const RunNow& run, Milliseconds now,
                     twin::CommandWhat what, bool needs_helm) {
  const About of = about(says, run);
  Said said = begun(of);
  said.refused = stale(seat, says, now, order_ahead_ms);
  if (!said.refused && needs_helm) said.refused = no_helm(seat, of.vehicle);
  if (!said.refused && !needs_helm && !helms_.holds(seat, of.vehicle))
    said.refused = helms_.take_over(seat, of.vehicle, now);
  if (said.refused) return said;
  submit(seat, of.vehicle, std::move(what), run, now, said);
  return said;
}

Said RunDesk::hold(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                   Milliseconds now) {
  return simple(seat, says, run, now, twin::HoldHere{}, seat.role != Role::supervises);
}

Said RunDesk::home(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                   Milliseconds now) {
  return simple(seat, says, run, now, twin::GoHome{}, true);
}

Said RunDesk::resume(const Seat& seat, const StationSays& says, const Seats&, const RunNow& run,
                     Milliseconds now) {
  return simple(seat, says, run, now, twin::Resume{}, true);
}

Said RunDesk::pause(const Seat& seat, const StationSays&, const Seats&, const RunNow&,
                    Milliseconds) {
  mind_run(true);
  Said said;
  said.before = hand_.control.is_paused() ? "paused" : "running";
  hand_.control.pause();
  paused_by_ = seat.name;
  said.after = "paused";
  return said;
}

Said RunDesk::go_on(const Seat&, const StationSays&, const Seats&, const RunNow&, Milliseconds) {
  mind_run(true);
  Said said;
  said.before = hand_.control.is_paused() ? "paused" : "running";
  hand_.control.resume();
  paused_by_.clear();
  said.after = "running";
  return said;
}

Said RunDesk::step(const Seat&, const StationSays& says, const Seats&, const RunNow&,
                   Milliseconds) {
  mind_run(true);
  const auto steps = static_cast<std::uint64_t>(says.whole("steps", 1, 100'000));
  Said said;
  said.step = hand_.control.allow_steps(steps);
  if (!said.step)
    said.refused = Refusal{RefusalReason::unauthorised, "the run is not paused; pause it first"};
  said.after = formatted("{} steps", steps);
  return said;
}

Said RunDesk::spawn(const Seat&, const StationSays& says, const Seats&, const RunNow& run,
                    Milliseconds) {
  mind_run(true);
  twin::Newcomer newcomer;
  newcomer.model = says.text("model", 100);
  newcomer.name = says.text("name", 100);
  newcomer.position_m = place_of(says);
  newcomer.heading_rad = says.number("heading_deg", -360, 360) * constants::degree;
  Said said;
  said.vehicle = newcomer.name;
  said.refused =
      hand_.arbiter.spawn(supervisors, newcomer, hand_.newcomer_yard, hand_.arbiter.time_s());
  said.after = "a " + newcomer.model + " joins";
  if (!said.refused) said.step = run.step + 1;
  return said;
}

}  // namespace slackwater::people
