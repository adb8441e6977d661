#include "api/show/people/people_score_text.h"

#include <algorithm>

#include "api/log/score.h"
#include "fields/base/numbers/statistics.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

std::string times(std::size_t count) {
  return count == 0 ? "never" : count == 1 ? "once" : formatted("{} times", count);
}

double most_of(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// "2.1 s (median), 9.8 s (most)". @param values  not empty
std::string latencies(const std::vector<double>& values) {
  if (values.size() == 1) return formatted("{:.1f} s", values.front());
  return formatted("{:.1f} s (median), {:.1f} s (most)", median(values), most_of(values));
}

std::string how_had(const HelmScore& helm) {
  std::vector<std::string> parts;
  const std::size_t asked = helm.asked_to_had_s.size() + helm.asked_in_vain;
  if (asked > 0) {
    std::string text = "asked " + times(asked);
    if (!helm.asked_to_had_s.empty())
      text += most_of(helm.asked_to_had_s) > 0 ? ", had it after " + latencies(helm.asked_to_had_s)
                                               : ", had it at once";
    if (helm.asked_in_vain > 0) text += ", in vain " + times(helm.asked_in_vain);
    parts.push_back(text);
  }
  if (helm.taken_over > 0)
    parts.push_back("took it over " + times(helm.taken_over) + " by HOLD or take-back");
  if (helm.hold_in_force_s && !helm.hold_in_force_s->empty())
    parts.push_back(
        formatted("its holds were in force at most {:.2f} s of the run after they came in",
                  most_of(*helm.hold_in_force_s)));
  if (!helm.had_to_command_s.empty())
    parts.push_back("first command " + latencies(helm.had_to_command_s) + " after it had the helm");
  if (helm.turns_without_command > 0)
    parts.push_back(
        formatted("no command in {} of {} turns", helm.turns_without_command, helm.turns));
  if (helm.links_lost > 0) parts.push_back("its link was lost " + times(helm.links_lost));
  return joined(parts, "; ");
}

std::string how_used(const HelmScore& helm) {
  std::string text = counted(helm.commands, "command") + " taken";
  if (const auto rate = commands_per_minute(helm))
    text += formatted(", {:.1f} a minute at the helm", *rate);
  if (helm.refused > 0) {
    std::vector<std::string> reasons;
    for (const auto& [reason, count] : helm.refused_for)
      reasons.push_back(formatted("{} {}", count, reason));
    text += formatted("; {} refused ({:.1f} %): {}", helm.refused, 100 * *refused_share(helm),
                      joined(reasons, ", "));
  }
  if (helm.off_mission > 0) text += "; took it off its own mission " + times(helm.off_mission);
  if (helm.off_helm > 0) text += "; took it off another's helm " + times(helm.off_helm);
  return text;
}

std::string at_limits(const HelmScore& helm) {
  if (!helm.at_limits) return "limits: not known, as the log has no scenario of this vehicle";
  const AtLimits& at = *helm.at_limits;
  std::vector<std::string> parts;
  if (at.nearest_structure_m)
    parts.push_back(formatted("nearest structure {:.1f} m", *at.nearest_structure_m));
  if (at.stand_off_m)
    parts.push_back(formatted(
        "nearer than its stand-off of {:g} m {}, {:.1f} s in all, {:.1f} s "
        "within a quarter beyond it",
        *at.stand_off_m, times(at.stand_off_breaches), at.inside_stand_off_s, at.near_stand_off_s));
  if (at.fence_m)
    parts.push_back(
        formatted("outside its fence of {:g} m {}, {:.1f} s in all, {:.1f} s in the "
                  "outer quarter inside it",
                  *at.fence_m, times(at.fence_breaches), at.outside_fence_s, at.near_fence_s));
  if (at.reserve_share)
    parts.push_back(formatted("{:.1f} s below its reserve of {:g} %", at.below_reserve_s,
                              100 * *at.reserve_share));
  if (at.limits_broken > 0)
    parts.push_back("called off its task by a limit " + times(at.limits_broken));
  if (!at.stopped_by.empty()) parts.push_back("stopped for good: " + at.stopped_by);
  return parts.empty() ? "limits: none is set" : joined(parts, "; ");
}

std::string helm_text(const HelmScore& helm, double ran_s) {
  const std::string vehicle = helm.vehicle.empty() ? "no vehicle" : helm.vehicle;
  std::string text = "    " + vehicle + ": ";
  if (helm.turns == 0) {
    text += "never at the helm";
  } else {
    text += formatted("at the helm {} for {:.1f} min of the run", times(helm.turns),
                      helm.at_helm_s / 60);
    if (ran_s > 0) text += formatted(", {:.0f} % of it", 100 * helm.at_helm_s / ran_s);
  }
  text += "\n";
  if (const std::string had = how_had(helm); !had.empty()) text += "      " + had + "\n";
  if (helm.commands + helm.refused > 0) text += "      " + how_used(helm) + "\n";
  if (helm.turns > 0) text += "      " + at_limits(helm) + "\n";
  return text;
}

/// "    looked at, kept for 1.1 min: rov 64 %, COASTER 10 %, nothing with a name 26 %"
std::string attention_text(const Attention& attention) {
  if (!(attention.kept_s > 0)) return "    looked at: kept for no time\n";
  std::vector<std::pair<double, std::string>> parts;
  for (const auto& [name, for_s] : attention.on_s)
    parts.emplace_back(-for_s, formatted("{} {:.0f} %", name.empty() ? "nothing with a name" : name,
                                         100 * for_s / attention.kept_s));
  std::sort(parts.begin(), parts.end());
  std::vector<std::string> words;
  words.reserve(parts.size());
  for (const auto& [order, text] : parts) words.push_back(text);
  return formatted("    looked at, kept for {:.1f} min: {}\n", attention.kept_s / 60,
                   joined(words, ", "));
}

/// The mean, and the deviation of more than one.
std::string or_dash(const std::vector<double>& values, int decimals, double scale = 1) {
  if (values.empty()) return "-";
  const Spread spread = spread_of(values);
  std::string mean = formatted("{:.{}f}", scale * spread.mean, decimals);
  if (values.size() < 2) return mean;
  return mean + formatted(" ({:.{}f})", scale * spread.deviation, decimals);
}

}  // namespace

std::string people_score_text(const std::string& run, const PeopleScore& score) {
  if (score.people.empty()) return {};
  std::string text = "People of " + run;
  if (score.log_every_s)
    text += formatted(" (limits by positions {:g} s apart: what is between two is not seen)",
                      *score.log_every_s);
  text += "\n";
  for (const PersonScore& person : score.people) {
    text += formatted("  {}, {}, seat {}\n", person.name, person.role, person.seat);
    for (const HelmScore& helm : person.helms) text += helm_text(helm, score.ran_s);
    if (person.helms.empty()) text += "    asked for no vehicle\n";
    if (person.attention) text += attention_text(*person.attention);
  }
  for (const auto& [role, count] : score.by_role) {
    if (count.off_mission + count.off_helm == 0) continue;
    text += formatted("  by {}s: off its own mission {}, off another's helm {}\n", role,
                      times(count.off_mission), times(count.off_helm));
  }
  return text;
}

std::string people_over_runs_text(std::span<const PersonOverRuns> people) {
  if (people.empty()) return {};
  const auto row = [](const auto&... cells) {
    return formatted(
        "{:<20} {:<10} {:>4} {:>14} {:>13} {:>5} {:>7} {:>7} {:>8} {:>14} {:>13} {:>11} {:>11} "
        "{:>11} {:>14}\n",
        cells...);
  };
  std::string text = row("person", "role", "runs", "min at helm", "% of run", "asked", "had s",
                         "most s", "first s", "commands/min", "% refused", "off mission",
                         "off helm", "breaches", "near limit s");
  for (const PersonOverRuns& person : people) {
    const auto& had = person.asked_to_had_s;
    const auto& first = person.had_to_command_s;
    text +=
        row(person.name.substr(0, 20), person.role, person.runs,
            or_dash(person.at_helm_s, 1, 1.0 / 60), or_dash(person.share_of_run, 0, 100),
            had.size() + person.asked_in_vain, had.empty() ? "-" : formatted("{:.1f}", median(had)),
            had.empty() ? "-" : formatted("{:.1f}", most_of(had)),
            first.empty() ? "-" : formatted("{:.1f}", median(first)),
            or_dash(person.commands_per_minute, 1), or_dash(person.refused_share, 1, 100),
            or_dash(person.off_mission, 1), or_dash(person.off_helm, 1),
            or_dash(person.breaches, 1), or_dash(person.near_limit_s, 1));
  }
  return text;
}

}  // namespace slackwater::api
