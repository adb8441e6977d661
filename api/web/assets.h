/// Pages that are carried inside the program: made of the folders beside this file.
#pragma once

#include <string_view>

namespace slackwater::web {

/// Files of one page, as they are served. All but `html` are empty when the program was built where
/// npm, flatc or the registry was out of reach: the page then says so itself.
struct PageAssets {
  std::string_view html;
  std::string_view script;
  std::string_view style;
  std::string_view data;  ///< what the script asks for beside them; empty where it asks for nothing
};

/// The page `/`. It asks for `/desk/page.css` and `/desk/page.js`, and its script for
/// `/desk/land-50m.json`: the coast, TopoJSON of Natural Earth 1:50 million (public domain).
[[nodiscard]] PageAssets desk_page();

/// The page `/session`. It asks for `/session/page.css` and `/session/page.js`, for nothing else.
[[nodiscard]] PageAssets session_page();

/// The page `/session/hands`. It asks for `/session/hands/page.css` and `/session/hands/page.js`,
/// and once its camera is started for what is below `/session/hands/model`, which is too big to be
/// carried: the files of its detector are on disk.
[[nodiscard]] PageAssets hands_page();

}  // namespace slackwater::web
