#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/show/coverage/view.h"
#include "fields/base/time.h"

// What was seen of surfaces, as parts of a page. Nothing of what was planted shows unless the truth
// is asked for: neither in a picture, nor in a table, nor in the data.

namespace slackwater::api {

/// Surface by surface: the sheet unrolled, the surface in space, the shares in words. Empty where
/// nothing was inspected.
[[nodiscard]] std::string coverage_html(const std::vector<InspectionCoverage>& coverages,
                                        bool shows_truth);

/// Sections of the plots drawn from `coverage_json`: detail against range, share covered against
/// time.
[[nodiscard]] std::string coverage_plots_html(const std::vector<InspectionCoverage>& coverages);

/// Of each pair: `{name, asked, range: [[m, p10, p50, p90], ...], time: [[s, share], ...]}`, detail
/// in mm.
[[nodiscard]] nlohmann::json coverage_json(const std::vector<InspectionCoverage>& coverages);

/// The same as tables: coverage, findings, and what was missed where the truth is asked for.
[[nodiscard]] std::string coverage_tables_html(const std::vector<InspectionCoverage>& coverages,
                                               UtcTime epoch, bool shows_truth);

/// "Camera of inspector: 61 % of 18.2 m2 covered, asked for 90 %; covered is what was seen at 10 mm
/// or finer, at most 60 degrees off square, 1 look."
[[nodiscard]] std::string coverage_text(const InspectionCoverage& coverage);

}  // namespace slackwater::api
