/// The page `/session` as it is carried inside the program.
#pragma once

#include <string_view>

namespace slackwater::people {

/// Served as `/session`; it asks for `/session/page.css` and `/session/page.js` and for nothing
/// else.
[[nodiscard]] std::string_view session_page_html();

/// Served as `/session/page.js`. Empty when the program was built where npm or flatc was out of
/// reach: the page then says so itself.
[[nodiscard]] std::string_view session_page_script();

/// Served as `/session/page.css`.
[[nodiscard]] std::string_view session_page_style();

}  // namespace slackwater::people
