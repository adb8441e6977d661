#pragma once
#include <string>
#include <vector>

#include "api/show/coverage/marks.h"
#include "api/show/coverage/view.h"

namespace slackwater::api {

/// "82 %"; never "100 %" of what is not whole, nor "0 %" of what is there.
[[nodiscard]] std::string percent_text(double share);

/// ", asked for 90 %"; empty where nothing is.
[[nodiscard]] std::string asked_share_text(const InspectionCoverage& coverage);

/// One surface: a sentence, a legend, the sheet unrolled and the surface in space.
[[nodiscard]] std::string pictures_html(const InspectionCoverage& coverage,
                                        const std::vector<CoverageMark>& marks,
                                        const std::string& sentence);

/// The part of a page that holds them, with the patterns that they are filled with.
[[nodiscard]] std::string coverage_section_html(const std::string& title,
                                                const std::string& pictures,
                                                const std::string& note);

}  // namespace slackwater::api
