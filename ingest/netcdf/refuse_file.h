#pragma once
#include <filesystem>
#include <string>

#include "fields/base/error.h"

namespace slackwater::ingest::netcdf {

/// Throws Error(invalid_input) that begins with the path.
[[noreturn]] inline void refuse_file(const std::filesystem::path& path, const std::string& why) {
  throw Error(ErrorKind::invalid_input, path.string() + ": " + why);
}

}  // namespace slackwater::ingest::netcdf
