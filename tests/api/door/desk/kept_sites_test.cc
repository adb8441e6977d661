#include "api/door/desk/kept_sites.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::kept_sites_test {
namespace {

using api::desk::KeptSites;

class KeptSitesOfTheDesk : public testing::Test {
 protected:
  KeptSitesOfTheDesk() { std::filesystem::create_directories(folder_ / "sites"); }
  [[nodiscard]] std::filesystem::path file(const std::string& id) const {
    return folder_ / "sites" / (id + ".yaml");
  }
  void write(const std::string& id, const std::string& latitude_deg) const {
    std::ofstream(file(id)) << "id: " << id << "\nlatitude_deg: " << latitude_deg
                            << "\nlongitude_deg: 6.5\n";
  }
  TemporaryFolder folder_;
};

TEST_F(KeptSitesOfTheDesk, WhatWasReadIsNotParsedAgain) {
  write("mine", "54.1");
  KeptSites kept(folder_.path());
  const auto first = kept.site("mine");
  EXPECT_EQ(kept.site("mine"), first) << "the very same value";
}

TEST_F(KeptSitesOfTheDesk, AnEditShowsAtOnceEvenWithTheSameTimeAndSize) {
  write("mine", "54.1");
  const auto written = std::filesystem::last_write_time(file("mine"));
  KeptSites kept(folder_.path());
  const auto before = kept.site("mine");
  write("mine", "55.1");
  std::filesystem::last_write_time(file("mine"), written);
  EXPECT_NEAR(kept.site("mine")->point.latitude_deg(), 55.1, 1e-12);
  EXPECT_NEAR(before->point.latitude_deg(), 54.1, 1e-12) << "who holds it, holds what was";
}

TEST_F(KeptSitesOfTheDesk, WhatCannotBeReadIsRefusedAndMendedAtOnce) {
  write("mine", "54.1");
  KeptSites kept(folder_.path());
  static_cast<void>(kept.site("mine"));
  write("mine", "154.1");
  for (int i = 0; i < 2; ++i)
    EXPECT_TRUE(contains(error_of([&] { (void)kept.site("mine"); }), "154.1"));
  write("mine", "54.1");
  EXPECT_NEAR(kept.site("mine")->point.latitude_deg(), 54.1, 1e-12);
  std::filesystem::remove(file("mine"));
  EXPECT_TRUE(contains(error_of([&] { (void)kept.site("mine"); }), "found no site 'mine'"));
  EXPECT_THROW((void)kept.site("../mine"), Error);
}

TEST_F(KeptSitesOfTheDesk, IsBoundedInBytes) {
  KeptSites kept(folder_.path(), 1000);
  for (int i = 0; i < 100; ++i) {
    const std::string id = "site" + std::to_string(i);
    write(id, "54.1");
    EXPECT_EQ(kept.site(id)->id, id);
    EXPECT_LE(kept.kept_bytes(), 1000U);
  }
  EXPECT_GT(kept.kept_bytes(), 0U);
  std::ofstream(file("site1"), std::ios::app) << "# " << std::string(2000, 'x') << "\n";
  EXPECT_EQ(kept.site("site1")->id, "site1") << "one that is too long is answered, and not kept";
  EXPECT_LE(kept.kept_bytes(), 1000U);
}

}  // namespace
}  // namespace slackwater::tests::kept_sites_test
