#include "api/program/secret_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::secret_file_test {
namespace {

std::string why_not(const std::filesystem::path& file) {
  try {
    api::expect_secret(file);
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "";
}

struct SecretFile : testing::Test {
  SecretFile() { std::ofstream(file) << "0123456789abcdef\n"; }
  [[nodiscard]] std::string refused(mode_t mode) const {
    EXPECT_EQ(::chmod(file.c_str(), mode), 0);
    return why_not(file);
  }
  TemporaryFolder folder;
  std::filesystem::path file = folder / "token";
};

TEST_F(SecretFile, IsOneThatNobodyElseReadsOrChanges) {
  for (const mode_t mode : {0600U, 0400U, 0640U, 0660U}) EXPECT_EQ(refused(mode), "") << mode;
  for (const mode_t mode : {0644U, 0604U, 0666U, 0444U}) {
    const std::string why = refused(mode);
    EXPECT_TRUE(contains(why, "may read")) << why;
    EXPECT_TRUE(contains(why, "chmod 600 " + file.string())) << why;
  }
  EXPECT_TRUE(contains(refused(0602), "may change (mode 0602)"));
}

TEST_F(SecretFile, IsLookedAtBehindALink) {
  const std::filesystem::path link = folder / "link";
  std::filesystem::create_symlink(file, link);
  EXPECT_EQ(::chmod(file.c_str(), 0644), 0);
  EXPECT_TRUE(contains(why_not(link), "may read"));
}

TEST_F(SecretFile, ThatIsNotThereIsLeftToWhoeverOpensIt) {
  EXPECT_EQ(why_not(folder / "nowhere"), "");
}

}  // namespace
}  // namespace slackwater::tests::secret_file_test
