#include "fields/base/whole_file.h"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "fields/base/error.h"

namespace slackwater {
namespace {

Error unwritten(const std::filesystem::path& file, const std::string& why) {
  return {ErrorKind::unavailable,
          "writing " + file.string() + " failed (" + why +
              "); a writable folder with room was expected; check free space and permissions"};
}

}  // namespace

void write_beside(const std::filesystem::path& file,
                  const std::function<void(const std::filesystem::path& partial)>& write) {
  const std::filesystem::path partial = file.string() + ".partial";
  std::error_code problem;
  try {
    write(partial);
    std::filesystem::rename(partial, file, problem);
    if (problem) throw unwritten(file, problem.message());
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
    throw;
  }
}

void write_text(const std::filesystem::path& file, std::string_view text) {
  write_beside(file, [&](const std::filesystem::path& partial) {
    errno = 0;
    std::ofstream out(partial, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw unwritten(file, std::generic_category().message(errno));
  });
}

}  // namespace slackwater
