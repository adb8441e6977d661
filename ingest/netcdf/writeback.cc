#include "ingest/netcdf/writeback.h"

#include <fcntl.h>
#include <unistd.h>

namespace slackwater::ingest::netcdf {

Writeback::~Writeback() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void Writeback::wrote(std::size_t bytes) noexcept {
  constexpr std::size_t stretch = std::size_t{64} << 20;
  pending_ += bytes;
  if (pending_ < stretch) return;
  pending_ = 0;
  // The library hides its own descriptor; any other one of the same file serves.
  if (descriptor_ < 0) descriptor_ = ::open(file_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ >= 0) ::sync_file_range(descriptor_, 0, 0, SYNC_FILE_RANGE_WRITE);
}

}  // namespace slackwater::ingest::netcdf
