#pragma once
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string_view>

// Files that commands write where the user says: one rule for all of them.

namespace slackwater::api {

/// Before any work is done: the name ends as what will be in it wants, names no folder, and the
/// folder that it lies in exists. Nothing is said of an option that was not given.
/// @param option    as the user writes it, "--out"
/// @param endings   of which the name has one, e.g. {".nc", ".csv"}; empty: any name will do
/// @throws Error(usage) that says what was found and what is expected
void expect_output(std::string_view option, const std::filesystem::path& file,
                   std::initializer_list<std::string_view> endings);

/// Whole or not at all: what stood there before stays until the new one is written.
/// @throws what `write` throws, and Error(unavailable) where the file cannot take its place
void write_beside(const std::filesystem::path& file,
                  const std::function<void(const std::filesystem::path& partial)>& write);

/// The same for a text.
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace slackwater::api
