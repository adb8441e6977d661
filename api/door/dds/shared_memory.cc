#include "api/door/dds/shared_memory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace slackwater::dds {
namespace {

/// Holds the lock of a file that nobody else holds.
class Lock {
 public:
  explicit Lock(const std::filesystem::path& file)
      : file_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
    is_held_ = file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) == 0;
  }
  ~Lock() {
    if (file_ >= 0) ::close(file_);
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  [[nodiscard]] bool is_held() const noexcept { return is_held_; }

 private:
  int file_;
  bool is_held_ = false;
};

constexpr std::chrono::seconds youngest_left(10);

bool is_old(const std::filesystem::path& file) {
  std::error_code gone_since;
  const auto made = std::filesystem::last_write_time(file, gone_since);
  return !gone_since && decltype(made)::clock::now() - made > youngest_left;
}

bool is_lock(const std::string& name) {
  return name.starts_with("fastrtps_") && (name.ends_with("_el") || name.ends_with("_sl"));
}

}  // namespace

std::size_t sweep_shared_memory(const std::filesystem::path& folder) {
  std::size_t removed = 0;
  const auto remove = [&](const std::string& name) {
    std::error_code ignored;
    removed += std::filesystem::remove(folder / name, ignored) ? 1U : 0U;
  };
  std::vector<std::string> locks;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (std::string name = entry.path().filename(); is_lock(name) && is_old(entry.path()))
      locks.push_back(std::move(name));
  for (const std::string& name : locks) {
    const std::string base = name.substr(0, name.size() - 3);
    // A port has one lock for a reader alone and one for several: both must be free.
    const Lock exclusive(folder / (base + "_el")), shared(folder / (base + "_sl"));
    const auto is_free = [&](const Lock& lock, const char* ending) {
      return lock.is_held() || !std::filesystem::exists(folder / (base + ending));
    };
    if (!is_free(exclusive, "_el") || !is_free(shared, "_sl")) continue;
    remove(base);
    remove("sem." + base + "_mutex");
    remove(base + "_el");
    remove(base + "_sl");
  }
  return removed;
}

StartInSharedMemory::StartInSharedMemory(const std::filesystem::path& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ < 0) return;
  if (::flock(folder_, LOCK_EX | LOCK_NB) == 0) sweep_shared_memory(folder);
  // A sweep takes milliseconds; whoever holds the lock for longer does not hold us.
  for (int i = 0; i < 100 && ::flock(folder_, LOCK_SH | LOCK_NB) != 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

StartInSharedMemory::~StartInSharedMemory() {
  if (folder_ >= 0) ::close(folder_);
}

}  // namespace slackwater::dds
