#include "api/door/edr/read/query_string.h"

#include "tests/api/door/edr/refusal.h"

namespace slackwater::api::edr::query_string_test {
namespace {

using tests::contains;
using tests::refusal_of;

TEST(QueryString, DecodesInTheOrderOfTheQuery) {
  const auto query = QueryString::parse("z=0%2F50&coords=POINT(2.45+57%2e25)&f=&flag&&x=a=b%26");
  ASSERT_EQ(query.all().size(), 5U);
  EXPECT_EQ(query.all()[0], (std::pair<std::string, std::string>("z", "0/50")));
  EXPECT_EQ(query.find("coords"), "POINT(2.45 57.25)");
  EXPECT_EQ(query.find("f"), "");
  EXPECT_EQ(query.find("flag"), "");
  EXPECT_EQ(query.find("x"), "a=b&");
  EXPECT_EQ(query.find("datetime"), std::nullopt);
  EXPECT_TRUE(QueryString::parse("").all().empty());
  EXPECT_TRUE(QueryString::parse("&&&").all().empty());
}

TEST(QueryString, ARepeatedKeyIsRefusedHoweverItIsWritten) {
  for (const char* text :
       {"z=1&z=2", "z=1&%7A=1", "z&z", "parameter-name=a&x=1&parameter-name=b"}) {
    EXPECT_TRUE(contains(refusal_of([&] { (void)QueryString::parse(text); }), "given again"))
        << text;
  }
  EXPECT_TRUE(contains(refusal_of([] { (void)QueryString::parse("z=1&z=2"); }), "z: found '2'"));
}

TEST(QueryString, BrokenPercentCodesAreRefused) {
  for (const char* text :
       {"z=%", "z=%2", "z=%2&x=1", "z=%zz", "z=%%20", "z=% 20", "%=1", "z=a%g0"}) {
    EXPECT_TRUE(contains(refusal_of([&] { (void)QueryString::parse(text); }), "hexadecimal"))
        << text;
  }
}

TEST(QueryString, NulBytesAndEmptyKeysAreRefused) {
  EXPECT_TRUE(contains(refusal_of([] { (void)QueryString::parse("z=1%00"); }), "NUL"));
  EXPECT_TRUE(contains(refusal_of([] { (void)QueryString::parse("%00=1"); }), "NUL"));
  EXPECT_TRUE(
      contains(refusal_of([] { (void)QueryString::parse(std::string_view("z=\0", 3)); }), "NUL"));
  EXPECT_TRUE(contains(refusal_of([] { (void)QueryString::parse("=1"); }), "a name before '='"));
}

TEST(QueryString, LimitsAreNamed) {
  const std::string long_query = tests::long_text("z=", max_query_bytes, '1');
  EXPECT_TRUE(contains(refusal_of([&] { (void)QueryString::parse(long_query); }), "262144 bytes"));
  std::string many;
  for (std::size_t i = 0; i <= max_query_parameters; ++i)
    many.append("k").append(std::to_string(i)).append("=1&");
  EXPECT_TRUE(
      contains(refusal_of([&] { (void)QueryString::parse(many); }), "at most 64 parameters"));
  EXPECT_EQ(QueryString::parse(std::string(max_query_bytes, '&')).all().size(), 0U);
}

TEST(QueryString, AMessageShowsNoByteThatCouldHarmATerminal) {
  const auto message = refusal_of([] { (void)QueryString::parse("%1B[2J=1&%1B[2J=\r\n%ff"); });
  EXPECT_TRUE(contains(message, ".[2J: found '...'"));
}

}  // namespace
}  // namespace slackwater::api::edr::query_string_test
