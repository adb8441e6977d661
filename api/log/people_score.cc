#include "api/log/people_score.h"

#include <algorithm>
#include <variant>

#include "api/log/action_tables.h"
#include "api/log/command_tables.h"
#include "api/log/helm_turns.h"
#include "api/log/person_source.h"

namespace slackwater::api {
namespace {

using store::SessionAction;
using twin::Command;

const std::string agent = "agent";

/// Commands of a log and when each took effect.
struct Commands {
  std::vector<Command> all;
  std::vector<double> in_force_s;
};

Commands read_commands(const ingest::TrajectoryFile& log) {
  Commands commands{commands_in(log), {}};
  if (const ingest::TrajectoryTable* table = log.find_table("command"))
    if (const std::vector<double>* time = table->column("time")) commands.in_force_s = *time;
  return commands;
}

bool is_hold(const Command& command) {
  const auto* hold = std::get_if<twin::HoldHere>(&command.what);
  return hold != nullptr && !hold->is_client_lost;
}

/// Whether it puts a vehicle under the helm; a hold for want of one leaves missions alone.
bool is_of_helm(const Command& command) {
  return std::holds_alternative<twin::Reroute>(command.what) ||
         twin::must_be_renewed(command.what) ||
         std::holds_alternative<twin::GoHome>(command.what) || is_hold(command);
}

class Scoring {
 public:
  Scoring(const ingest::TrajectoryFile& log, const twin::RunAccount& account,
          const twin::Scenario* scenario)
      : log_(log), account_(account), scenario_(scenario), actions_(actions_in(log)) {}

  PeopleScore made() {
    score_.ran_s = account_.ran_s;
    if (actions_.empty()) return score_;
    for (std::size_t i = 1; i < log_.t_s.size(); ++i)
      score_.log_every_s = std::max(score_.log_every_s.value_or(0), log_.t_s[i] - log_.t_s[i - 1]);
    for (const SessionAction& action : actions_) take_seat(action);
    const Commands commands = read_commands(log_);
    for (const SessionAction& action : actions_)
      if (is_command(action)) count(action);
    for (const auto& [seat, attention] : attention_of(actions_))
      score_.people[seats_.at(seat)].attention = attention;
    take_turns(helm_history_of(actions_, account_.ran_s));
    take_missions(commands);
    for (PersonScore& person : score_.people) {
      for (HelmScore& helm : person.helms)
        if (person.role == "supervisor") take_holds(commands, person, helm);
      score_.by_role[person.role];
    }
    sort();
    return score_;
  }

 private:
  void take_seat(const SessionAction& action) {
    const auto [place, is_new] = seats_.try_emplace(action.seat, score_.people.size());
    if (is_new) score_.people.push_back({action.seat, action.who, action.role, {}, {}});
  }
  HelmScore& helm_of(PersonScore& person, const std::string& vehicle) {
    const auto found = std::find_if(person.helms.begin(), person.helms.end(),
                                    [&](const HelmScore& helm) { return helm.vehicle == vehicle; });
    if (found != person.helms.end()) return *found;
    HelmScore& helm = person.helms.emplace_back();
    helm.vehicle = vehicle;
    return helm;
  }
  HelmScore& helm_of(unsigned seat, const std::string& vehicle) {
    return helm_of(score_.people[seats_.at(seat)], vehicle);
  }

  /// Of sticks that followed on each other the first is a row, and the last that counts them all.
  void count(const SessionAction& action) {
    HelmScore& helm = helm_of(action.seat, action.vehicle);
    const std::uint64_t count =
        action.what.ends_with("_end") ? std::max<std::uint64_t>(action.count, 1) - 1 : 1;
    if (action.is_taken) {
      helm.commands += count;
    } else {
      helm.refused += count;
      helm.refused_for[action.reason] += count;
    }
  }

  void take_turns(const HelmHistory& history) {
    std::map<HelmHistory::SeatAtVehicle, std::vector<Stretch>> there;
    for (const HelmTurn& turn : history.turns) {
      HelmScore& helm = helm_of(turn.seat, turn.vehicle);
      ++helm.turns;
      if (turn.asked_to_had_s) helm.asked_to_had_s.push_back(*turn.asked_to_had_s);
      if (turn.had_to_command_s) helm.had_to_command_s.push_back(*turn.had_to_command_s);
      if (!turn.was_asked_for) ++helm.taken_over;
      if (!turn.has_command) ++helm.turns_without_command;
      if (turn.was_taken) {
        ++helm.off_helm;
        ++score_.by_role[score_.people[seats_.at(turn.seat)].role].off_helm;
      }
      for (const Stretch& stretch : turn.there) helm.at_helm_s += stretch.to_s - stretch.from_s;
      auto& all = there[{turn.seat, turn.vehicle}];
      all.insert(all.end(), turn.there.begin(), turn.there.end());
    }
    for (const auto& [who, count] : history.asked_in_vain)
      helm_of(who.first, who.second).asked_in_vain = count;
    for (const auto& [who, count] : history.links_lost)
      helm_of(who.first, who.second).links_lost = count;
    for (const auto& [who, stretches] : there) {
      const auto named = std::find(log_.names.begin(), log_.names.end(), who.second);
      if (named == log_.names.end()) continue;
      const auto vehicle = static_cast<std::size_t>(named - log_.names.begin());
      helm_of(who.first, who.second).at_limits =
          at_limits_in(log_, vehicle, account_.vehicles[vehicle], scenario_, stretches);
    }
  }

  /// A vehicle is on its own mission until it is told otherwise, and again from `resume` on.
  void take_missions(const Commands& commands) {
    std::map<std::string, PersonScore*> by_source;
    for (PersonScore& person : score_.people)
      by_source[source_of_person(person.seat, person.name)] = &person;
    std::vector<bool> is_helmed(log_.names.size());
    for (const Command& command : commands.all) {
      if (std::holds_alternative<twin::Resume>(command.what)) is_helmed[command.agent] = false;
      if (!is_of_helm(command) || is_helmed[command.agent]) continue;
      is_helmed[command.agent] = true;
      const auto person = by_source.find(command.source);
      const bool is_person = person != by_source.end();
      ++score_.by_role[is_person ? person->second->role : agent].off_mission;
      if (is_person) ++helm_of(*person->second, log_.names[command.agent]).off_mission;
    }
  }

  /// Its holds in the record and in the commands are the same ones, in the same order.
  void take_holds(const Commands& commands, const PersonScore& person, HelmScore& helm) const {
    const auto ordered = static_cast<std::size_t>(
        std::count_if(actions_.begin(), actions_.end(), [&](const SessionAction& action) {
          return action.seat == person.seat && action.vehicle == helm.vehicle && action.is_taken &&
                 (action.what == "hold" || action.what == "take_back");
        }));
    const std::string source = source_of_person(person.seat, person.name);
    std::vector<double> waits_s;
    for (std::size_t i = 0; i < commands.all.size(); ++i) {
      const Command& command = commands.all[i];
      if (!is_hold(command) || command.source != source ||
          log_.names[command.agent] != helm.vehicle || i >= commands.in_force_s.size())
        continue;
      waits_s.push_back(std::max(0.0, commands.in_force_s[i] - command.received_s));
    }
    if (waits_s.size() == ordered) helm.hold_in_force_s = std::move(waits_s);
  }

  void sort() {
    std::sort(score_.people.begin(), score_.people.end(),
              [](const auto& a, const auto& b) { return a.seat < b.seat; });
    for (PersonScore& person : score_.people)
      std::sort(person.helms.begin(), person.helms.end(),
                [](const auto& a, const auto& b) { return a.vehicle < b.vehicle; });
  }

  const ingest::TrajectoryFile& log_;
  const twin::RunAccount& account_;
  const twin::Scenario* scenario_;
  std::vector<SessionAction> actions_;
  std::map<unsigned, std::size_t> seats_;  ///< its place among the people
  PeopleScore score_;
};

}  // namespace

PeopleScore people_score_of(const ingest::TrajectoryFile& log, const twin::RunAccount& account,
                            const twin::Scenario* scenario) {
  return Scoring(log, account, scenario).made();
}

}  // namespace slackwater::api
