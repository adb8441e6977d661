#include "api/log/people_over_runs.h"

#include <map>
#include <tuple>
#include <utility>

namespace slackwater::api {
namespace {

using Who = std::pair<std::string, std::string>;

/// What one person did in one run, over seats and vehicles.
struct InRun {
  HelmScore all;
  bool tells_limits = false;
  double breaches = 0, near_limit_s = 0;

  void add(const HelmScore& helm, PersonOverRuns& over) {
    all.at_helm_s += helm.at_helm_s;
    all.commands += helm.commands;
    all.refused += helm.refused;
    all.off_mission += helm.off_mission;
    all.off_helm += helm.off_helm;
    over.asked_in_vain += helm.asked_in_vain;
    over.asked_to_had_s.insert(over.asked_to_had_s.end(), helm.asked_to_had_s.begin(),
                               helm.asked_to_had_s.end());
    over.had_to_command_s.insert(over.had_to_command_s.end(), helm.had_to_command_s.begin(),
                                 helm.had_to_command_s.end());
    if (!helm.at_limits || !(helm.at_limits->stand_off_m || helm.at_limits->fence_m)) return;
    tells_limits = true;
    breaches +=
        static_cast<double>(helm.at_limits->stand_off_breaches + helm.at_limits->fence_breaches);
    near_limit_s += helm.at_limits->near_stand_off_s + helm.at_limits->near_fence_s;
  }
  void give(double ran_s, PersonOverRuns& over) const {
    ++over.runs;
    over.at_helm_s.push_back(all.at_helm_s);
    if (ran_s > 0) over.share_of_run.push_back(all.at_helm_s / ran_s);
    if (const auto rate = commands_per_minute(all)) over.commands_per_minute.push_back(*rate);
    if (const auto share = refused_share(all)) over.refused_share.push_back(*share);
    over.off_mission.push_back(static_cast<double>(all.off_mission));
    over.off_helm.push_back(static_cast<double>(all.off_helm));
    if (!tells_limits) return;
    over.breaches.push_back(breaches);
    over.near_limit_s.push_back(near_limit_s);
  }
};

}  // namespace

std::optional<double> commands_per_minute(const HelmScore& helm) noexcept {
  if (!(helm.at_helm_s > 0)) return std::nullopt;
  return static_cast<double>(helm.commands) / (helm.at_helm_s / 60);
}

std::optional<double> refused_share(const HelmScore& helm) noexcept {
  if (helm.commands + helm.refused == 0) return std::nullopt;
  return static_cast<double>(helm.refused) / static_cast<double>(helm.commands + helm.refused);
}

std::vector<PersonOverRuns> people_over_runs(std::span<const PeopleScore> runs) {
  std::map<Who, PersonOverRuns> all;
  for (const PeopleScore& run : runs) {
    std::map<Who, InRun> here;
    for (const PersonScore& person : run.people) {
      const Who who{person.name, person.role};
      InRun& in_run = here[who];
      for (const HelmScore& helm : person.helms) in_run.add(helm, all[who]);
    }
    for (const auto& [who, in_run] : here) in_run.give(run.ran_s, all[who]);
  }
  std::vector<PersonOverRuns> people;
  for (auto& [who, over] : all) {
    std::tie(over.name, over.role) = who;
    people.push_back(std::move(over));
  }
  return people;
}

}  // namespace slackwater::api
