#include "api/morning/operator_config.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

#include "api/program/paths.h"
#include "fields/base/config.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

namespace fs = std::filesystem;

/// Who may write it may start programs as us.
void expect_ours(const fs::path& place) {
  struct stat found {};
  if (::stat(place.c_str(), &found) != 0)
    throw Error(ErrorKind::not_found, "found no " + place.string() +
                                          " that can be read, expected a file of yours; mend its "
                                          "path or rights");
  if (found.st_uid != 0 && found.st_uid != ::geteuid())
    throw Error(
        ErrorKind::invalid_input,
        "found " + place.string() +
            " owned by another user, expected you or root: who can write it runs programs as "
            "you; change its owner");
  const bool is_sticky = (found.st_mode & S_ISVTX) != 0 && S_ISDIR(found.st_mode);
  if ((found.st_mode & (S_IWGRP | S_IWOTH)) != 0 && !is_sticky)
    throw Error(ErrorKind::invalid_input,
                "found " + place.string() +
                    " writable for others, expected for its owner alone: who can write it runs "
                    "programs as you; chmod go-w it");
}

/// The file, where links to it lead, and every folder on the ways there: whoever writes in one of
/// them can put another file in its place.
/// @return without links
fs::path expect_ours_with_folders(const fs::path& named) {
  expect_ours(named);
  const fs::path file = fs::canonical(named);
  for (const fs::path& way : {file, fs::absolute(named).lexically_normal()})
    for (fs::path folder = way.parent_path();; folder = folder.parent_path()) {
      expect_ours(folder);
      if (folder == folder.root_path()) break;
    }
  return file;
}

Hook read_hook(const Config& config) {
  Hook hook;
  hook.command = config.texts("command");
  if (!config.is_list("command") || hook.command.empty())
    config.refuse("command", "expected a list: the path of a program, then its arguments");
  if (!fs::path(hook.command.front()).is_absolute())
    config.refuse("command",
                  "found " + hook.command.front() + ", expected the absolute path of a program");
  if (const auto limit_s = config.optional_number("time_limit_s", {0.1, 600}))
    hook.limit = std::chrono::milliseconds(std::llround(1000 * *limit_s));
  return hook;
}

}  // namespace

OperatorConfig load_operator_config(const fs::path& named) {
  const fs::path file = expect_ours_with_folders(named);
  const Config config = Config::load(file);
  OperatorConfig out;
  if (const auto hook = config.optional_child("hook")) out.hook = read_hook(*hook);
  config.expect_all_read();
  if (out.hook) static_cast<void>(expect_ours_with_folders(out.hook->command.front()));
  return out;
}

OperatorConfig operator_config() {
  if (const char* named = std::getenv("SLACKWATER_OPERATOR")) return load_operator_config(named);
  std::vector<fs::path> places;
  if (const auto own = own_config_folder()) places.push_back(*own / "operator.yaml");
  places.emplace_back("/etc/slackwater/operator.yaml");
  for (const fs::path& place : places) {
    std::error_code unreadable;
    if (fs::exists(place, unreadable)) return load_operator_config(place);
  }
  return {};
}

}  // namespace slackwater::api
