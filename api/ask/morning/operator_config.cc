#include "api/ask/morning/operator_config.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <iterator>

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
    throw Error(ErrorKind::not_found,
                "found no " + place.string() +
                    " that can be read, expected a file of yours; correct its path or permissions");
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

/// The place and every folder and link on the way to it: whoever writes in one of them can put
/// another file in its place.
void expect_way_ours(const fs::path& named, int links = 0) {
  if (links > 40)
    throw Error(ErrorKind::invalid_input,
                "found links that lead in a circle at " + named.string() + "; mend them");
  fs::path so_far = "/";
  expect_ours(so_far);
  const fs::path way = fs::absolute(named);
  for (auto part = std::next(way.begin()); part != way.end(); ++part) {
    const fs::path next = *part == ".." ? so_far.parent_path() : so_far / *part;
    std::error_code unreadable;
    if (*part == "." || part->empty()) continue;
    if (!fs::is_symlink(next, unreadable)) {
      expect_ours(next);
      so_far = next;
      continue;
    }
    struct stat link {};
    if (::lstat(next.c_str(), &link) != 0 || (link.st_uid != 0 && link.st_uid != ::geteuid()))
      throw Error(ErrorKind::invalid_input, "found the link " + next.string() +
                                                " owned by another user, expected you or root; "
                                                "change its owner");
    fs::path rest = so_far / fs::read_symlink(next);
    for (auto more = std::next(part); more != way.end(); ++more) rest /= *more;
    return expect_way_ours(rest, links + 1);
  }
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
  expect_way_ours(named);
  const Config config = Config::load(named);
  OperatorConfig out;
  if (const auto hook = config.optional_child("hook")) out.hook = read_hook(*hook);
  config.expect_all_read();
  if (out.hook) expect_way_ours(out.hook->command.front());
  return out;
}

OperatorConfig operator_config() {
  if (const char* named = std::getenv("SLACKWATER_OPERATOR"); named != nullptr && *named != '\0')
    return load_operator_config(named);
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
