#include "api/perception/jpeg.h"

#include <gtest/gtest.h>

#include <fstream>

#include "api/perception/read_picture.h"
#include "fields/base/check.h"
#include "tests/api/perception/plates_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::jpeg_test {
namespace {

/// Slopes and an edge, of sizes that are no whole blocks of 16.
twin::Picture slopes() {
  twin::Picture picture = plate(150, 99);
  for (int j = 0; j < picture.high; ++j)
    for (int i = 0; i < picture.wide; ++i) {
      auto* const at = picture.rgb.data() + 3 * (j * picture.wide + i);
      at[0] = static_cast<std::uint8_t>(i);
      at[1] = static_cast<std::uint8_t>(2 * j);
      at[2] = i < 75 ? 40 : 200;
    }
  return picture;
}

TEST(JpegOf, IsReadBackAsThePictureThatItIs) {
  const TemporaryFolder folder;
  const twin::Picture picture = slopes();
  const auto bytes = api::jpeg_of(picture);
  std::ofstream(folder / "a.jpg", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  const twin::Picture read = api::read_picture(folder / "a.jpg");
  ASSERT_EQ(read.wide, picture.wide);
  ASSERT_EQ(read.high, picture.high);
  double off = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); ++i)
    off += std::abs(static_cast<double>(read.rgb[i]) - picture.rgb[i]);
  EXPECT_LT(off / static_cast<double>(picture.rgb.size()), 3) << "levels of 255";
  EXPECT_LT(bytes.size(), picture.rgb.size() / 5);
}

TEST(JpegOf, IsTheSameBytesAgainAndLargerWhereItIsBetter) {
  const twin::Picture picture = slopes();
  EXPECT_EQ(api::jpeg_of(picture), api::jpeg_of(picture));
  EXPECT_GT(api::jpeg_of(picture, 98).size(), api::jpeg_of(picture, 40).size());
  EXPECT_THROW((void)api::jpeg_of({2, 2, {1, 2, 3}, 1}), ContractViolation);
}

}  // namespace
}  // namespace slackwater::tests::jpeg_test
