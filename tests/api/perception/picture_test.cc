#include "api/perception/read_picture.h"

#include <gtest/gtest.h>

#include "api/perception/picture_size.h"
#include "fields/base/error.h"
#include "tests/api/perception/plates_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/store_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::picture_test {
namespace {

using api::read_picture;

std::string refusal(const std::filesystem::path& file) {
  try {
    (void)read_picture(file);
  } catch (const Error& error) {
    return error.message();
  }
  return {};
}

std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

TEST(ReadPicture, HasTheBytesThatWereWritten) {
  const TemporaryFolder folder;
  twin::Picture picture = plate(7, 3);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i)
    picture.rgb[i] = static_cast<std::uint8_t>(37 * i);
  write_png(folder / "a.png", picture);
  const twin::Picture read = read_picture(folder / "a.png");
  EXPECT_EQ(read.wide, 7);
  EXPECT_EQ(read.high, 3);
  EXPECT_EQ(read.rgb, picture.rgb);
  EXPECT_EQ(read.at(2, 1)[1], static_cast<std::uint8_t>(37 * (3 * (7 + 2) + 1)));
}

TEST(ReadPicture, ReadsAJpegAndSaysWhereItIsCut) {
  const TemporaryFolder folder;
  twin::Picture picture = plate(64, 40);
  paint(picture, 0, 0, 32, 40, rust);
  write_jpeg(folder / "a.jpg", picture);
  const twin::Picture read = read_picture(folder / "a.jpg");
  ASSERT_EQ(read.wide, 64);
  ASSERT_EQ(read.high, 40);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(read.at(8, 20)[c], rust[c], 2);
    EXPECT_NEAR(read.at(60, 20)[c], steel[c], 2);
  }
  const std::string whole = read_bytes(folder / "a.jpg");
  write_bytes(folder / "cut.jpg", whole.substr(0, whole.size() / 2));
  EXPECT_TRUE(contains(refusal(folder / "cut.jpg"), "damaged picture"));
}

TEST(ReadPicture, RefusesWhatIsDamagedCutOrNoPicture) {
  const TemporaryFolder folder;
  write_png(folder / "a.png", plate(40, 30, rust));
  const std::string whole = read_bytes(folder / "a.png");
  for (const std::size_t length : {std::size_t{0}, std::size_t{7}, std::size_t{23}}) {
    write_bytes(folder / "cut.png", whole.substr(0, length));
    EXPECT_TRUE(contains(refusal(folder / "cut.png"), "neither PNG nor JPEG")) << length;
  }
  write_bytes(folder / "half.png", whole.substr(0, whole.size() - 20));
  EXPECT_TRUE(contains(refusal(folder / "half.png"), "damaged picture"));
  std::string damaged = whole;
  damaged[16] = '\x7f';  // two thousand million pixels wide, says its head
  write_bytes(folder / "wide.png", damaged);
  EXPECT_TRUE(contains(refusal(folder / "wide.png"), "expected 1 to 100000000 pixels"));
  write_bytes(folder / "text.png", "time,speed\n");
  EXPECT_TRUE(contains(refusal(folder / "text.png"), "neither PNG nor JPEG"));
  EXPECT_TRUE(contains(refusal(folder / "none.png"), "found no file"));
  EXPECT_TRUE(contains(refusal("/dev/zero"), "no regular file"));
}

TEST(StatedSize, OfAJpegIsInItsFrameWhateverStandsBefore) {
  const std::string begin = "\xff\xd8";
  const std::string note = std::string("\xff\xe0\x00\x06", 4) + "note";
  const std::string frame = std::string("\xff\xff\xc2\x00\x11\x08\x01\x02\x03\x04\x03", 11);
  const auto size = api::stated_size(bytes_of(begin + note + frame));
  ASSERT_TRUE(size);
  EXPECT_EQ(size->high, 0x0102U);
  EXPECT_EQ(size->wide, 0x0304U);
  EXPECT_FALSE(api::stated_size(bytes_of(begin + note)));
  EXPECT_FALSE(api::stated_size(bytes_of(begin + note + frame.substr(0, 9))));
  EXPECT_FALSE(api::stated_size(bytes_of(begin + "garbage garbage")));
}

}  // namespace
}  // namespace slackwater::tests::picture_test
