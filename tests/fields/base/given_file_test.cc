// Files that somebody names: read where they are files, refused at once where they could keep us.
#include "fields/base/given_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::given_file_test {
namespace {

struct GivenFile : testing::Test {
  [[nodiscard]] std::string refusal(const std::filesystem::path& file,
                                    std::size_t most_bytes = 100) const {
    return error_of([&] { return text_of_given_file(file, "a list", most_bytes); });
  }
  const TemporaryFolder folder;
};

TEST_F(GivenFile, IsReadWhole) {
  const std::string text = std::string(300'000, 'x') + std::string("\0\r\n", 3);
  std::ofstream(folder / "file", std::ios::binary) << text;
  EXPECT_EQ(text_of_given_file(folder / "file", "a list"), text);
  std::filesystem::create_symlink(folder / "file", folder / "link");
  EXPECT_EQ(text_of_given_file(folder / "link", "a list"), text);
  std::ofstream(folder / "empty");
  EXPECT_EQ(text_of_given_file(folder / "empty", "a list"), "");
}

TEST_F(GivenFile, IsNoPipeAndNoDevice) {
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_TRUE(contains(refusal(folder / "pipe"), "found a pipe or a device"));
  EXPECT_TRUE(contains(refusal("/dev/zero"), "where a list was expected"));
  EXPECT_TRUE(contains(refusal(folder.path()), "found the folder"));
  EXPECT_THROW(refuse_device(folder / "pipe"), Error);
  EXPECT_NO_THROW(refuse_device(folder / "nothing"));
  EXPECT_NO_THROW(refuse_device(folder.path()));
}

TEST_F(GivenFile, IsThereAndNotTooLong) {
  EXPECT_TRUE(contains(refusal(folder / "nothing"), "check the path"));
  EXPECT_TRUE(contains(refusal(folder / std::string(300, 'x')), "check the path"));
  std::filesystem::create_symlink(folder / "round", folder / "round");
  EXPECT_TRUE(contains(refusal(folder / "round"), "cannot read"));
  std::ofstream(folder / "long") << std::string(101, 'x');
  EXPECT_TRUE(contains(refusal(folder / "long"), "longer than"));
  EXPECT_EQ(refusal(folder / "long", 101), "no error");
}

}  // namespace
}  // namespace slackwater::tests::given_file_test
