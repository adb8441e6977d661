#pragma once
#include <filesystem>

namespace slackwater::store {

/// An open descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int value) noexcept : value_(value) {}
  Descriptor(Descriptor&& other) noexcept : value_(other.value_) { other.value_ = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();
  [[nodiscard]] int value() const noexcept { return value_; }
  [[nodiscard]] bool is_open() const noexcept { return value_ >= 0; }

 private:
  int value_;
};

/// Calls that return only once the effect would survive a power cut. All throw Error(unavailable)
/// with the path, the system's own text and what to do.

/// The contents and size of a file reach the disk.
void sync_file(const std::filesystem::path& file);
/// The names in a folder reach the disk: needed after each creation or rename in it.
void sync_folder(const std::filesystem::path& folder);
/// Makes the folder and its missing parents; each new name is synced.
void make_folder(const std::filesystem::path& folder);
/// Moves within one file system; replaces. The names are not yet synced.
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace slackwater::store
