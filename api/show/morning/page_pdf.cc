#include "api/show/morning/page_pdf.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "api/program/run_program.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone with it.
class Scratch {
 public:
  Scratch() {
    std::error_code none;
    const fs::path within = fs::temp_directory_path(none);
    std::string name = (within / "slackwater-pdf-XXXXXX").string();
    if (none || ::mkdtemp(name.data()) == nullptr)
      throw Error(ErrorKind::unavailable, "found no room for a folder in " +
                                              (none ? std::string("TMPDIR") : within.string()) +
                                              " to print in; set TMPDIR to a writable folder");
    folder = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  fs::path folder;
};

/// ": what it said first".
std::string first_line(const std::string& said) {
  const std::string line = said.substr(0, said.find('\n'));
  return line.empty() ? line : ": " + line;
}

bool is_pdf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 5> head{};
  return stream.read(head.data(), head.size()) && std::string(head.data(), head.size()) == "%PDF-";
}

/// Chromium under one of its names. @return nothing where none can be started
std::optional<ProgramEnd> print(const fs::path& page, const fs::path& pdf,
                                const fs::path& profile) {
  std::vector<std::string> arguments{"--headless=new",
                                     "--disable-gpu",
                                     "--no-pdf-header-footer",
                                     "--disable-dev-shm-usage",
                                     "--virtual-time-budget=10000",
                                     "--host-resolver-rules=MAP * ~NOTFOUND",
                                     "--user-data-dir=" + profile.string(),
                                     "--print-to-pdf=" + pdf.string()};
  // Root may not use its sandbox. The page is our own, and it opens nothing else.
  if (::geteuid() == 0) arguments.emplace_back("--no-sandbox");
  arguments.push_back("file://" + page.string());
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    std::vector<std::string> command{name};
    command.insert(command.end(), arguments.begin(), arguments.end());
    std::optional<ProgramEnd> end;
    const auto failure = attempt([&] { end = run_program(command, "", std::chrono::minutes(1)); });
    if (!failure) return end;
  }
  return std::nullopt;
}

}  // namespace

void print_page(const fs::path& page, const fs::path& pdf) {
  const Scratch scratch;
  const fs::path printed = scratch.folder / "page.pdf";
  const fs::path copy = scratch.folder / "page.html";  // a name that an address can hold
  std::error_code failure;
  fs::copy_file(page, copy, failure);
  if (failure)
    throw Error(ErrorKind::unavailable, "copying " + page.string() + " to print it failed (" +
                                            failure.message() +
                                            "); set TMPDIR to a folder with room");
  const auto end = print(copy, printed, scratch.folder / "profile");
  if (!end)
    throw Error(ErrorKind::unavailable,
                "found no Chromium to print " + page.string() +
                    " with; the page itself is written; install it (apt install chromium)");
  if (end->is_out_of_time || end->exit_code != 0 || !is_pdf(printed))
    throw Error(ErrorKind::unavailable,
                "Chromium did not print " + page.string() + " (" +
                    (end->is_out_of_time
                         ? std::string("stopped after a minute")
                         : "exit code " + std::to_string(end->exit_code) + first_line(end->err)) +
                    "); the page itself is written; print it from a browser");
  write_beside(pdf, [&](const fs::path& partial) {
    fs::copy_file(printed, partial, fs::copy_options::overwrite_existing, failure);
    if (failure)
      throw Error(ErrorKind::unavailable, "writing " + pdf.string() + " failed (" +
                                              failure.message() +
                                              "); a writable place was expected; check its rights "
                                              "and space");
  });
}

}  // namespace slackwater::api
