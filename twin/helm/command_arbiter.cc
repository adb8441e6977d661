#include "twin/helm/command_arbiter.h"

#include <algorithm>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/agent/aboard.h"
#include "twin/agent/helm.h"
#include "twin/run/printable.h"

namespace slackwater::twin {
namespace {

Keeping keeping_of(const CommandWhat& what) {
  if (must_be_renewed(what)) return Keeping::renewed;
  if (const auto* reroute = std::get_if<Reroute>(&what))
    return reroute->loop ? Keeping::loop : Keeping::waypoints;
  return Keeping::asked;
}

Standing standing_of(const Run& run, std::size_t vehicle) {
  const HelmState& helm = run.helm(vehicle);
  const ConductState& own = run.conduct(vehicle);
  Standing standing;
  standing.halt = run.seen(vehicle).halt;
  standing.halted_at_s = run.seen(vehicle).halted_at_s;
  standing.is_aboard = own.is_aboard && !is_recovered(run.agents()[vehicle], own);
  standing.must_come_home = run.must_come_home(vehicle);
  standing.energy_left_j = own.energy_left_j;
  standing.energy_home_j = own.energy_home_j;
  standing.mode = helm.mode;
  standing.cause = helm.cause;
  return standing;
}

}  // namespace

CommandArbiter::CommandArbiter(Run& run, const RefusalLimits& limits)
    : run_(run), limits_(limits), authority_(0), time_s_(run.time_s()) {
  know_newcomers();
  run.at_opening([this](const StepTime&) { open(); });
  run.at_barrier([this](const StepTime& time) { look(time.end_s()); });
}

std::optional<Refusal> CommandArbiter::submit(std::string_view client, Command command,
                                              double now_s) {
  const std::size_t vehicle = command.agent;
  const Agent* const found = agent(vehicle);
  if (found == nullptr) return counted_unknown(client, vehicle, now_s);
  const Agent& agent = *found;
  command.source = printable(command.source.empty() ? client : command.source);
  Standing standing;
  std::optional<std::uint64_t> last;
  {
    const std::lock_guard lock(mutex_);
    // Before what takes long to look at.
    if (auto refusal = refusal_to(client, vehicle, now_s))
      return count(client, agent.name, std::move(*refusal), now_s);
    standing = standing_[vehicle];
    last = last_sequence(client, vehicle);
  }
  // Water and structures are looked at without keeping anybody waiting.
  auto refusal = refusal_of(command, agent, standing, last, now_s, limits_);
  const std::lock_guard lock(mutex_);
  if (!refusal) {
    refusal = refusal_to(client, vehicle, now_s);
    if (!refusal && last_sequence(client, vehicle) != last)  // another thread was faster
      refusal = refusal_of(command, agent, standing_[vehicle], last_sequence(client, vehicle),
                           now_s, limits_);
  }
  if (refusal) return count(client, agent.name, std::move(*refusal), now_s);
  // Who turns a camera tells the vehicle nothing.
  if (!std::holds_alternative<PointCamera>(command.what))
    authority_.note_command(client, vehicle, keeping_of(command.what), now_s);
  if (std::holds_alternative<Resume>(command.what)) authority_.end(vehicle);
  last_sequence_.insert_or_assign({std::string(client), vehicle}, command.sequence);
  taken_[vehicle].note(openings_);
  ++taken_[vehicle].all;
  run_.enqueue(std::move(command));
  return std::nullopt;
}

void CommandArbiter::Taken::note(std::uint64_t now) noexcept {
  if (opening != now) at_once = 0;
  opening = now;
  ++at_once;
}

/// What speaks against any command of the client now.
std::optional<Refusal> CommandArbiter::refusal_to(std::string_view client, std::size_t vehicle,
                                                  double now_s) const {
  const std::string& name = agents_[vehicle]->name;
  if (auto held = authority_.refusal(client, vehicle, name, now_s))
    return Refusal{RefusalReason::unauthorised, std::move(*held)};
  const Taken& taken = taken_[vehicle];
  if (taken.opening == openings_ && taken.at_once >= limits_.most_at_once)
    return Refusal{RefusalReason::too_many,
                   formatted("found {} commands for {} that wait for its next step, the most that "
                             "may wait; send the next one after that step",
                             taken.at_once, name)};
  return std::nullopt;
}

std::optional<Refusal> CommandArbiter::spawn(std::string_view client, const Newcomer& newcomer,
                                             const NewcomerYard& newcomer_yard, double now_s) {
  Command command;
  command.source = printable(client);
  command.received_s = now_s;
  std::optional<Refusal> refusal;
  {
    const std::lock_guard lock(mutex_);
    if (auto against = run_authority_.refusal(client, other_at_helm(client), now_s))
      refusal = Refusal{RefusalReason::unauthorised, std::move(*against)};
    else
      refusal = look_at_name(newcomer.name);
  }
  if (!refusal) {
    try {
      command.what = Spawn{newcomer, newcomer_yard.ready(newcomer, now_s)};
    } catch (const Error& e) {
      const bool is_unknown = e.kind() == ErrorKind::not_found;
      refusal =
          Refusal{is_unknown ? RefusalReason::unknown_model : RefusalReason::no_place, e.message()};
    }
  }
  const std::lock_guard lock(mutex_);
  if (!refusal) refusal = look_at_name(newcomer.name);  // another thread was faster
  if (!refusal)
    if (auto against = run_authority_.claim(client, other_at_helm(client), now_s))
      refusal = Refusal{RefusalReason::unauthorised, std::move(*against)};
  if (refusal) return count(client, newcomer.name, std::move(*refusal), now_s);
  coming_.push_back(newcomer.name);
  run_.enqueue(std::move(command));
  return std::nullopt;
}

std::optional<Refusal> CommandArbiter::set_weather(std::string_view client,
                                                   const WeatherAsked& asked, double now_s) {
  Command command;
  command.source = printable(client);
  command.received_s = now_s;
  command.what = SetWeather{asked};
  const std::lock_guard lock(mutex_);
  std::optional<Refusal> refusal;
  if (auto against = run_authority_.claim(client, other_at_helm(client), now_s))
    refusal = Refusal{RefusalReason::unauthorised, std::move(*against)};
  else if (std::string problem = problem_of(asked, agents_.front()->water->environment());
           !problem.empty())
    refusal = Refusal{RefusalReason::out_of_range, std::move(problem)};
  if (refusal) return count(client, std::string(RunAuthority::name), std::move(*refusal), now_s);
  run_.enqueue(std::move(command));
  return std::nullopt;
}

std::optional<Refusal> CommandArbiter::look_at_name(const std::string& name) const {
  const auto is_taken = [&](const Agent* agent) { return agent->name == name; };
  if (name.empty() || name != printable(name))
    return Refusal{RefusalReason::bad_name,
                   formatted("name: found '{}', expected 1 to 200 letters of ASCII; give the "
                             "vehicle such a name",
                             printable(name))};
  if (std::any_of(agents_.begin(), agents_.end(), is_taken) ||
      std::find(coming_.begin(), coming_.end(), name) != coming_.end())
    return Refusal{RefusalReason::bad_name,
                   formatted("name: {} is taken; give the vehicle another one", name)};
  const std::size_t most = run_.most_vehicles();
  if (agents_.size() + coming_.size() >= most)
    return Refusal{
        RefusalReason::too_many,
        formatted("found {} vehicles, the most that this run can hold; begin another run", most)};
  return std::nullopt;
}

std::optional<Refusal> CommandArbiter::ask(std::string_view client, std::size_t vehicle,
                                           double now_s) {
  return with_vehicle(client, vehicle, now_s, [&](const std::string& name) {
    return authority_.ask(client, vehicle, name, now_s);
  });
}

std::optional<Refusal> CommandArbiter::release(std::string_view client, std::size_t vehicle,
                                               double now_s) {
  return with_vehicle(client, vehicle, now_s, [&](const std::string& name) {
    const Keeping keeping = authority_.keeping(vehicle);
    auto answer = authority_.release(client, vehicle, name, now_s);
    if (!answer && (keeping == Keeping::renewed || keeping == Keeping::loop))
      enqueue_hold(client, vehicle, now_s);
    return answer;
  });
}

std::optional<Refusal> CommandArbiter::allow_take_over(std::string_view client, std::size_t vehicle,
                                                       double now_s) {
  return with_vehicle(client, vehicle, now_s, [&](const std::string& name) {
    return authority_.allow_take_over(client, vehicle, name, now_s);
  });
}

std::optional<Refusal> CommandArbiter::ask_for_lease(std::string_view client, std::size_t vehicle,
                                                     double now_s) {
  return with_vehicle(client, vehicle, now_s, [&](const std::string& name) {
    auto answer = authority_.ask(client, vehicle, name, now_s);
    if (!answer) authority_.lease(client, vehicle, now_s);
    return answer;
  });
}

std::optional<Refusal> CommandArbiter::take_over(std::string_view client, std::size_t vehicle,
                                                 double now_s) {
  return with_vehicle(client, vehicle, now_s, [&](const std::string&) {
    authority_.lease(client, vehicle, now_s);
    return std::optional<std::string>();
  });
}

void CommandArbiter::take_over_run(std::string_view client, double now_s) {
  const std::lock_guard lock(mutex_);
  run_authority_.take_over(client, now_s);
}

void CommandArbiter::unheard(std::string_view client, std::size_t vehicle, double now_s) {
  const std::lock_guard lock(mutex_);
  authority_.look(now_s);
  if (!client.empty() && authority_.holder(vehicle) == client) enqueue_hold(client, vehicle, now_s);
}

std::optional<Refusal> CommandArbiter::ask_for_run(std::string_view client, double now_s) {
  return with_run(client, now_s, [&] { return run_authority_.ask(client, now_s); });
}

std::optional<Refusal> CommandArbiter::release_run(std::string_view client, double now_s) {
  return with_run(client, now_s, [&] { return run_authority_.release(client, now_s); });
}

std::optional<Refusal> CommandArbiter::allow_run_take_over(std::string_view client, double now_s) {
  return with_run(client, now_s, [&] { return run_authority_.allow_take_over(client, now_s); });
}

std::optional<Refusal> CommandArbiter::claim_run(std::string_view client, double now_s) {
  return with_run(client, now_s,
                  [&] { return run_authority_.claim(client, other_at_helm(client), now_s); });
}

std::string CommandArbiter::run_holder() const {
  const std::lock_guard lock(mutex_);
  return run_authority_.holder();
}

std::string CommandArbiter::other_at_helm(std::string_view client) const {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const std::string& holder = authority_.holder(i);
    if (!holder.empty() && holder != client)
      return formatted("{} is held by {}", agents_[i]->name, holder);
  }
  return {};
}

void CommandArbiter::lost(std::string_view client, double now_s) {
  const std::lock_guard lock(mutex_);
  run_authority_.lost(client, now_s);
  for (const std::size_t vehicle : authority_.lost(client, now_s))
    enqueue_hold(client, vehicle, now_s);
  std::erase_if(last_sequence_, [&](const auto& entry) { return entry.first.first == client; });
}

void CommandArbiter::lost(std::string_view client, std::size_t vehicle, double now_s) {
  const std::lock_guard lock(mutex_);
  authority_.look(now_s);
  if (client.empty() || authority_.holder(vehicle) != client) return;
  authority_.end(vehicle);
  enqueue_hold(client, vehicle, now_s);
  std::erase_if(last_sequence_, [&](const auto& entry) {
    return entry.first == std::pair{std::string(client), vehicle};
  });
}

std::string CommandArbiter::holder(std::size_t vehicle) const {
  const std::lock_guard lock(mutex_);
  return authority_.holder(vehicle);
}

std::optional<std::size_t> CommandArbiter::vehicle(std::string_view name) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(agents_.begin(), agents_.end(),
                                  [&](const Agent* agent) { return agent->name == name; });
  if (found == agents_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - agents_.begin());
}

std::uint64_t CommandArbiter::taken(std::size_t vehicle) const {
  const std::lock_guard lock(mutex_);
  return taken_.at(vehicle).all;
}

bool CommandArbiter::is_waiting(std::size_t vehicle) const {
  const std::lock_guard lock(mutex_);
  return taken_.at(vehicle).is_waiting(openings_);
}

double CommandArbiter::time_s() const {
  const std::lock_guard lock(mutex_);
  return time_s_;
}

Standing CommandArbiter::standing(std::size_t vehicle) const {
  const std::lock_guard lock(mutex_);
  return standing_.at(vehicle);
}

std::vector<RefusalCount> CommandArbiter::refusals() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

void CommandArbiter::restore(std::vector<RefusalCount> refusals) {
  const std::lock_guard lock(mutex_);
  counts_ = std::move(refusals);
}

Refusal CommandArbiter::refuse(std::string_view client, std::string_view vehicle, Refusal refusal,
                               double now_s) {
  const std::lock_guard lock(mutex_);
  return count(client, std::string(vehicle), std::move(refusal), now_s);
}

Refusal CommandArbiter::refuse_unknown(std::string_view client, std::string_view vehicle,
                                       double now_s) {
  const std::lock_guard lock(mutex_);
  std::string known;
  for (const Agent* agent : agents_) known += (known.empty() ? "" : ", ") + agent->name;
  return count(client, std::string(vehicle),
               {RefusalReason::unknown_vehicle,
                formatted("found vehicle {}, expected one of {}", vehicle, known)},
               now_s);
}

void CommandArbiter::open() {
  const std::lock_guard lock(mutex_);
  ++openings_;
}

void CommandArbiter::look(double time_s) {
  const std::lock_guard lock(mutex_);
  time_s_ = time_s;
  know_newcomers();
  authority_.look(time_s);
  for (std::size_t i = 0; i < standing_.size(); ++i) {
    standing_[i] = standing_of(run_, i);
    const bool is_waiting = taken_[i].is_waiting(openings_);
    const Keeping keeping = authority_.keeping(i);
    const bool is_by_list =
        (keeping == Keeping::waypoints || keeping == Keeping::loop) && !authority_.is_leased(i);
    const bool is_list_over = is_by_list && !is_waiting && standing_[i].mode != HelmMode::waypoints;
    if (is_list_over || standing_[i].halt != Halt::none) authority_.end(i);
  }
}

void CommandArbiter::know_newcomers() {
  const std::span<const Agent> agents = run_.agents();
  while (agents_.size() < agents.size()) {
    const std::size_t i = agents_.size();
    agents_.push_back(&agents[i]);
    standing_.push_back(standing_of(run_, i));
    taken_.emplace_back();
    authority_.add_vehicle();
    std::erase(coming_, agents[i].name);
  }
}

/// Null: there is none.
const Agent* CommandArbiter::agent(std::size_t vehicle) const {
  const std::lock_guard lock(mutex_);
  return vehicle < agents_.size() ? agents_[vehicle] : nullptr;
}

std::optional<std::uint64_t> CommandArbiter::last_sequence(std::string_view client,
                                                           std::size_t vehicle) const {
  const auto found = last_sequence_.find(std::pair{std::string(client), vehicle});
  if (found == last_sequence_.end()) return std::nullopt;
  return found->second;
}

Refusal CommandArbiter::count(std::string_view client, std::string vehicle, Refusal refusal,
                              double now_s) {
  const auto of = [&](std::string_view source, std::string_view name) {
    return std::find_if(counts_.begin(), counts_.end(), [&](const RefusalCount& c) {
      return c.source == source && c.vehicle == name && c.reason == refusal.reason;
    });
  };
  const std::string from = printable(client);
  client = from;
  vehicle = printable(vehicle);
  auto found = of(client, vehicle);
  if (found == counts_.end() && counts_.size() >= most_counts) {
    client = "others";
    vehicle.clear();
    found = of(client, vehicle);
  }
  if (found == counts_.end())
    found = counts_.insert(counts_.end(),
                           {std::string(client), std::move(vehicle), refusal.reason, 0, 0, {}});
  ++found->count;
  found->last_s = now_s;
  refusal.text = printable(refusal.text, 1000);
  found->last_text = refusal.text;
  return refusal;
}

std::optional<Refusal> CommandArbiter::counted_unknown(std::string_view client, std::size_t vehicle,
                                                       double now_s) {
  return refuse_unknown(client, "number " + std::to_string(vehicle), now_s);
}

template <typename Do>
std::optional<Refusal> CommandArbiter::with_vehicle(std::string_view client, std::size_t vehicle,
                                                    double now_s, const Do& act) {
  const Agent* const found = agent(vehicle);
  if (found == nullptr) return counted_unknown(client, vehicle, now_s);
  const std::string& name = found->name;
  const std::lock_guard lock(mutex_);
  if (std::optional<std::string> answer = act(name))
    return count(client, name, {RefusalReason::unauthorised, std::move(*answer)}, now_s);
  return std::nullopt;
}

template <typename Do>
std::optional<Refusal> CommandArbiter::with_run(std::string_view client, double now_s,
                                                const Do& act) {
  const std::lock_guard lock(mutex_);
  if (std::optional<std::string> answer = act())
    return count(client, std::string(RunAuthority::name),
                 {RefusalReason::unauthorised, std::move(*answer)}, now_s);
  return std::nullopt;
}

void CommandArbiter::enqueue_hold(std::string_view client, std::size_t vehicle, double now_s) {
  taken_[vehicle].note(openings_);
  Command hold;
  hold.agent = vehicle;
  hold.what = HoldHere{true};
  hold.source = printable(client);
  hold.sequence = last_sequence(client, vehicle).value_or(0);
  hold.received_s = now_s;
  run_.enqueue(std::move(hold));
}

}  // namespace slackwater::twin
