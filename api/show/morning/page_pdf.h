#pragma once
#include <filesystem>

namespace slackwater::api {

/// Prints a page to a PDF of A4 sheets with Chromium, headless and without a network. Where the PDF
/// cannot be made nothing of it is left, and the page stands.
/// @throws Error(unavailable) where there is no Chromium, saying what to install, and where it
///         fails or takes longer than a minute
void print_page(const std::filesystem::path& page, const std::filesystem::path& pdf);

}  // namespace slackwater::api
