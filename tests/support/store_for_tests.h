#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests {

/// A store in a fresh folder, product files beside it, and the program that works on them.
class StoreForTests {
 public:
  StoreForTests();
  /// With the store in a folder of the caller's, e.g. on a small disk.
  explicit StoreForTests(std::filesystem::path store) : store_(std::move(store)) {}

  [[nodiscard]] const std::filesystem::path& store() const noexcept { return store_; }
  /// A path for a product or site file.
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] std::string path(const std::string& name) const { return file(name).string(); }
  /// Writes a file beside the store. @return its path
  std::string write(const std::string& name, const std::string& text) const;
  /// Runs the program on this store.
  [[nodiscard]] ProgramResult run(std::vector<std::string> arguments) const;
  /// The same, started only; see `start_program`.
  [[nodiscard]] pid_t start(std::vector<std::string> arguments,
                            const std::filesystem::path& out = "/dev/null") const;

  /// Writes and ingests currents, wind and waves of these days; throws if that fails.
  void ingest_days(UtcDay first, int days) const;
  /// Ingests one file; throws if that fails.
  void ingest(const std::filesystem::path& product) const;
  /// The path of a site file in the water of the test products.
  [[nodiscard]] std::string site() const;

  /// `store list --json`.
  [[nodiscard]] std::string listing() const;
  /// Every file of the store with its sha256: equal before and after means that the store is as it
  /// was. SQLite's side files are left out where they hold nothing.
  [[nodiscard]] std::map<std::string, std::string> digests() const;

 private:
  TemporaryFolder folder_;
  std::filesystem::path store_;
};

/// All bytes of a file.
[[nodiscard]] std::string read_bytes(const std::filesystem::path& file);
void write_bytes(const std::filesystem::path& file, const std::string& bytes);

}  // namespace slackwater::tests
