#pragma once
#include <array>

namespace slackwater {

/// As tables and dates have them, from January on.
inline constexpr std::array<const char*, 12> month_names{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                         "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

}  // namespace slackwater
