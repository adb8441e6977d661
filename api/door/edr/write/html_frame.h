#pragma once
#include <string>

namespace slackwater::api::edr {

/// What all pages of the service share: head, style, the way to the other pages.
/// @param title  text, not yet escaped
/// @param body   HTML
[[nodiscard]] std::string html_frame(const std::string& title, const std::string& base,
                                     const std::string& body);

}  // namespace slackwater::api::edr
