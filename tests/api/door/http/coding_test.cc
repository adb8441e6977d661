#include <gtest/gtest.h>

#include "api/door/http/content_coding.h"
#include "api/door/http/entity_tag.h"
#include "api/door/http/response_head.h"

namespace slackwater::tests::coding_test {
namespace {

using namespace slackwater::api::http;

TEST(AcceptEncoding, QValuesAreHonoured) {
  for (const char* yes : {"gzip", "GZIP", "gzip, deflate, br", "br;q=1.0, gzip;q=0.2", "*",
                          "deflate, *;q=0.5", "gzip;q=0.5, identity;q=0.5", "x-gzip"}) {
    EXPECT_TRUE(prefers_gzip(yes)) << yes;
  }
  for (const char* no :
       {"", "identity", "br", "gzip;q=0", "gzip;q=0.0, *", "*;q=0", ",,;",
        "gzip;q=0.5, identity;q=0.6", "gzip;q=nan", "gzip;q=2", "gzip;q=", "not-gzip"}) {
    EXPECT_FALSE(prefers_gzip(no)) << no;
  }
}

TEST(ContentCoding, IsForTextThatIsLong) {
  EXPECT_TRUE(is_worth_coding("application/prs.coverage+json", 1024));
  EXPECT_TRUE(is_worth_coding("text/csv; charset=utf-8", 5000));
  EXPECT_TRUE(is_worth_coding("application/vnd.oai.openapi+json;version=3.0", 5000));
  EXPECT_FALSE(is_worth_coding("application/json", 1023));
  EXPECT_FALSE(is_worth_coding("application/netcdf", 1'000'000));
}

TEST(EntityTag, NamesTheBytes) {
  // SHA-256 of the empty string, FIPS 180-4 example files.
  EXPECT_EQ(entity_tag(""), "\"e3b0c44298fc1c149afbf4c8996fb924\"");
  EXPECT_EQ(coded_tag(entity_tag(""), "gzip"), "\"e3b0c44298fc1c149afbf4c8996fb924-gzip\"");
  EXPECT_NE(entity_tag("a"), entity_tag("b"));
}

TEST(EntityTag, ListsWeakTagsAndStarsMatch) {
  EXPECT_TRUE(matches_tag("\"a\"", "\"a\""));
  EXPECT_TRUE(matches_tag("\"b\" , W/\"a\"", "\"a\""));
  EXPECT_TRUE(matches_tag("*", "\"a\""));
  for (const char* no : {"", "a", "\"b\"", "\"a-gzip\"", ",", "W/"}) {
    EXPECT_FALSE(matches_tag(no, "\"a\"")) << no;
  }
}

TEST(ResponseHead, DatesAreThoseOfRfc9110) {
  EXPECT_EQ(http_date(784111777), "Sun, 06 Nov 1994 08:49:37 GMT");  // its own example
}

}  // namespace
}  // namespace slackwater::tests::coding_test
