#include "api/door/morning/hook.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "api/program/run_program.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// Whether this process is the one that tells it.
bool claim(const std::filesystem::path& mark) {
  const int file = ::open(mark.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file < 0 && errno == EEXIST) return false;
  if (file < 0)
    throw Error(
        ErrorKind::unavailable,
        "writing " + mark.string() + " failed (" + std::strerror(errno) +
            "); the hook was not run, because it might run twice; make the folder writable");
  ::fsync(file);
  ::close(file);
  return true;
}

}  // namespace

std::string tell_hook(const Hook& hook, const std::filesystem::path& folder, std::int64_t forecast,
                      const std::string& verdict) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  const std::filesystem::path mark = folder / formatted("hook-{}", forecast);
  if (std::filesystem::exists(mark, ignored)) return {};
  if (::access(hook.command.front().c_str(), X_OK) != 0)  // its one chance is not used up
    return "the hook was not run: found no program to start as " + hook.command.front() +
           "; correct its path or permissions, and issue the forecast again";
  if (!claim(mark)) return {};
  const std::string name = "the hook " + hook.command.front();
  try {
    const ProgramEnd end = run_program(hook.command, verdict, hook.limit);
    if (end.is_out_of_time)
      return name +
             formatted(" was stopped after {:g} s", static_cast<double>(hook.limit.count()) / 1000);
    if (end.exit_code == 0) return name + " was told";
    const std::string said = end.err.substr(0, end.err.find('\n'));
    return name + formatted(" failed with exit code {}", end.exit_code) +
           (said.empty() ? "" : ": " + said);
  } catch (const Error& problem) {
    return "the hook was not run: " + problem.message();
  }
}

}  // namespace slackwater::api
