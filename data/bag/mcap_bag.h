#pragma once
#include <filesystem>
#include <memory>

#include "data/bag/bag.h"

namespace slackwater::bag {

/// How much of a file's unpacked chunks is held at a time.
inline constexpr std::size_t chunks_held_bytes = std::size_t{256} << 20U;

/// An MCAP file. Where more chunks overlap in time than may be held, those whose next message is
/// furthest off are let go and unpacked again when their time comes.
[[nodiscard]] std::unique_ptr<Bag> open_mcap(const std::filesystem::path& file,
                                             std::size_t held_bytes = chunks_held_bytes);

}  // namespace slackwater::bag
