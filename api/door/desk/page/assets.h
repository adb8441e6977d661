/// The page `/`, the desk, as it is carried inside the program.
#pragma once

#include <string_view>

namespace slackwater::desk {

/// Served as `/`; it asks for `/desk/page.css` and `/desk/page.js`, and the script for
/// `/desk/land-50m.json`.
[[nodiscard]] std::string_view desk_page_html();

/// Served as `/desk/page.js`. Empty when the program was built where npm was out of reach: the page
/// then says so itself.
[[nodiscard]] std::string_view desk_page_script();

/// Served as `/desk/page.css`.
[[nodiscard]] std::string_view desk_page_style();

/// Served as `/desk/land-50m.json`: the coast, TopoJSON of Natural Earth 1:50 million (public
/// domain). Empty as the script is.
[[nodiscard]] std::string_view desk_page_land();

}  // namespace slackwater::desk
