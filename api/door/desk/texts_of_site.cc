#include "api/door/desk/texts_of_site.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "api/ask/morning/morning.h"
#include "api/door/desk/site_list.h"
#include "api/program/paths.h"

namespace slackwater::api::desk {

using nlohmann::json;

namespace {

std::string read_text(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

TextsOfSite texts_of_site(const std::string& id, const std::filesystem::path& store_folder) {
  const Site site = described_site(id, store_folder);
  TextsOfSite texts;
  texts.site = site.yaml;
  for (const std::string& task : site.tasks) {
    const std::filesystem::path sheet = data_folder() / "tasks" / (task + ".yaml");
    std::error_code unreadable;
    if (is_site_id(task) && std::filesystem::is_regular_file(sheet, unreadable))
      texts.tasks[task] = read_text(sheet);
  }
  if (const auto plan = plan_of_site(site.id, store_folder); !plan.empty())
    texts.plan = read_text(plan);
  return texts;
}

json texts_json(const TextsOfSite& texts) {
  return {{"site", texts.site},
          {"tasks", texts.tasks},
          {"plan", texts.plan ? json(*texts.plan) : json(nullptr)}};
}

}  // namespace slackwater::api::desk
