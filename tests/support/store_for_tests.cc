#include "tests/support/store_for_tests.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "fields/base/encode/sha256.h"
#include "tests/support/product_files_for_tests.h"

namespace slackwater::tests {

StoreForTests::StoreForTests() : store_(folder_ / "store") {}

ProgramResult StoreForTests::run(std::vector<std::string> arguments) const {
  arguments.insert(arguments.end(), {"--store", store_.string()});
  return run_program(arguments);
}

pid_t StoreForTests::start(std::vector<std::string> arguments,
                           const std::filesystem::path& out) const {
  arguments.insert(arguments.end(), {"--store", store_.string()});
  return start_program(arguments, {}, out);
}

void StoreForTests::ingest(const std::filesystem::path& product) const {
  const ProgramResult result = run({"ingest", product.string(), "--at", "2025-03-20T00:00:00Z"});
  if (result.exit_code != 0)
    throw std::runtime_error("cannot ingest " + product.string() + ": " + result.err);
}

void StoreForTests::ingest_days(UtcDay first, int days) const {
  std::vector<std::string> arguments{"ingest", "--at", "2025-03-20T00:00:00Z"};
  for (int i = 0; i < days; ++i) {
    const UtcDay day = first + std::chrono::days(i);
    const std::string name = format_day(day) + ".nc";
    arguments.push_back(write_product(file("currents-" + name), current_product(day)).string());
    arguments.push_back(write_product(file("wind-" + name), wind_product(day)).string());
    arguments.push_back(write_product(file("waves-" + name), wave_product(day)).string());
  }
  const ProgramResult result = run(arguments);
  if (result.exit_code != 0) throw std::runtime_error("cannot ingest: " + result.err);
}

std::string StoreForTests::site() const { return write_site(file("test_site.yaml")).string(); }

std::string StoreForTests::listing() const {
  const ProgramResult result = run({"store", "list", "--json"});
  if (result.exit_code != 0) throw std::runtime_error("cannot list the store: " + result.err);
  return result.out;
}

std::map<std::string, std::string> StoreForTests::digests() const {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(store_)) {
    const std::string name = entry.path().lexically_relative(store_).string();
    if (name == "catalogue.sqlite-shm") continue;  // an index in shared memory, rebuilt at will
    if (entry.is_regular_file() && (entry.file_size() > 0 || name != "catalogue.sqlite-wal")) {
      all[name] = sha256_of_file(entry.path());
    }
  }
  return all;
}

std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string StoreForTests::write(const std::string& name, const std::string& text) const {
  write_bytes(file(name), text);
  return path(name);
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream << bytes;
}

}  // namespace slackwater::tests
