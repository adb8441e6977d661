#include "api/program/secret_file.h"

#include <sys/stat.h>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {

void expect_secret(const std::filesystem::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return;
  if ((found.st_mode & (S_IROTH | S_IWOTH)) == 0) return;
  throw Error(ErrorKind::invalid_input,
              formatted("{}: found tokens that everybody on this machine may {} (mode {:04o}), "
                        "expected them to be yours alone; run: chmod 600 {}",
                        file.string(), (found.st_mode & S_IROTH) != 0 ? "read" : "change",
                        found.st_mode & 07777U, file.string()));
}

}  // namespace slackwater::api
