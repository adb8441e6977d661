#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "api/pipeline/fetch/wanted_files.h"
#include "fields/base/config.h"
#include "fields/base/process/run_program.h"

namespace slackwater::api {

/// What kept a file from coming.
enum class Trouble {
  slow_down,      ///< asked too often: later, and more slowly
  outage,         ///< the service or the way to it: later
  updating,       ///< not out yet
  credentials,    ///< not accepted, or none
  refused,        ///< the service has no such thing
  no_room,        ///< on the disk
  memory,         ///< it wanted more than it may have
  too_slow,       ///< it took longer than it may
  not_installed,  ///< the program is not there
  damaged,        ///< what came is not what was asked for
  unknown,
  stopped,  ///< by the operator
};
/// "not out yet": in words.
[[nodiscard]] const char* words_of(Trouble trouble) noexcept;
/// Whether another try may help before the morning is over.
[[nodiscard]] bool is_passing(Trouble trouble) noexcept;

/// A program that fetches files, as its YAML file in `fetchers/` describes it.
struct Fetcher {
  std::string id;
  std::filesystem::path folder;     ///< of its file: `{here}`
  std::vector<std::string> serves;  ///< kinds of `WantedFile`
  int order = 50;                   ///< those of a kind are tried in this order
  std::string program;
  std::vector<std::string> arguments;    ///< with words in braces
  std::vector<std::string> environment;  ///< names of the variables that it is given
  std::vector<std::string> secrets;      ///< those whose values are never told
  std::chrono::seconds longest{1800};
  double memory_gb = 8;
  int attempts = 4;
  std::chrono::milliseconds first_wait{30000};  ///< twice as long each time
  std::chrono::milliseconds between{0};         ///< from one request to the next
  struct Message {
    std::string says;
    Trouble means{};
  };
  std::vector<Message> messages;

  [[nodiscard]] bool fetches(const std::string& kind) const;
  /// Whether a request of it is for a step of a forecast (`{address}`), or for all of it.
  [[nodiscard]] bool is_asked_by_step() const;
};

/// Throws Error(invalid_input) with file and line.
[[nodiscard]] Fetcher read_fetcher(const Config& config);
/// Of `fetchers/` in the data folder and in the user's own; of one id the user's. By `order`.
[[nodiscard]] std::vector<Fetcher> known_fetchers(
    const std::filesystem::path& data_folder,
    const std::optional<std::filesystem::path>& own_folder);

/// One request of it.
struct FetchRequest {
  std::vector<std::string> arguments;  ///< the program first
  std::filesystem::path target;        ///< where the file comes to be
};
/// Its arguments for a file: each word in braces has its value; one whose word has none is left
/// out, and one with `{variable}` there for each of them.
/// @param address  of a step of a wind forecast; else empty
[[nodiscard]] FetchRequest request_for(const Fetcher& fetcher, const WantedFile& wanted,
                                       const std::filesystem::path& target,
                                       const std::string& address);

/// By how it ended and what it said.
[[nodiscard]] Trouble trouble_of(const Fetcher& fetcher, const ProgramEnded& ended);
/// The last line of what it said, no secret in it.
[[nodiscard]] std::string last_word(const Fetcher& fetcher, const std::string& output);
/// The environment that it is given: of this process those variables that it names.
[[nodiscard]] std::vector<std::string> environment_of(const Fetcher& fetcher);

}  // namespace slackwater::api
