#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/lsan_interface.h>
#endif

#include <array>

#include "ingest/grib/message_file.h"
#include "tests/ingest/grib/grib_fixture.h"
#include "tests/support/shared_data.h"

namespace slackwater::ingest::tests::grib_damage_test {
namespace {

class DamagedGrib : public GribTest {
 protected:
  void SetUp() override {
    write_grib(file, std::array{wind_field("10u", run, 3), wind_field("10v", run, 3)}, 2, false);
  }
};

TEST_F(DamagedGrib, EveryTruncationIsRefused) {
  const std::vector<char> whole = contents();
  const std::size_t one_message = whole.size() / 2;  // both messages have one length
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    write_contents({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
    const std::string why = refusal();
    EXPECT_NE(why, "nothing was refused") << length;
    if (length > 16 && length != one_message) {
      EXPECT_TRUE(why.find("truncated") != std::string::npos ||
                  why.find("cut off") != std::string::npos)
          << why;
    }
  }
}

TEST_F(DamagedGrib, AMissingComponentIsNamed) {
  write_grib(file, std::array{wind_field("10u", run, 3)}, 2, false);
  const std::string why = refusal();
  EXPECT_NE(why.find("10u at 10 m of 2024-02-28T15:00:00Z"), std::string::npos) << why;
  EXPECT_NE(why.find("no partner"), std::string::npos) << why;
}

TEST_F(DamagedGrib, BytesBehindTheLastMessageAreRefusedButZeroPaddingIsNot) {
  std::vector<char> bytes = contents();
  const std::size_t end = bytes.size();
  bytes.insert(bytes.end(), 1000, '\0');
  write_contents(bytes);
  EXPECT_EQ(decode().granules.size(), 1U);
  bytes.resize(end);
  for (const char c : std::string("<html>error 502</html>")) bytes.push_back(c);
  write_contents(bytes);
  const std::string why = refusal();
  EXPECT_NE(why.find("22 bytes from byte " + std::to_string(end)), std::string::npos) << why;
}

TEST_F(DamagedGrib, HeadingsOfBulletinsAroundTheMessagesArePassedOver) {
  const std::vector<char> whole = contents();
  const auto message = [&](std::size_t n) {
    const auto half = static_cast<std::ptrdiff_t>(whole.size() / 2);
    return std::string(whole.begin() + (n == 0 ? 0 : half),
                       n == 0 ? whole.begin() + half : whole.end());
  };
  const auto write = [&](const std::string& text) {
    write_contents(std::vector<char>(text.begin(), text.end()));
  };
  const std::string gts = "\x01\r\r\n123\r\r\nHUXA99 EGRR 080000\r\r\n";
  const std::string ncep = "****0000696252****\nYKAZ88 KWBN 060448\r\r\n";
  for (const std::string& heading : {gts, ncep}) {
    write(heading + message(0) + "\r\r\n\x03" + heading + message(1) + "\r\r\n\x03");
    EXPECT_TRUE(is_grib(file));
    const Ingested ingested = decode();
    ASSERT_EQ(ingested.granules.size(), 1U);
    EXPECT_EQ(ingested.granules[0].granule.variables.size(), 2U);
    EXPECT_NE(ingested.warnings.at(0).find("bulletin headings"), std::string::npos);
  }
  write(message(0) + "HTTP/1.1 200 ok" + message(1));
  EXPECT_NE(refusal().find("('HTTP/1.1 200 ok"), std::string::npos) << refusal();
  write("error: " + message(0) + message(1));
  EXPECT_TRUE(is_grib(file)) << "so that the GRIB reader names the bytes";
  EXPECT_NE(refusal().find("from byte 0 on ('error: "), std::string::npos) << refusal();
  // A message whose head is damaged is no heading: it would be lost in silence.
  std::string damaged = message(1);
  damaged.replace(0, 4, "XXXX");
  write(gts + message(0) + damaged);
  EXPECT_NE(refusal(), "nothing was refused");
  write(gts + message(0) + "\r\r\nGRI");
  EXPECT_NE(refusal(), "nothing was refused");
}

TEST_F(DamagedGrib, TheCaseFilesBehindHeadingsAreReadAndBytesBehindAreNamed) {
  SLACKWATER_NEEDS_SHARED(shared);
  const std::filesystem::path cases = shared / "data" / "cases" / "wmo_headers";
  if (!std::filesystem::is_directory(cases)) GTEST_SKIP() << "no case files in " << cases;
  for (const char* name : {"gts.grib2", "wmo.grib2"}) {
    file = cases / name;
    EXPECT_TRUE(is_grib(file));
    EXPECT_FALSE(decode().granules.empty()) << name;
  }
  file = cases / "trailing.grib2";
  EXPECT_NE(refusal().find("('<!-- proxy -->.')"), std::string::npos) << refusal();
}

TEST_F(DamagedGrib, AFieldThatIsThereTwiceIsRefused) {
  write_grib(
      file,
      std::array{wind_field("10u", run, 3), wind_field("10v", run, 3), wind_field("10u", run, 3)},
      2, false);
  const std::string why = refusal();
  EXPECT_NE(why.find("is there twice"), std::string::npos) << why;
  EXPECT_NE(why.find("message 3"), std::string::npos) << why;
}

TEST_F(DamagedGrib, AFileWithoutWindSaysWhatItHolds) {
  write_bent(2, [](grib::Message&) {}, {"2t"});
  const std::string why = refusal();
  EXPECT_NE(why.find("found 2t"), std::string::npos) << why;
  EXPECT_NE(why.find("10u, 10v"), std::string::npos) << why;
}

TEST_F(DamagedGrib, AFieldWithoutAnyValueIsRefused) {
  auto u = wind_field("10u", run, 3);
  for (double& value : u.values) value = std::nan("");
  write_grib(file, std::array{u, wind_field("10v", run, 3)}, 2, false);
  EXPECT_NE(refusal().find("no value at all"), std::string::npos);
}

TEST_F(DamagedGrib, OtherFilesAreNotGrib) {
  EXPECT_FALSE(is_grib(folder / "absent"));
  write_contents({'C', 'D', 'F', '\1'});
  EXPECT_FALSE(is_grib(file));
  write_contents({'G', 'R'});
  EXPECT_FALSE(is_grib(file));
}

TEST_F(DamagedGrib, NoSingleFlippedByteCrashesTheReader) {
#if defined(__SANITIZE_ADDRESS__)
  // ecCodes 2.28 itself loses a few accessors where a template number makes no sense; our leaks
  // show elsewhere.
  const __lsan::ScopedDisabler library_leaks;
#endif
  const std::vector<char> whole = contents();
  std::size_t refused = 0;
  for (std::size_t i = 0; i < whole.size() / 2; ++i) {
    std::vector<char> bytes = whole;
    bytes[i] = static_cast<char>(~bytes[i]);
    write_contents(bytes);
    try {
      static_cast<void>(decode());
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100U);  // the headers; a flipped bit of a packed value cannot show
}

TEST_F(DamagedGrib, SeveralFieldsInOneMessageAreSplit) {
  // Both components in one message, as NCEP writes them: section 4 to 7 of v repeated behind those
  // of u.
  const std::vector<char> whole = contents();
  const std::size_t length = whole.size() / 2;
  const auto section = [&](std::size_t message, int wanted) {
    std::size_t at = message * length + 16;
    for (;;) {
      std::size_t size = 0;
      for (std::size_t i = 0; i < 4; ++i)
        size = size * 256 + static_cast<unsigned char>(whole[at + i]);
      if (whole[at + 4] == wanted) return at;
      at += size;
    }
  };
  std::vector<char> joined(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length - 4));
  joined.insert(joined.end(), whole.begin() + static_cast<std::ptrdiff_t>(section(1, 4)),
                whole.end());
  for (std::size_t i = 0; i < 8; ++i)
    joined[15 - i] = static_cast<char>((joined.size() >> (8 * i)) & 0xFFU);
  write_contents(joined);
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 1U);
  EXPECT_NEAR(read(ingested.granules[0], "eastward_wind").values[0], wind_at(54, 5, 3, true),
              packing_m_s);
  EXPECT_NEAR(read(ingested.granules[0], "northward_wind").values[0], wind_at(54, 5, 3, false),
              packing_m_s);
}

}  // namespace
}  // namespace slackwater::ingest::tests::grib_damage_test
