#pragma once
#include <string_view>

namespace slackwater::web {

/// Style that each page that is one file begins with: palette.css and parts.css of this folder.
/// Day, and dusk where the reader's system is dark; `data-palette` on the root element (day, dusk,
/// night) says otherwise. Paper always has the day.
[[nodiscard]] std::string_view page_look();

}  // namespace slackwater::web
