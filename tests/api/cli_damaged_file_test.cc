// Product files with a byte too many: NetCDF-4 trusts what it reads, so some of them crash the
// library. Each is one error that names it, and the files after it are read.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fields/base/numbers/random.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_damaged_file_test {
namespace {

using namespace std::chrono;
using nlohmann::json;

constexpr UtcDay day = sys_days{2025y / March / 6};
constexpr int damaged_files = 200;

/// The file with one byte more, anywhere.
std::string with_a_byte_more(const std::string& whole, Rng& rng) {
  std::string bytes = whole;
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(rng.bits() % whole.size()),
               static_cast<char>(rng.bits() & 0xffU));
  return bytes;
}

TEST(DamagedProductFiles, OneByteInsertedAnywhereIsOneErrorAndTheFilesAfterItAreStored) {
  const StoreForTests store;
  const std::string whole = read_bytes(write_product(store.file("whole.nc"), wave_product(day)));
  Rng rng(2025, "inserted bytes");
  std::vector<std::string> arguments{"ingest", "--json"};
  for (int i = 0; i < damaged_files; ++i) {
    const auto file = store.file("damaged-" + std::to_string(i) + ".nc");
    write_bytes(file, with_a_byte_more(whole, rng));
    arguments.push_back(file.string());
  }
  const auto good = write_product(store.file("good.nc"), current_product(day + days(1)));
  arguments.push_back(good.string());
  const ProgramResult result = store.run(arguments);
  EXPECT_EQ(result.exit_code, 3) << result.err;
  const json answer = json::parse(result.out);
  std::size_t crashes = 0;
  for (const json& failed : answer["failed"]) {
    const auto message = failed["message"].get<std::string>();
    EXPECT_EQ(failed["kind"], "invalid_input") << message;
    EXPECT_NE(message.find(std::filesystem::path(failed["file"]).filename().string()),
              std::string::npos)
        << message;
    if (message.find("crashed the NetCDF library") != std::string::npos) ++crashes;
  }
  EXPECT_EQ(answer["failed"].size() + answer["files"].size(), damaged_files + 1U);
  RecordProperty("crashes", static_cast<int>(crashes));
  ASSERT_FALSE(answer["files"].empty());
  EXPECT_EQ(answer["files"].back()["file"], good.string());
  EXPECT_TRUE(answer["files"].back()["stored"].get<bool>());
  const json check = json::parse(store.run({"store", "check", "--json"}).out);
  EXPECT_EQ(check["findings"], json::array()) << "nothing is left of those that died";
}

}  // namespace
}  // namespace slackwater::tests::cli_damaged_file_test
