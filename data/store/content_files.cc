#include "data/store/content_files.h"

#include <algorithm>

#include "data/store/durable.h"
#include "data/store/layout.h"
#include "fields/base/check.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"

namespace slackwater::store {

SealedFile seal(const std::filesystem::path& staged) {
  SealedFile sealed{staged, sha256_of_file(staged), 0};
  std::error_code problem;
  sealed.bytes = std::filesystem::file_size(staged, problem);
  if (problem) {
    throw Error(ErrorKind::unavailable,
                "cannot read the size of " + staged.string() + ": " + problem.message());
  }
  try {
    sync_file(staged);
  } catch (const Error&) {
    std::filesystem::remove(staged, problem);
    throw;
  }
  return sealed;
}

bool is_present(const std::filesystem::path& folder, const std::string& sha256,
                std::uint64_t bytes) {
  std::error_code problem;
  const std::uintmax_t found = std::filesystem::file_size(content_file(folder, sha256), problem);
  return !problem && found == bytes;
}

bool is_intact(const std::filesystem::path& folder, const std::string& sha256,
               std::uint64_t bytes) {
  if (!is_present(folder, sha256, bytes)) return false;
  try {
    return sha256_of_file(content_file(folder, sha256)) == sha256;
  } catch (const Error&) {
    return false;  // gone meanwhile, or unreadable
  }
}

Adoption::~Adoption() {
  for (const Placed& placed : placed_) {
    std::error_code ignored;  // what stays behind is an orphan, which harms nothing
    std::filesystem::rename(placed.to, placed.from, ignored);
  }
}

void Adoption::place(const SealedFile& file) {
  expects(file.sha256.size() == 64, "a content file is sealed before it is placed");
  const std::filesystem::path target = content_file(folder_, file.sha256);
  const std::filesystem::path target_folder = target.parent_path();
  make_folder(target_folder);
  // The name of an intact file may be newer than the last sync of its folder, so that is synced in
  // either case.
  if (std::ranges::find(folders_to_sync_, target_folder) == folders_to_sync_.end()) {
    folders_to_sync_.push_back(target_folder);
  }
  std::error_code ignored;
  const bool existed = std::filesystem::exists(target, ignored);
  if (existed && is_intact(folder_, file.sha256, file.bytes)) {
    std::filesystem::remove(file.staged, ignored);
    return;
  }
  rename_file(file.staged, target);
  if (!existed) placed_.push_back({file.staged, target});
}

void Adoption::sync() {
  // files/ as well: a process killed between making files/ab and syncing its name leaves that to
  // us.
  if (!folders_to_sync_.empty()) sync_folder(files_folder(folder_));
  for (const std::filesystem::path& folder : folders_to_sync_) sync_folder(folder);
}

}  // namespace slackwater::store
