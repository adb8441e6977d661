#pragma once
#include <filesystem>
#include <functional>
#include <string_view>

namespace slackwater {

/// Writes a file whole or not at all: what stood there before stays until the new one is complete,
/// and stays for good where that fails. Beside it, and gone afterwards: FILE.partial.
/// @param write  makes the file of the name that it is given
/// @throws what `write` throws, and Error(unavailable) where the file cannot take its place
void write_beside(const std::filesystem::path& file,
                  const std::function<void(const std::filesystem::path& partial)>& write);

/// The same for a text. Error(unavailable) too where there is no room for it.
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace slackwater
