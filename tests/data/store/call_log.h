#pragma once
#include <cstddef>

/// The record of a call as fault_injection.cc writes it: this header, then path, other path and
/// data.
namespace call_log {

enum class Call : int {
  open,  ///< `path` has the descriptor from here on; made if it was not there
  close,
  write,     ///< `data` at `offset`
  truncate,  ///< to `offset` bytes
  sync,      ///< fsync or fdatasync, of a file or of a folder
  rename,    ///< `path` becomes `other path`
  unlink,    ///< a file or an empty folder
  make_folder,
  mark,  ///< `data` was written to standard output
};

struct Header {
  Call call;
  int descriptor;
  long long offset;
  std::size_t path_bytes;
  std::size_t other_bytes;
  std::size_t data_bytes;
};

}  // namespace call_log
