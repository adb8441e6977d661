#pragma once
#include <cstddef>
#include <filesystem>

namespace slackwater::dds {

/// Removes what participants that were killed left in shared memory: segments and ports of Fast DDS
/// whose lock nobody holds, with their semaphores. Those of processes that live are locked and
/// stay.
/// @return files removed
/// Source of the names: eProsima Fast DDS 2.9, `fastdds shm clean`.
std::size_t sweep_shared_memory(const std::filesystem::path& folder = "/dev/shm");

}  // namespace slackwater::dds
