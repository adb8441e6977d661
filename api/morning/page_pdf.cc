#include "api/morning/page_pdf.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <string>

#include "api/program/run_program.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

namespace fs = std::filesystem;

/// On PATH; empty: there is none.
fs::path chromium() {
  const char* path = std::getenv("PATH");
  const std::string folders = path == nullptr ? "/usr/bin" : path;
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    for (std::size_t from = 0; from <= folders.size();) {
      const std::size_t to = std::min(folders.find(':', from), folders.size());
      const fs::path file = fs::path(folders.substr(from, to - from)) / name;
      if (file.is_absolute() && ::access(file.c_str(), X_OK) == 0) return file;
      from = to + 1;
    }
  }
  return {};
}

/// A folder of its own, gone with it.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "slackwater-pdf-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw Error(ErrorKind::unavailable, "found no room for a folder in " +
                                              fs::temp_directory_path().string() +
                                              "; set TMPDIR to a writable one");
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

bool is_pdf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 5> head{};
  return stream.read(head.data(), head.size()) && std::string(head.data(), head.size()) == "%PDF-";
}

}  // namespace

void print_page(const fs::path& page, const fs::path& pdf) {
  const fs::path program = chromium();
  if (program.empty())
    throw Error(ErrorKind::unavailable,
                "found no Chromium to print " + page.string() +
                    " with; the page itself is written; install it (apt install chromium)");
  const Scratch scratch;
  const fs::path printed = scratch.folder / "page.pdf";
  // Root may not use its sandbox. The page is our own, and it opens nothing else.
  std::vector<std::string> command{program.string(),
                                   "--headless=new",
                                   "--disable-gpu",
                                   "--no-pdf-header-footer",
                                   "--disable-dev-shm-usage",
                                   "--virtual-time-budget=10000",
                                   "--host-resolver-rules=MAP * ~NOTFOUND",
                                   "--user-data-dir=" + (scratch.folder / "profile").string(),
                                   "--print-to-pdf=" + printed.string()};
  if (::geteuid() == 0) command.emplace_back("--no-sandbox");
  command.push_back("file://" + fs::absolute(page).string());
  const ProgramEnd end = run_program(command, "", std::chrono::minutes(1));
  if (end.is_out_of_time || end.exit_code != 0 || !is_pdf(printed))
    throw Error(ErrorKind::unavailable,
                program.string() + " did not print " + page.string() + " (" +
                    (end.is_out_of_time ? "stopped after a minute"
                                        : "exit code " + std::to_string(end.exit_code)) +
                    "); the page itself is written; print it from a browser");
  fs::path part = pdf;
  part += ".part";
  std::error_code failure;
  fs::copy_file(printed, part, fs::copy_options::overwrite_existing, failure);
  if (!failure) fs::rename(part, pdf, failure);
  if (failure) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw Error(ErrorKind::unavailable, "writing " + pdf.string() + " failed (" +
                                            failure.message() + "); a writable place was expected");
  }
}

}  // namespace slackwater::api
