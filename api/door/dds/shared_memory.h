#pragma once
#include <cstddef>
#include <filesystem>

namespace slackwater::dds {

/// Removes what participants that were killed left in shared memory: segments and ports of Fast DDS
/// whose lock nobody holds, with their semaphores. Those of processes that live are locked and
/// stay; so does what is younger than ten seconds, since who starts makes a file before its lock.
/// @return files removed
/// Source of the names: eProsima Fast DDS 2.9, `fastdds shm clean`.
std::size_t sweep_shared_memory(const std::filesystem::path& folder = "/dev/shm");

/// While a participant is made. Who starts may take over an old file that was left, and between its
/// opening it and its locking it a sweep would take it away: the participant would hear nobody,
/// without a word. So one sweeps at the start if nobody else is starting, and nobody sweeps until
/// the start is over.
class StartInSharedMemory {
 public:
  explicit StartInSharedMemory(const std::filesystem::path& folder = "/dev/shm");
  ~StartInSharedMemory();
  StartInSharedMemory(const StartInSharedMemory&) = delete;
  StartInSharedMemory& operator=(const StartInSharedMemory&) = delete;

 private:
  int folder_;  ///< descriptor, by whose lock starts know of each other; negative: there is none
};

}  // namespace slackwater::dds
