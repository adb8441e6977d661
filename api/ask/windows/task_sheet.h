#pragma once
#include <optional>
#include <span>
#include <string>

#include "fields/base/config.h"
#include "twin/mission/work_site.h"
#include "twin/risk/workability/daylight.h"

namespace slackwater::api {

/// What the sheet of a task says of its time, beside its work.
struct TaskSheet {
  std::string name;
  std::optional<double> duration_h;  ///< of one turbine, foundation, ..., or of one kilometre
  std::string per;                   ///< "foundation", "km"
  std::optional<double> min_window_h;
  std::optional<twin::Light> daylight;
  double cable_km = 0;         ///< that its work follows
  bool is_splittable = false;  ///< it may be done over several visits
  double least_visit_h = 0;    ///< that one is worth making for

  /// How long it is planned to take at so many turbines; nothing where the sheet says nothing.
  [[nodiscard]] std::optional<double> planned_h(std::size_t turbines) const;
  /// What a window has to last beyond the duration of the sheet.
  [[nodiscard]] double contingency_h() const;
};

/// @param task      of `load_task`
/// @param turbines  ids of those at which the work is done
/// @throws Error(invalid_input)
[[nodiscard]] TaskSheet read_task_sheet(const Config& task, const twin::WorkSite& site,
                                        std::span<const std::string> turbines);

}  // namespace slackwater::api
