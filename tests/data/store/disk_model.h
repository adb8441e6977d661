#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fields/base/numbers/random.h"
#include "tests/data/store/call_log.h"

namespace slackwater::store::tests {

/// One recorded call.
struct RecordedCall {
  call_log::Call call{};
  int descriptor = -1;
  long long offset = 0;
  std::string path;
  std::string other;
  std::string data;
};

[[nodiscard]] std::vector<RecordedCall> read_call_log(const std::filesystem::path& log);

/// A disk with a cache that forgets: what a file system promises by POSIX and no more.
///
/// Bytes written are certain after an fsync of their file, names made or removed after an fsync of
/// their folder; until then each 512-byte sector and each name may or may not survive a power cut,
/// in any combination. (Journalling file systems keep more; a program that is safe here is safe
/// there.)
class DiskModel {
 public:
  enum class Survival {
    none,  ///< everything not synced is lost
    all,   ///< nothing is lost, as when only the process dies
    some,  ///< by lot
  };

  explicit DiskModel(const std::filesystem::path& root);
  void apply(const RecordedCall& call);
  /// Writes what a power cut at this instant leaves below the root into `target`.
  void power_cut(const std::filesystem::path& target, Survival survival, Rng& rng) const;

 private:
  struct Node;
  struct Change {  ///< of a file: bytes at an offset, or (no bytes) a new length; of a folder: a
                   ///< name
    long long offset = 0;
    std::string bytes;
    bool is_truncation = false;
    std::string name;
    std::shared_ptr<Node> node;  ///< null: the name goes
  };
  struct Node {
    bool is_folder = false;
    std::string bytes;                                   ///< durable
    std::map<std::string, std::shared_ptr<Node>> names;  ///< durable
    std::map<std::string, std::shared_ptr<Node>> live_names;
    std::vector<Change> pending;
  };
  static void settle(Node& node);
  static void write(const Node& node, const std::filesystem::path& target, Survival survival,
                    Rng& rng);
  [[nodiscard]] std::shared_ptr<Node> find(const std::filesystem::path& path) const;
  void set_name(const std::string& path, std::shared_ptr<Node> node);

  std::filesystem::path root_path_;
  std::shared_ptr<Node> root_;
  std::map<int, std::shared_ptr<Node>> descriptors_;
};

}  // namespace slackwater::store::tests
