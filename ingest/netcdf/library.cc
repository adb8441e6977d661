#include "ingest/netcdf/library.h"

#include <H5Epublic.h>
#include <H5public.h>
#include <netcdf.h>

#include <string>

namespace slackwater::ingest::netcdf {

LibraryLock::LibraryLock() : guard_(mutex()) {
  // HDF5 prints what NetCDF merely tries out, for each thread anew; NetCDF silences the first
  // thread alone.
  thread_local const auto silenced = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  static_cast<void>(silenced);
}

std::recursive_mutex& LibraryLock::mutex() {
  static std::recursive_mutex the_mutex;
  // HDF5's exit handler crashes where a file could not be written to its end (a full disk). Files
  // are closed by their owners, so it has nothing else to do; it must be declined before the
  // library is first used.
  [[maybe_unused]] static const int declined = H5dont_atexit();
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
