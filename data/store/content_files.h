#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace slackwater::store {

/// A finished content file: hashed, and its bytes on the disk.
struct SealedFile {
  std::filesystem::path staged;
  std::string sha256;
  std::uint64_t bytes = 0;
};

/// Hashes and fsyncs. If the fsync fails the file is removed: Linux then holds its pages for clean
/// though they never reached the disk, so a later fsync of the same file would promise what it
/// cannot keep.
[[nodiscard]] SealedFile seal(const std::filesystem::path& staged);

/// Whether the content file is there with this size (cheap), or with this hash too (reads it).
[[nodiscard]] bool is_present(const std::filesystem::path& folder, const std::string& sha256,
                              std::uint64_t bytes);
[[nodiscard]] bool is_intact(const std::filesystem::path& folder, const std::string& sha256,
                             std::uint64_t bytes);

/// Moves sealed files to their places in files/. Until `keep`, destruction moves them back.
/// The caller holds the catalogue's write lock throughout, so that a prune never takes a file
/// between its move and the row that names it.
class Adoption {
 public:
  explicit Adoption(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~Adoption();
  Adoption(const Adoption&) = delete;
  Adoption& operator=(const Adoption&) = delete;

  /// A file that is there already, intact, is left alone; a damaged one is replaced.
  void place(const SealedFile& file);
  /// The new names reach the disk. To be called before the transaction commits.
  void sync();
  /// From here on the files stay, whatever becomes of the commit: a commit that reported failure
  /// may still have reached the disk, and then its rows need their files.
  void keep() noexcept { placed_.clear(); }

 private:
  struct Placed {
    std::filesystem::path from;
    std::filesystem::path to;
  };
  std::filesystem::path folder_;
  std::vector<Placed> placed_;
  std::vector<std::filesystem::path> folders_to_sync_;
};

}  // namespace slackwater::store
