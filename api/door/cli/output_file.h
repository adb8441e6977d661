#pragma once
#include <filesystem>
#include <initializer_list>
#include <string_view>

// Files that commands write where the user says: one rule for all of them. They are written
// whole or not at all, see fields/base/whole_file.h.

namespace slackwater::api {

/// Before any work is done: the name ends as what will be in it wants, names no folder, and the
/// folder that it lies in exists. Nothing is said of an option that was not given.
/// @param option    as the user writes it, "--out"
/// @param endings   of which the name has one, e.g. {".nc", ".csv"}; empty: any name will do
/// @throws Error(usage) that says what was found and what is expected
void expect_output(std::string_view option, const std::filesystem::path& file,
                   std::initializer_list<std::string_view> endings);

}  // namespace slackwater::api
