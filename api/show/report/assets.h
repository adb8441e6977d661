#pragma once
#include <string_view>

namespace slackwater::api {

/// What the page carries inside itself, linked into the program by assets.cmake.
[[nodiscard]] std::string_view report_style();  ///< page/report.css
[[nodiscard]] std::string_view
report_common_script();                             ///< page/common.js, before each of the others
[[nodiscard]] std::string_view report_script();     ///< page/report.js
[[nodiscard]] std::string_view skill_script();      ///< page/skill.js
[[nodiscard]] std::string_view run_script();        ///< page/run.js
[[nodiscard]] std::string_view rehearsal_script();  ///< page/rehearsal.js
[[nodiscard]] std::string_view vehicle_script();    ///< page/vehicle.js
/// Apache ECharts, minified; empty where npm could not fetch it at build time.
[[nodiscard]] std::string_view report_plotting_library();

}  // namespace slackwater::api
