#pragma once
#include <cstddef>
#include <filesystem>

namespace slackwater::ingest::netcdf {

/// Keeps the disk busy while a large file is still being written, so that the fsync at its end has
/// little left to wait for. A hint to the kernel only: durability is the fsync's.
class Writeback {
 public:
  /// Of a file that exists, or will before the first `wrote`.
  explicit Writeback(std::filesystem::path file) : file_(std::move(file)) {}
  ~Writeback();
  Writeback(const Writeback&) = delete;
  Writeback& operator=(const Writeback&) = delete;
  /// So many more bytes went to the file; every 64 MiB the kernel is asked to begin writing them.
  void wrote(std::size_t bytes) noexcept;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::size_t pending_ = 0;
};

}  // namespace slackwater::ingest::netcdf
