/// What a page of ours is made of, as answers that keep it to itself.
#pragma once

#include <string_view>

#include "api/door/http/message.h"

namespace slackwater::api::http {

/// What the scripts of a page may do beside running.
enum class PageMay { only_run, compile_wasm };

/// Scripts, styles and connections of this server alone, and in nobody's frame. Kept for a minute:
/// another build of the program may be started in its place.
[[nodiscard]] Response page_part(std::string_view media_type, std::string_view body,
                                 PageMay may = PageMay::only_run);

}  // namespace slackwater::api::http
