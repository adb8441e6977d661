#include "api/door/live/dds_door.h"

#include <algorithm>

#include "api/door/live/command_topics.h"
#include "api/door/live/profile_answer.h"
#include "api/door/live/reroute.h"
#include "fields/base/text.h"

namespace slackwater::live {
namespace {

dds::Bytes not_done(const std::string& text) { return dds::done_reply(false, text); }

/// The answer of a service that does something or says why not.
dds::Bytes done_or(const std::optional<std::string>& refusal, const std::string& done) {
  return refusal ? not_done(*refusal) : dds::done_reply(true, done);
}
dds::Bytes done_or(const std::optional<twin::Refusal>& refusal, const std::string& done) {
  return refusal ? not_done(refusal->text) : dds::done_reply(true, done);
}

}  // namespace

DdsDoor::DdsDoor(dds::Participant& participant, Stream& stream, CommandDoor& command_door,
                 DoorRun run)
    : participant_(participant),
      stream_(stream),
      command_door_(command_door),
      run_(std::move(run)),
      spawn_(participant, command_door.arbiter(), run_.newcomer_yard, run_.site) {
  participant_.on_lost([&command_door](const std::string& client) { command_door.lost(client); });
  open_run_services();
}

void DdsDoor::open(const std::string& name) {
  const std::size_t vehicle = actions_.size();
  open_topics(name, vehicle);
  open_vehicle_services(name, vehicle);
  actions_.emplace_back(participant_, stream_, command_door_, run_.place, name, vehicle);
  spawn_.open(name);
}

void DdsDoor::speak(std::span<const twin::AgentState> states, double t_s) {
  for (std::size_t i = 0; i < actions_.size(); ++i) actions_[i].speak(states[i], t_s);
  spawn_.speak();
  const std::uint64_t made = run_.steps_made();
  const std::lock_guard lock(mutex_);
  std::erase_if(waiting_, [&](const WaitingStep& step) {
    if (made < step.until) return false;
    step.answer(dds::step_reply(true));
    return true;
  });
}

void DdsDoor::serve(const std::string& name, const char* type, Handler handler,
                    std::function<dds::Bytes(const std::string&)> refusal) {
  participant_.serve({name, type}, [handler = std::move(handler), refusal = std::move(refusal)](
                                       dds::Payload request, const std::string& client,
                                       const dds::Answer& answer) {
    dds::Bytes reply;
    try {
      reply = handler(request, client);
    } catch (const std::exception& e) {
      reply = refusal(e.what());
    }
    answer(reply);
  });
}

void DdsDoor::open_run_services() {
  constexpr const char* trigger = "std_srvs/srv/Trigger";
  twin::CommandArbiter& arbiter = command_door_.arbiter();
  serve(
      "/slackwater/authority", "std_srvs/srv/SetBool",
      [&arbiter](dds::Payload request, const std::string& client) {
        const double now_s = arbiter.time_s();
        if (dds::read_set_bool(request))
          return done_or(arbiter.ask_for_run(client, now_s), "has the run: " + client);
        return done_or(arbiter.release_run(client, now_s), "given back");
      },
      not_done);
  serve(
      "/slackwater/allow_take_over", trigger,
      [&arbiter](dds::Payload request, const std::string& client) {
        dds::read_trigger(request);
        return done_or(arbiter.allow_run_take_over(client, arbiter.time_s()),
                       "another client may ask for it within 10 s");
      },
      not_done);
  serve(
      "/slackwater/pause", trigger,
      [this, &arbiter](dds::Payload request, const std::string& client) {
        dds::read_trigger(request);
        auto refusal = arbiter.claim_run(client, arbiter.time_s());
        if (!refusal) run_.control.pause();
        return done_or(refusal, "paused");
      },
      not_done);
  serve(
      "/slackwater/resume", trigger,
      [this, &arbiter](dds::Payload request, const std::string& client) {
        dds::read_trigger(request);
        auto refusal = arbiter.claim_run(client, arbiter.time_s());
        if (!refusal) run_.control.resume();
        return done_or(refusal, "goes on");
      },
      not_done);
  participant_.serve({"/slackwater/step", "slackwater_msgs/srv/Step"},
                     [this](dds::Payload request, const std::string& client,
                            const dds::Answer& answer) { take_step(request, client, answer); });
  serve(
      "/slackwater/query_profile", "slackwater_msgs/srv/QueryProfile",
      [this](dds::Payload request, const std::string&) {
        return profile_answer(run_.environment.field.get(), run_.environment.member,
                              dds::read_query_profile(request));
      },
      dds::profile_refusal);
}

/// Answered when the steps have been made, which a run that is not paused makes by itself.
void DdsDoor::take_step(dds::Payload request, const std::string& client,
                        const dds::Answer& answer) {
  constexpr std::uint32_t most = 1'000'000;
  std::uint32_t steps = 0;
  try {
    steps = dds::read_step(request);
  } catch (const std::exception&) {
    steps = 0;
  }
  if (steps == 0 || steps > most) return answer(dds::step_reply(false));
  twin::CommandArbiter& arbiter = command_door_.arbiter();
  if (arbiter.claim_run(client, arbiter.time_s())) return answer(dds::step_reply(false));
  const std::lock_guard lock(mutex_);
  if (const auto until = run_.control.allow_steps(steps))
    waiting_.push_back({*until, answer});
  else
    answer(dds::step_reply(false));
}

void DdsDoor::end_run(double t_s) {
  for (NavigateAction& action : actions_) action.end_run(t_s);
  spawn_.end_run();
  const std::lock_guard lock(mutex_);
  for (const WaitingStep& step : waiting_) step.answer(dds::step_reply(false));
  waiting_.clear();
}

void DdsDoor::open_topics(const std::string& name, std::size_t vehicle) {
  for (const CommandTopic& topic : command_topics()) {
    const bag::Channel channel{"/" + name + "/" + topic.name, topic.type, "", command_quality};
    participant_.subscribe_timed(
        channel, [this, vehicle, &topic](dds::Payload message, const std::string& client,
                                         double held_back_s) {
          hand_in(command_door_, client, vehicle, topic, message, held_back_s);
        });
  }
}

void DdsDoor::open_vehicle_services(const std::string& name, std::size_t vehicle) {
  twin::CommandArbiter& arbiter = command_door_.arbiter();
  serve(
      "/" + name + "/authority", "std_srvs/srv/SetBool",
      [&arbiter, vehicle](dds::Payload request, const std::string& client) {
        const double now_s = arbiter.time_s();
        if (dds::read_set_bool(request))
          // A client whose replies cannot be told from others' finds itself by its name.
          return done_or(arbiter.ask(client, vehicle, now_s), "at the helm: " + client);
        return done_or(arbiter.release(client, vehicle, now_s), "given back");
      },
      not_done);
  serve(
      "/" + name + "/allow_take_over", "std_srvs/srv/Trigger",
      [&arbiter, vehicle](dds::Payload request, const std::string& client) {
        dds::read_trigger(request);
        return done_or(arbiter.allow_take_over(client, vehicle, arbiter.time_s()),
                       "another client may ask for it within 10 s");
      },
      not_done);
  serve(
      "/" + name + "/resume_mission", "std_srvs/srv/Trigger",
      [this, vehicle](dds::Payload request, const std::string& client) {
        dds::read_trigger(request);
        return done_or(command_door_.submit(client, vehicle, twin::Resume{}).refusal,
                       "back on its own mission");
      },
      not_done);
  serve(
      "/" + name + "/set_waypoints", "slackwater_msgs/srv/SetWaypoints",
      [this, vehicle](dds::Payload request, const std::string& client) {
        const dds::WaypointsAsked asked = dds::read_set_waypoints(request);
        const twin::Reroute reroute = reroute_to(asked.places_m, asked.loop);
        const dds::Bytes heard = dds::active_waypoints(reroute.waypoints, {});
        return done_or(command_door_.submit(client, vehicle, reroute, heard).refusal,
                       formatted("{} waypoints", reroute.waypoints.size()));
      },
      not_done);
}

}  // namespace slackwater::live
