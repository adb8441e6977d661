#include "ingest/netcdf/magic.h"

#include <array>
#include <fstream>
#include <string_view>

namespace slackwater::ingest::netcdf {

bool begins_as_netcdf(const std::filesystem::path& file) {
  std::array<char, 4> magic{};
  std::ifstream(file, std::ios::binary).read(magic.data(), magic.size());
  const std::string_view found(magic.data(), magic.size());
  return found.starts_with("CDF") || found == "\x89HDF";
}

}  // namespace slackwater::ingest::netcdf
