#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/morning/morning_decisions.h"
#include "api/ask/plan/plan_answer.h"
#include "api/ask/plan/plan_file.h"
#include "api/ask/windows/fly_windows.h"
#include "api/ask/windows/windows.h"

namespace slackwater::api {

/// What a morning is asked for.
struct MorningQuestion {
  WindowsQuestion windows;
  std::filesystem::path plan;  ///< PLAN.yaml; empty: no plan is made
  double plan_limit_s = 20;    ///< of the search
  /// When it is asked: hours that have passed are not told. Absent: at the issue of the forecast.
  std::optional<UtcTime> now;
  /// Nobody sits before it: a plan that cannot be read and a task that cannot be worked out are
  /// told beside the rest.
  bool is_unattended = false;
};

/// A day's plan made from the windows of a morning.
struct MorningPlan {
  PlanProblem problem;
  PlanAnswer answer;
};

/// What a coordinator decides from, before how it is shown.
struct Morning {
  MorningQuestion question;
  WindowsAnswer windows;  ///< of the first full day after the issue, or of the hours asked for
  /// Of the hours that are left of the day of the issue, or of the day told in `windows` once it
  /// has come; nothing on another day, where other hours were asked for, and where no task can be
  /// begun in them.
  std::optional<WindowsAnswer> today;
  std::optional<PlanFile> plan_file;
  std::optional<MorningPlan> plan;
  std::string no_plan;  ///< why one that was asked for could not be made; else empty
  std::optional<MorningDecisions> decisions;  ///< where the store holds any
};

/// The windows of a site's tasks, its plan, and what was decided. A plan that cannot be made and
/// decisions that cannot be read are told, and take nothing from the windows.
/// @throws as `windows_of`; Error(not_found), Error(invalid_input) for a plan's file that cannot be
///         read, unless it is unattended
[[nodiscard]] Morning morning_of(const MorningQuestion& question,
                                 const std::filesystem::path& store_folder);

/// The same morning as if it had been asked about the hours of today alone, without a plan.
/// @pre `morning.today`
[[nodiscard]] Morning today_of(const Morning& morning);

/// The plan made again with what flights leave of the starts.
void plan_anew(Morning& morning, const std::filesystem::path& store_folder);

/// The plan of a site where nothing else is said: STORE/plans/SITE.yaml; empty where there is none.
[[nodiscard]] std::filesystem::path plan_of_site(const std::string& site_id,
                                                 const std::filesystem::path& store_folder);

/// How many futures the chances are of.
[[nodiscard]] std::size_t futures_of(const Morning& morning);

/// The tasks in the order in which they are told: go, marginal, no-go, each as they were asked for.
[[nodiscard]] std::vector<const TaskWindows*> by_verdict(const Morning& morning);

}  // namespace slackwater::api
