#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace slackwater::fuzz {

/// A folder of this process, in memory where /dev/shm is there, removed when the process ends well.
/// Each case writes its bytes to one file and decodes them into an empty staging folder.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// The file that holds these bytes now; what was staged before is gone.
  std::filesystem::path file_of(const std::uint8_t* data, std::size_t size, const char* name);
  [[nodiscard]] std::filesystem::path staging() const { return path_ / "staging"; }

 private:
  std::filesystem::path path_;
};

/// The one of this process.
ScratchFolder& scratch_folder();

}  // namespace slackwater::fuzz
