#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace slackwater::api::edr {

/// A JSON document of the service for people: HTML 5 that says what the document says, in words,
/// lists and tables that fit a telephone; text escaped; no script, nothing from elsewhere. Links
/// lead to pages where there are pages, and to nothing that would ask for more than the address
/// holds; identifiers of standards are text.
/// @param base  address of the service, without a slash at its end
[[nodiscard]] std::string html_page(const std::string& title, const std::string& base,
                                    const nlohmann::json& document);

/// The interface for people: every path of an OpenAPI document with what it does and takes.
[[nodiscard]] std::string html_of_interface(const std::string& base, const nlohmann::json& openapi);

}  // namespace slackwater::api::edr
