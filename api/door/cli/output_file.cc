#include "api/door/cli/output_file.h"

#include <algorithm>
#include <string>

#include "fields/base/error.h"

namespace slackwater::api {

void expect_output(std::string_view option, const std::filesystem::path& file,
                   std::initializer_list<std::string_view> endings) {
  if (file.empty()) return;
  const std::string found = "found " + std::string(option) + " " + file.string();
  if (std::filesystem::is_directory(file) || !file.has_filename()) {
    throw Error(ErrorKind::usage, found + ", which is a folder; expected the name of a file");
  }
  const bool is_named = endings.size() == 0 ||
                        (file.has_stem() && std::find(endings.begin(), endings.end(),
                                                      file.extension().string()) != endings.end());
  if (!is_named) {
    std::string wanted;
    for (const std::string_view ending : endings)
      wanted += (wanted.empty() ? "" : " or ") + std::string(ending);
    throw Error(ErrorKind::usage, found + ", expected a file name that ends in " + wanted);
  }
  const auto folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw Error(ErrorKind::usage, "found no folder " + folder.string() + " for " +
                                      std::string(option) + "; make it, or name another");
  }
}

}  // namespace slackwater::api
