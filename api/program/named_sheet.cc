#include "api/program/named_sheet.h"

#include <algorithm>

#include "api/program/paths.h"
#include "fields/base/advice.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {

std::vector<std::string> known_sheets(const std::string& kind) {
  std::vector<std::string> ids;
  std::error_code not_there;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / kind, not_there))
    if (entry.path().extension() == ".yaml") ids.push_back(entry.path().stem().string());
  std::sort(ids.begin(), ids.end());
  return ids;
}

Config load_sheet(const std::string& kind, const std::string& key, const std::string& id,
                  const std::filesystem::path& folder) {
  const std::filesystem::path named = data_folder() / kind / (id + ".yaml");
  if (id.find('/') == std::string::npos && std::filesystem::exists(named))
    return Config::load(named);
  const std::filesystem::path file = id;
  const std::filesystem::path beside = file.is_absolute() ? file : folder / file;
  if (std::filesystem::exists(beside)) return Config::load(beside);
  const std::vector<std::string> known = known_sheets(kind);
  throw Error(ErrorKind::not_found, key + ": found " + id + ", expected one of " +
                                        joined(known, ", ") + ", or the path of a file" +
                                        did_you_mean(id, known));
}

}  // namespace slackwater::api
