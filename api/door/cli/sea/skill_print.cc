#include "api/door/cli/sea/skill_print.h"

#include <algorithm>
#include <cstdio>

#include "api/show/report/skill_table.h"
#include "api/show/report/verdict_text.h"

namespace slackwater::api {

void print_skill(const std::vector<calibration::SkillEntry>& entries, bool full) {
  if (full) {
    std::printf("%s%s", verdict_lines(entries).c_str(), skill_table(entries).c_str());
    return;
  }
  const auto verdict = calibration::main_verdict(entries);
  if (!verdict) {  // scores of wind and waves alone
    std::printf("%s", skill_table(entries).c_str());
    return;
  }
  std::printf("%s %s\n%s\n", verdict_text(*verdict).c_str(), outcome_text(*verdict).c_str(),
              short_skill_table(entries, verdict->wind, verdict->origin).c_str());
  const auto is_other = [&](const calibration::SkillEntry& e) {
    return e.origin != verdict->origin;
  };
  if (std::any_of(entries.begin(), entries.end(), is_other))
    std::printf("Days that were not forecast then but hindcast are scored apart.\n");
  std::printf("`--full` prints every depth band, lead and wind policy, wind and waves.\n");
}

}  // namespace slackwater::api
