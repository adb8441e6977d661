#pragma once
#include <filesystem>

#include "fields/base/descriptor.h"

namespace slackwater::store {

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
