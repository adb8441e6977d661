// `slackwater serve` with tokens that others may read, and where other machines may reach it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <sstream>

#include "tests/api/door/sessions/operators_for_tests.h"
#include "tests/support/comes_true.h"
#include "tests/support/contains.h"
#include "tests/support/refusal.h"
#include "tests/support/started_program.h"

namespace slackwater::tests::serve_secrets_test {
namespace {

struct ServeSecrets : testing::Test {
  ServeSecrets() {
    write_file(folder / "one.yaml", rovs_yaml("one rov", {"rov 1"}));
    write_file(folder / "sessions.yaml",
               "sessions:\n  - {id: dawn, scenario: one.yaml}\n" + people_yaml());
    write_file(folder / "people.yaml", people_yaml());
    write_file(folder / "token", "write-0123456789abcdef\n");
  }
  /// What it says on stderr until it serves.
  [[nodiscard]] std::string said_at(const std::string& address,
                                    const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"serve", "--address", address,   "--port",
                                   "0",     "--json",    "--store", folder / "store"};
    words.insert(words.end(), more.begin(), more.end());
    std::filesystem::remove(folder / "out");
    StartedProgram program(start_program(words, {}, folder / "out", folder / "err"));
    EXPECT_TRUE(
        comes_true([&] { return text_in("out").ends_with("\n"); }, std::chrono::seconds(60)))
        << text_in("err");
    EXPECT_EQ(program.end(SIGTERM), 0);
    return text_in("err");
  }
  [[nodiscard]] std::string text_in(const char* file) const {
    std::ostringstream text;
    text << std::ifstream(folder / file).rdbuf();
    return text.str();
  }
  TemporaryFolder folder;
};

TEST_F(ServeSecrets, ThatEverybodyMayReadAreRefused) {
  for (const char* file : {"sessions.yaml", "people.yaml", "token"})
    ASSERT_EQ(::chmod((folder / file).c_str(), 0644), 0);
  const std::string store = folder / "store";
  const std::vector<std::string> words{"may read", "chmod 600"};
  expect_refusal(run_program({"serve", "--sessions", folder / "sessions.yaml", "--port", "0",
                              "--store", store}),
                 3, words);
  expect_refusal(
      run_program({"serve", "--token-file", folder / "token", "--port", "0", "--store", store}), 3,
      words);
  expect_refusal(run_program({"live", folder / "one.yaml", "--people", "0", "--people-file",
                              folder / "people.yaml", "--store", store}),
                 3, words);
}

TEST_F(ServeSecrets, AWarningIsGivenWhereOtherMachinesMayReachIt) {
  const std::string sessions = folder / "sessions.yaml", token = folder / "token";
  EXPECT_TRUE(contains(said_at("0.0.0.0", {"--sessions", sessions}), "tokens too"));
  EXPECT_TRUE(contains(said_at("0.0.0.0", {"--token-file", token}), "tokens too"));
  const std::string bare = said_at("0.0.0.0");
  EXPECT_TRUE(contains(bare, "warning open to other machines address=0.0.0.0")) << bare;
  EXPECT_TRUE(contains(bare, "without a password")) << bare;
  EXPECT_TRUE(contains(bare, "warning monitoring is open to other machines")) << bare;
  EXPECT_FALSE(contains(said_at("0.0.0.0", {"--monitoring", "local"}), "monitoring is open"));
  EXPECT_FALSE(contains(said_at("127.0.0.1", {"--token-file", token}), "other machines"));
}

}  // namespace
}  // namespace slackwater::tests::serve_secrets_test
