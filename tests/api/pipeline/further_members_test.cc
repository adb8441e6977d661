// More members of a forecast as issued, through a real store of made-up products: what was issued
// stays what it is, and what cannot be made again is refused with its reason.
#include "api/pipeline/further_members.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "api/pipeline/snapshot_difference.h"
#include "fields/base/error.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::api::further_members_test {
namespace {

using namespace std::chrono;
using namespace tests;

constexpr UtcDay first_day = sys_days{2025y / March / 6};
constexpr UtcDay day = sys_days{2025y / March / 9};
constexpr const char* five_o_clock = "2025-03-10T05:00:00Z";
constexpr const char* four_o_clock = "2025-03-10T04:00:00Z";

class FurtherMembers : public ::testing::Test {
 protected:
  void ingest(const std::string& name, const ProductForTests& product,
              const std::string& at = four_o_clock) {
    const auto file = write_product(store_.file(name), product);
    const ProgramResult result = store_.run({"ingest", "--at", at, file.string()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  void issue(const std::vector<std::string>& more = {}, const std::string& at = five_o_clock) {
    std::vector<std::string> arguments{"forecast", "--site",    store_.site(), "--at",
                                       at,         "--horizon", "24h"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult result = store_.run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  void issue_usual() {
    ingest("currents.nc", current_product(first_day, 4 * 24 + 1));
    ProductForTests wind = wind_product(first_day, 4 * 24);
    ingest("wind.nc", wind);
    issue();
  }
  [[nodiscard]] store::Store open() const {
    return store::Store::open(store_.store(), store::OpenMode::read_only);
  }
  [[nodiscard]] Snapshot issued() const {
    store::Store store = open();
    return ingest::read_forecast(store.content_path(store.list_forecasts().back().content_sha256));
  }
  [[nodiscard]] Snapshot with(std::size_t members) const {
    store::Store store = open();
    return with_further_members(store, store.list_forecasts().back(), members);
  }
  /// The message of the error that asking for 37 members ends in.
  [[nodiscard]] std::string refusal(ErrorKind kind) const {
    try {
      static_cast<void>(with(37));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind) << error.what();
      return error.what();
    }
    ADD_FAILURE() << "expected to be refused";
    return {};
  }

  StoreForTests store_;
};

void expect_begins_with(const std::vector<Horizontal>& all, const std::vector<Horizontal>& first) {
  ASSERT_GE(all.size(), first.size());
  EXPECT_TRUE(std::equal(first.begin(), first.end(), all.begin()));
}

TEST_F(FurtherMembers, AddToWhatWasIssuedAndLeaveTheStoreAsItIs) {
  issue_usual();
  const auto before = store_.digests();
  const Snapshot first = issued();
  ASSERT_EQ(first.members, 25u);
  const Snapshot more = with(61);
  EXPECT_EQ(store_.digests(), before) << "the issued file and the catalogue, byte for byte";
  EXPECT_EQ(more.members, 61u);
  EXPECT_EQ(difference_of(first, more), "");
  EXPECT_EQ(more.provenance, first.provenance);
  const ForecastColumn& column = more.columns.at(0);
  const std::size_t size = column.current_m_s.size();
  ASSERT_EQ(column.member_m_s.size(), 60 * size);
  expect_begins_with(column.member_m_s, first.columns[0].member_m_s);
  // They spread as the forecast says: the second set is scaled to sigma by itself.
  for (std::size_t o = 0; o < size; ++o) {
    if (!has_value(column.current_status[o])) continue;
    double squares = 0;
    for (std::size_t m = 24; m < 48; ++m)
      squares += 0.5 * std::norm(column.member_m_s[m * size + o] - column.current_m_s[o]) / 24;
    EXPECT_NEAR(std::sqrt(squares), column.current_sigma_m_s[o], 2 * ingest::member_step_m_s);
  }
  // Fewer of them are the first of more; what the file holds is asked of the file.
  const Snapshot fewer = with(37);
  EXPECT_EQ(fewer.members, 37u);
  expect_begins_with(column.member_m_s, fewer.columns[0].member_m_s);
  expect_begins_with(column.wind_member_m_s, fewer.columns[0].wind_member_m_s);
  EXPECT_EQ(with(7).columns[0].member_m_s, first.columns[0].member_m_s);
}

TEST_F(FurtherMembers, WhatCameInSinceIsNotSeen) {
  issue_usual();
  const Snapshot before = with(37);
  ProductForTests revised = current_product(day, 2 * 24 + 1);
  revised.quantity("uo").value = [](const ProductCell& cell) {
    return WaterForTests::eastward_m_s(cell) + 0.3;
  };
  ingest("revised.nc", revised, "2025-03-11T04:00:00Z");
  ingest("later.nc", wind_product(day + days(1), 48), "2025-03-11T04:00:00Z");
  EXPECT_EQ(with(37).columns[0].member_m_s, before.columns[0].member_m_s);
}

TEST_F(FurtherMembers, AreRefusedWhereTheStoreIsNotWhatItWas) {
  issue_usual();
  // A file that says it was there then, and was not.
  ProductForTests revised = current_product(day, 25);
  revised.quantity("uo").value = [](const ProductCell& cell) {
    return WaterForTests::eastward_m_s(cell) + 0.3;
  };
  ingest("revised.nc", revised, "2025-03-10T04:30:00Z");
  const auto before = store_.digests();
  const std::string why = refusal(ErrorKind::unavailable);
  EXPECT_EQ(store_.digests(), before);
  EXPECT_NE(why.find("holds 25 members and cannot be given 37"), std::string::npos) << why;
  EXPECT_NE(why.find("it uses other product files"), std::string::npos) << why;
  EXPECT_NE(why.find("ask for at most 25 members"), std::string::npos) << why;
  EXPECT_EQ(with(25).members, 25u) << "what was issued is served all the same";
}

TEST_F(FurtherMembers, OfADamagedInputAreRefusedWithItsName) {
  issue_usual();
  store::Store store = open();
  for (const store::GranuleRow& granule : store.find_granules({})) {
    if (granule.standard_names.front() != "eastward_wind") continue;
    const auto file = store.content_path(granule.content_sha256);
    std::string bytes = read_bytes(file);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
    std::filesystem::permissions(file, std::filesystem::perms::owner_write,
                                 std::filesystem::perm_options::add);
    write_bytes(file, bytes);
  }
  EXPECT_NE(refusal(ErrorKind::unavailable).find("it uses other product files"), std::string::npos);
}

TEST_F(FurtherMembers, OfAForecastByAnotherProgramAreRefusedNamingBoth) {
  issue_usual();
  Snapshot other = issued();
  {
    store::Store store = store::Store::open(store_.store(), store::OpenMode::create_or_write);
    store::NewForecast made;
    made.row = store.list_forecasts().back();
    made.row.issued += minutes(5);
    made.row.code_version = "0.0.1-older";
    other.issued = made.row.issued;
    other.columns[0].current_sigma_m_s[0] *= 1.5;  // it reckoned otherwise
    made.content_file = store.staging_folder() / "other.nc";
    ingest::write_forecast(made.content_file, other);
    static_cast<void>(store.commit_forecasts(std::span(&made, 1)));
  }
  const std::string why = refusal(ErrorKind::unavailable);
  EXPECT_NE(why.find("0.0.1-older made it, this is "), std::string::npos) << why;
  EXPECT_NE(why.find("the spread of the current of column 0 differs"), std::string::npos) << why;
}

TEST_F(FurtherMembers, OfAHindcastAreDrawnThoughItsFileHoldsNone) {
  issue_usual();
  const ProgramResult hindcast =
      store_.run({"hindcast", "--site", store_.site(), "--from", "2025-03-09", "--to", "2025-03-09",
                  "--wind", "persist", "--horizon", "24h"});
  ASSERT_EQ(hindcast.exit_code, 0) << hindcast.err;
  store::Store store = open();
  for (const store::ForecastRow& row : store.list_forecasts()) {
    const Snapshot more = with_further_members(store, row, 37);
    EXPECT_EQ(more.members, 37u) << name_of(row.origin);
    EXPECT_EQ(more.columns[0].member_m_s.size(), 36 * more.columns[0].current_m_s.size());
  }
  EXPECT_EQ(store.list_forecasts().size(), 2u);
}

TEST(SnapshotDifference, AnyBitThatMovesIsNamed) {
  Snapshot made;
  made.columns.resize(1);
  ForecastColumn& column = made.columns[0];
  column.current_m_s = {{0.1, 0.2}};
  column.current_sigma_m_s = {0.1};
  column.current_status = {SampleStatus::ok};
  column.sea = {{1.0, std::nan(""), 200}};
  column.member_m_s = {{0.125, 0.25}, {0.5, 0.5}};
  made.members = 3;
  const auto changed = [&](auto change) {
    Snapshot issued = made;
    issued.members = 2;
    issued.columns[0].member_m_s.resize(1);
    change(issued, issued.columns[0]);
    return difference_of(issued, made);
  };
  EXPECT_EQ(changed([](Snapshot&, ForecastColumn&) {}), "") << "more members, and a missing period";
  EXPECT_EQ(changed([](Snapshot& s, ForecastColumn&) { s.provenance.code_version = "x"; }), "");
  const double next = std::nextafter(0.1, 1);
  EXPECT_NE(changed([&](Snapshot&, ForecastColumn& c) { c.current_sigma_m_s[0] = next; }), "");
  EXPECT_NE(changed([&](Snapshot&, ForecastColumn& c) { c.current_m_s[0] = {next, 0.2}; }), "");
  EXPECT_NE(changed([](Snapshot&, ForecastColumn& c) { c.sea[0].peak_period_s = 8; }), "");
  EXPECT_NE(changed([](Snapshot&, ForecastColumn& c) { c.member_m_s[0] = {0.126, 0.25}; }), "");
  EXPECT_NE(changed([](Snapshot& s, ForecastColumn&) { s.headline = "x"; }), "");
  EXPECT_NE(changed([](Snapshot& s, ForecastColumn&) { s.seed = 7; }), "");
  EXPECT_NE(changed([](Snapshot& s, ForecastColumn&) { s.provenance.site = "x"; }), "");
}

}  // namespace
}  // namespace slackwater::api::further_members_test
