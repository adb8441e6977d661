#pragma once
#include <filesystem>
#include <mutex>
#include <string_view>

#include "fields/base/error.h"

namespace slackwater::ingest::netcdf {

/// The one process-wide lock of NetCDF/HDF5, which are not thread-safe. Re-entrant.
class LibraryLock {
 public:
  LibraryLock();

 private:
  static std::recursive_mutex& mutex();
  std::lock_guard<std::recursive_mutex> guard_;
};

/// Throws Error(kind) "PATH: DOING: the library's own text" unless `status` is 0.
void check(int status, const std::filesystem::path& path, std::string_view doing,
           ErrorKind kind = ErrorKind::invalid_input);

}  // namespace slackwater::ingest::netcdf
