#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace slackwater::api::desk {

/// The YAML that a site's answers rest on, as people wrote it.
struct TextsOfSite {
  std::string site;
  std::map<std::string, std::string> tasks;  ///< by id
  std::optional<std::string> plan;
};

/// @throws Error(not_found) for a site that is not described
[[nodiscard]] TextsOfSite texts_of_site(const std::string& id,
                                        const std::filesystem::path& store_folder);
[[nodiscard]] nlohmann::json texts_json(const TextsOfSite& texts);

}  // namespace slackwater::api::desk
