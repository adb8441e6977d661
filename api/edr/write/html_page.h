#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace slackwater::api::edr {

/// A JSON document of the service for people: HTML 5 that holds all that the document says,
/// addresses as links, text escaped; no script, nothing from elsewhere.
[[nodiscard]] std::string html_page(const std::string& title, const nlohmann::json& document);

/// The interface for people: every path of an OpenAPI document with what it does and takes.
[[nodiscard]] std::string html_of_interface(const nlohmann::json& openapi);

}  // namespace slackwater::api::edr
