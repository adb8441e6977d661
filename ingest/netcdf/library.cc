#include "ingest/netcdf/library.h"

#include <netcdf.h>

#include <string>

namespace slackwater::ingest::netcdf {

std::recursive_mutex& LibraryLock::mutex() {
  static std::recursive_mutex the_mutex;
  return the_mutex;
}

void check(int status, const std::filesystem::path& path, std::string_view doing, ErrorKind kind) {
  if (status == NC_NOERR) return;
  const char* advice = kind == ErrorKind::unavailable
                           ? "; check free space and permissions"
                           : "; the file is damaged or of a kind not supported; fetch it again";
  throw Error(kind, path.string() + ": " + std::string(doing) + ": NetCDF says '" +
                        nc_strerror(status) + "' (" + std::to_string(status) + ")" + advice);
}

}  // namespace slackwater::ingest::netcdf
