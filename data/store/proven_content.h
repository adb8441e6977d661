#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace slackwater::store {

/// What is wrong with a content file, in words that follow its name: "is missing", "cannot be read:
/// …", "no longer holds the bytes that were stored (sha256 differs)". Nothing where its bytes are
/// those that its name promises.
///
/// The libraries that open content files trust them: a byte gone wrong inside one can end the
/// process. So nothing stored is opened before it was asked about here.
///
/// Reads the whole file once; the verdict is kept for this process and holds as long as the file
/// lies there unchanged (device, inode, size, times of writing and of change). Thread-safe.
[[nodiscard]] std::optional<std::string> content_fault(const std::filesystem::path& folder,
                                                       const std::string& content_sha256);

/// The path of a content file that was found whole.
/// @throws Error(invalid_input) that names the file, its fault and `slackwater store check`
[[nodiscard]] std::filesystem::path proven_content(const std::filesystem::path& folder,
                                                   const std::string& content_sha256);

}  // namespace slackwater::store
