#include "data/store/content_scan.h"

#include <algorithm>

#include "data/store/layout.h"

namespace slackwater::store {

std::map<std::string, std::uint64_t> named_contents(Database& database) {
  std::map<std::string, std::uint64_t> contents;
  Statement query = database.prepare(
      "SELECT content_sha256, content_bytes FROM granule UNION "
      "SELECT content_sha256, content_bytes FROM forecast");
  while (query.step()) contents[query.checksum(0)] = static_cast<std::uint64_t>(query.integer(1));
  return contents;
}

std::vector<FoundFile> scan_files(const std::filesystem::path& folder) {
  std::vector<FoundFile> found;
  std::error_code problem;
  for (std::filesystem::recursive_directory_iterator entry(files_folder(folder), problem), end;
       !problem && entry != end; entry.increment(problem)) {
    std::error_code gone;  // by another process meanwhile
    if (entry->is_directory(gone)) continue;
    const std::uintmax_t bytes = entry->file_size(gone);
    if (gone) continue;
    std::string name = entry->path().stem().string();
    if (name.size() != 64 || content_file(folder, name) != entry->path()) name.clear();
    found.push_back({entry->path(), name, bytes});
  }
  std::ranges::sort(found, {}, &FoundFile::path);
  return found;
}

}  // namespace slackwater::store
