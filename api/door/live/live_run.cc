#include "api/door/live/live_run.h"

#include <atomic>
#include <set>

#include "api/door/dds/message/names.h"
#include "api/door/live/command_door.h"
#include "api/door/live/dds_door.h"
#include "api/door/live/topics/alarm_publisher.h"
#include "api/door/live/topics/dds_outlet.h"
#include "api/door/live/topics/site_publisher.h"
#include "api/door/live/topics/vehicle_publisher.h"
#include "fields/base/text.h"
#include "fields/geo/geoid.h"
#include "twin/helm/command_arbiter.h"

namespace slackwater::live {
namespace {

RunPlace place_of(const api::RunInHand& hand, double step_s) {
  return {hand.start, hand.origin, geoid_height_m(hand.origin), step_s};
}

}  // namespace

std::vector<std::string> ros_names(std::span<const twin::Agent> agents) {
  std::vector<std::string> names;
  std::set<std::string> taken = reserved_names();
  for (const twin::Agent& agent : agents) {
    const std::string plain = dds::ros_token(agent.name);
    std::string name = plain;
    for (int n = 2; !taken.insert(lower_case(name)).second; ++n)
      name = plain + "_" + std::to_string(n);
    names.push_back(std::move(name));
  }
  return names;
}

struct LiveRun::Parts {
  Parts(const api::RunInHand& hand, const LiveSettings& settings)
      : run(hand.run),
        place(place_of(hand, hand.run.step_s())),
        on_newcomer(settings.on_newcomer),
        arbiter(hand.arbiter),
        command_door(stream, arbiter, place),
        record(hand.record, command_door),
        actions(stream, place, settings.actions, hand.record.actions),
        punctuality(settings.real_time_factor) {
    for (const auto& outlet : settings.outlets) stream.add(outlet);
    if (settings.domain) {
      dds::DomainSettings domain = *settings.domain;
      domain.on_trouble = settings.on_trouble;
      participant = std::make_unique<dds::Participant>(std::move(domain));
      stream.add(std::make_shared<DdsOutlet>(*participant));
    }
    site = std::make_unique<SitePublisher>(stream, place, dds::ros_token(settings.site),
                                           *hand.environment, hand.vessels);
    alarms = std::make_unique<AlarmPublisher>(stream, place, hand.watch, hand.vessels);
    if (participant) open_doors(hand, settings);
    open_for_all();
    if (!settings.see.sensors.empty()) {
      sensors = std::make_unique<SensorPublisher>(stream, place, hand, names, settings.see,
                                                  settings.on_picture, settings.on_trouble);
      stream.opened();
    }
    // At once, and not only in what is said at the end: a run may take hours.
    for (std::size_t i = 0; settings.on_trouble && i < hand.water.warnings.size(); ++i)
      settings.on_trouble(hand.water.warnings[i]);
    for (const auto& bag : settings.played_commands) {
      BagCommands& played = played_commands.emplace_back(bag, names, hand.scenario.duration_s,
                                                         command_door, settings.on_trouble);
      run.at_opening([&played](const twin::StepTime& time) { played.hand_in(time.start_s); });
    }
    speak();
    run.at_opening([this, &control = hand.control](const twin::StepTime&) {
      punctuality.begin(control.due(), Punctuality::WallClock::now());
    });
    run.at_barrier([this](const twin::StepTime&) { speak(); });
  }

  void open_doors(const api::RunInHand& hand, const LiveSettings& settings) {
    DoorRun door_run{hand.control,
                     *hand.environment,
                     place,
                     [this] { return made.load(); },
                     hand.newcomer_yard,
                     dds::ros_token(settings.site)};
    door = std::make_unique<DdsDoor>(*participant, stream, command_door, std::move(door_run));
    hosts = std::make_unique<HostLink>(
        *participant, run, hand.control, command_door, place, settings.when_host_fails,
        [this](const std::string& text) { participant->tell(text); });
  }

  /// Publishers, command door and doors of the vehicles that have none yet: all at the start, then
  /// those that join the run.
  void open_for_all() {
    const auto agents = run.agents();
    const auto states = run.states();
    const std::vector<std::string> all = ros_names(agents);
    for (std::size_t i = names.size(); i < agents.size(); ++i) {
      const std::string& name = names.emplace_back(all[i]);
      voices.emplace_back(stream, place, name, agents[i], states[i], run.time_s());
      alarms->open(name);
      command_door.open(name, agents[i].vehicle);
      if (door) door->open(name);
      if (hosts) hosts->open(name);
    }
    stream.opened();
  }
  void welcome_newcomers() {
    const std::size_t known = names.size();
    if (run.agents().size() == known) return;
    open_for_all();
    for (std::size_t i = known; on_newcomer && i < names.size(); ++i)
      on_newcomer(run.agents()[i], names[i]);
  }

  /// After each barrier: what was asked first, then what came of it.
  void speak() {
    const double t_s = run.time_s();
    made = run.steps_made();
    welcome_newcomers();
    record.hand_in(run.agents(), t_s);
    command_door.speak(t_s);
    actions.speak(t_s);
    const auto states = run.states();
    site->speak(run.seen(), t_s);
    alarms->speak(t_s);
    for (std::size_t i = 0; i < voices.size(); ++i)
      voices[i].speak(run.agents()[i], states[i], arbiter.holder(i), t_s);
    if (door) door->speak(states, t_s);
    if (sensors) sensors->speak(t_s);
  }

  twin::Run& run;
  RunPlace place;
  std::function<void(const twin::Agent&, const std::string&)> on_newcomer;
  std::vector<std::string> names;
  std::atomic<std::uint64_t> made{0};
  twin::CommandArbiter& arbiter;
  Stream stream;
  CommandDoor command_door;
  RecordTeller record;
  ActionTeller actions;
  Punctuality punctuality;
  std::unique_ptr<SitePublisher> site;
  std::unique_ptr<AlarmPublisher> alarms;
  std::deque<VehiclePublisher> voices;
  std::unique_ptr<SensorPublisher> sensors;
  std::deque<BagCommands> played_commands;
  std::unique_ptr<DdsDoor> door;
  std::unique_ptr<HostLink> hosts;
  std::unique_ptr<dds::Participant> participant;  ///< goes first: it calls all the others
};

LiveRun::LiveRun(const api::RunInHand& hand, const LiveSettings& settings)
    : parts_(std::make_unique<Parts>(hand, settings)) {}
LiveRun::~LiveRun() {
  parts_->actions.finish();
  (void)end_sensors();
  if (parts_->door) parts_->door->end_run(parts_->run.time_s());
}

std::vector<SensorTold> LiveRun::end_sensors() {
  if (!parts_->sensors) return {};
  parts_->sensors->finish(parts_->run.time_s());
  return parts_->sensors->told();
}

const std::vector<std::string>& LiveRun::names() const noexcept { return parts_->names; }
const Punctuality& LiveRun::punctuality() const noexcept { return parts_->punctuality; }

std::vector<PlayedBag> LiveRun::played() const {
  std::vector<PlayedBag> played;
  for (const BagCommands& bag : parts_->played_commands) played.push_back(bag.played());
  return played;
}
const RecordTold& LiveRun::record_told() const noexcept { return parts_->record.told(); }

}  // namespace slackwater::live
