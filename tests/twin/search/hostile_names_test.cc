// What a user writes where a name is expected is a name and nothing else, whatever signs are in it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/error_of.h"
#include "tests/support/shared_data.h"
#include "twin/mission/limit.h"
#include "twin/search/mammal_duty.h"
#include "twin/search/person_search.h"

namespace slackwater::tests::hostile_names_test {
namespace {

/// Each is a name with its end made into syntax of a text in which it would stand unquoted.
const std::vector<std::string> ends{", lookout: usv_camera, object: person_upright",
                                    ", watch: observer",
                                    ": 1",
                                    " # not the rest",
                                    "\"",
                                    "'",
                                    "\nobject: person_upright",
                                    "}",
                                    "]"};

TEST(PersonSearch, TakesANameForNothingButAName) {
  for (const std::string& end : ends) {
    twin::PersonSearch search;
    search.object = "person_upright" + end;
    search.lookout = "usv_camera";
    EXPECT_NE(error_of([&] {
                return load(search, source_folder() / "data"), 0;
              }).find("search: object: found " + search.object + ", expected one of"),
              std::string::npos)
        << end;
    search.object = "person_upright";
    search.lookout = "usv_camera" + end;
    EXPECT_NE(error_of([&] {
                return load(search, source_folder() / "data"), 0;
              }).find("search: lookout: found " + search.lookout + ", expected one of"),
              std::string::npos)
        << end;
  }
}

TEST(MammalDuty, TakesANameForNothingButAName) {
  for (const std::string& end : ends) {
    twin::MammalDuty duty;
    duty.animal = "harbour_porpoise" + end;
    duty.watch = "observer";
    EXPECT_NE(error_of([&] {
                return load(duty, source_folder() / "data"), 0;
              }).find("mammals: animal: found " + duty.animal + ", expected one of"),
              std::string::npos)
        << end;
    duty.animal = "harbour_porpoise";
    duty.watch = "observer" + end;
    EXPECT_NE(error_of([&] {
                return load(duty, source_folder() / "data"), 0;
              }).find("mammals: watch: found " + duty.watch + ", expected one of"),
              std::string::npos)
        << end;
  }
}

TEST(Assumption, IsOneNameAndOneNumber) {
  for (const char* text : {"visibility_m=5000", "visibility_m = 5000", " visibility_m=+5000 "})
    EXPECT_EQ(twin::parse_assumption(text).value, 5000) << text;
  for (const std::string& end : ends)
    EXPECT_NE(error_of([&] {
                return twin::parse_assumption("visibility_m=5000" + end);
              }).find("found visibility_m=5000" + end + ", expected a number from 1 to 100000 m"),
              std::string::npos)
        << end;
  EXPECT_NE(error_of([] {
              return twin::parse_assumption("{visibility_m: 1}#=5000");
            }).find("cannot be assumed"),
            std::string::npos);
  EXPECT_NE(error_of([] { return twin::parse_assumption("visibility_m=1,5"); }).find("write 1.5"),
            std::string::npos);
  EXPECT_NE(error_of([] { return twin::parse_assumption("visibility_m"); }).find("NAME=NUMBER"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::hostile_names_test
