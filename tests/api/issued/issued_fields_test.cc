// What a service has at hand of a store that others write, prune, damage and replace.
#include "api/issued/issued_fields.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "fields/base/error.h"
#include "tests/api/issued/issued_store.h"

namespace slackwater::api::issued_fields_test {
namespace {

using std::chrono::milliseconds;
using tests::IssuedStore;

constexpr auto never = std::chrono::hours(24);

/// The central current of a field at its first column, surface and time: the mark of
/// `IssuedStore::small`.
double mark_of(const Field& field) {
  const GeoPoint& p = field.snapshot().columns.front().point;
  const Place place{p.longitude_deg(), p.latitude_deg(), 0, field.range().from};
  const CurrentSample sample = field.current(place);
  return has_value(sample.status) ? sample.velocity_m_s.real() : -99;
}

double mark_in_force(const IssuedFields& fields, std::size_t site = 0) {
  const auto now = fields.catalogue();
  return site < now->sites.size() ? mark_of(*now->sites[site].field) : -99;
}

template <typename Claim>
bool within(milliseconds time, Claim claim) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (!claim()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(milliseconds(2));
  }
  return true;
}

void damage(const std::filesystem::path& file) {
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  std::ofstream(file, std::ios::binary | std::ios::trunc) << "no NetCDF";
}

/// The error of a call that must fail.
template <typename Call>
Error error_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorKind::internal, "nothing was thrown");
}

TEST(IssuedFields, AForecastThatAnotherIssuesIsInForceWithinThePollInterval) {
  IssuedStore store;
  IssuedFields fields(store.path(), milliseconds(50));
  EXPECT_TRUE(fields.catalogue()->sites.empty()) << "an empty store is served, and has nothing";
  EXPECT_EQ(fields.trouble(), "");
  for (int day = 0; day < 3; ++day) {
    store.issue(IssuedStore::small("a", day, 0.1 * (day + 1)));
    // A hundred intervals, for a machine that does other things beside.
    EXPECT_TRUE(within(milliseconds(5000), [&] {
      return std::abs(mark_in_force(fields) - 0.1 * (day + 1)) < 1e-6;
    })) << day;
  }
  EXPECT_EQ(fields.catalogue()->instances.size(), 3U);
}

TEST(IssuedFields, ReadersSeeWholeCataloguesThroughTwoHundredSwaps) {
  IssuedStore store;
  for (const char* site : {"a", "b"}) store.issue(IssuedStore::small(site, 0, 0.5));
  IssuedFields fields(store.path(), never);
  std::atomic<bool> done{false};
  std::atomic<int> faults{0};
  std::atomic<long> reads{0};
  std::vector<std::thread> readers;
  for (int r = 0; r < 3; ++r) {
    readers.emplace_back([&] {
      std::size_t last = 0;
      while (!done.load()) {
        const auto now = fields.catalogue();
        if (now->instances.size() < last || now->sites.size() != 2) ++faults;
        last = now->instances.size();
        for (const auto& site : now->sites) {
          const IssuedForecast* forecast = now->find(site.instance);
          const bool fits = forecast != nullptr && forecast->row.site_id == site.site_id &&
                            forecast->row.issued == site.field->snapshot().issued &&
                            site.field->snapshot().site_id == site.site_id;
          faults += fits && mark_of(*site.field) == 0.5 ? 0 : 1;
        }
        ++reads;
        std::this_thread::sleep_for(milliseconds(1));
      }
    });
  }
  for (int swap = 1; swap <= 200; ++swap) {
    store.issue(IssuedStore::small(swap % 2 == 0 ? "a" : "b", swap, 0.5));
    fields.refresh();
    EXPECT_EQ(fields.catalogue()->instances.size(), 2U + static_cast<std::size_t>(swap));
  }
  EXPECT_TRUE(within(std::chrono::seconds(20), [&] { return reads.load() > 200; }));
  done = true;
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(faults.load(), 0) << "of " << reads.load() << " reads";
}

TEST(IssuedFields, AnInstanceThatWasPrunedIsNotFoundAndSaysSo) {
  IssuedStore store;
  for (int day = 0; day < 3; ++day) store.issue(IssuedStore::small("a", day, 0.1));
  IssuedFields fields(store.path(), never);
  const std::string oldest = fields.catalogue()->instances.back().instance;
  store.prune_issued_before(parse_utc("2025-03-10T12:00:00Z"));
  // The catalogue in memory still has it: the file tells.
  const Error error = error_of([&] { static_cast<void>(fields.field(oldest)); });
  EXPECT_EQ(error.kind(), ErrorKind::not_found);
  EXPECT_NE(error.message().find("pruned"), std::string::npos) << error.message();
  EXPECT_EQ(fields.trouble(), "") << "a pruned forecast is no damage";
  EXPECT_EQ(fields.catalogue()->find(oldest), nullptr);
  EXPECT_EQ(error_of([&] { static_cast<void>(fields.field(oldest)); }).kind(),
            ErrorKind::not_found);
  EXPECT_NEAR(mark_in_force(fields), 0.1, 1e-6);
}

TEST(IssuedFields, WhatIsInForceOutlivesItsFileForThoseWhoHoldIt) {
  IssuedStore store;
  store.issue(IssuedStore::small("a", 0, 0.4));
  IssuedFields fields(store.path(), never);
  const auto held = fields.catalogue()->sites.front().field;
  store.prune_issued_before(parse_utc("2025-04-01T00:00:00Z"));
  fields.refresh();
  EXPECT_TRUE(fields.catalogue()->sites.empty());
  EXPECT_NEAR(mark_of(*held), 0.4, 1e-6);
}

TEST(IssuedFields, OlderForecastsAreKeptToAFew) {
  IssuedStore store;
  for (int day = 0; day < 9; ++day) store.issue(IssuedStore::small("a", day, 0.1 * (day + 1)));
  IssuedFields fields(store.path(), never);
  const auto instances = fields.catalogue()->instances;
  std::weak_ptr<const Field> first = fields.field(instances.back().instance);
  EXPECT_FALSE(first.expired()) << "asked for a moment ago";
  for (int turn = 0; turn < 2; ++turn) {
    for (std::size_t i = 0; i + 1 < instances.size(); ++i) {
      const double mark = 0.1 * static_cast<double>(instances.size() - i);
      EXPECT_NEAR(mark_of(*fields.field(instances[i].instance)), mark, 1e-6);
      EXPECT_LE(fields.kept(), 4U);
    }
  }
  EXPECT_TRUE(first.expired()) << "long ago";
}

TEST(IssuedFields, OfTwoIssuedAtOnceTheLaterStoredIsInForceAndNamesStayWithTheirForecasts) {
  IssuedStore store;
  store.issue(IssuedStore::small("a", 0, 0.1));
  IssuedFields fields(store.path(), never);
  const std::string first = fields.catalogue()->sites.front().instance;
  const std::int64_t id = store.issue(IssuedStore::small("a", 0, 0.2));
  fields.refresh();
  EXPECT_NEAR(mark_in_force(fields), 0.2, 1e-6);
  EXPECT_EQ(fields.catalogue()->sites.front().instance, first + "-" + std::to_string(id));
  EXPECT_NEAR(mark_of(*fields.field(first)), 0.1, 1e-6)
      << "a forecast as issued is never overwritten, nor is its name";
  EXPECT_NEAR(mark_of(*fields.field(first + "-" + std::to_string(id))), 0.2, 1e-6);
}

TEST(IssuedFields, AHindcastIsInForceOnlyWhereNothingWasIssued) {
  IssuedStore store;
  store.issue(IssuedStore::small("a", 5, 0.1), ForecastOrigin::hindcast);
  store.issue(IssuedStore::small("b", 1, 0.2), ForecastOrigin::forecast);
  store.issue(IssuedStore::small("b", 5, 0.3), ForecastOrigin::hindcast);
  store.issue(IssuedStore::small("a", 7, 0.4), ForecastOrigin::hindcast);
  IssuedFields fields(store.path(), never);
  ASSERT_EQ(fields.catalogue()->sites.size(), 2U);
  EXPECT_NEAR(mark_in_force(fields, 0), 0.4, 1e-6);
  EXPECT_NEAR(mark_in_force(fields, 1), 0.2, 1e-6);
}

TEST(IssuedFields, ADamagedForecastInForceGivesWayToTheOneBeforeAndHarmsNoOtherSite) {
  IssuedStore store;
  store.issue(IssuedStore::small("a", 0, 0.1));
  store.issue(IssuedStore::small("b", 0, 0.2));
  IssuedFields fields(store.path(), never);
  const std::int64_t id = store.issue(IssuedStore::small("a", 1, 0.3));
  store.issue(IssuedStore::small("b", 1, 0.4));
  const std::filesystem::path file = store.file_of(id);
  const std::filesystem::path copy = store.beside("copy.nc");
  std::filesystem::copy_file(file, copy);
  damage(file);
  for (int turn = 0; turn < 3; ++turn) {
    fields.refresh();
    EXPECT_NEAR(mark_in_force(fields, 0), 0.1, 1e-6) << "the newest that can be read";
    EXPECT_NEAR(mark_in_force(fields, 1), 0.4, 1e-6);
    EXPECT_NE(fields.trouble().find("a_20250311T050000Z"), std::string::npos) << fields.trouble();
    EXPECT_EQ(fields.trouble().find(store.path().string()), std::string::npos) << "no paths";
  }
  std::filesystem::copy_file(copy, file, std::filesystem::copy_options::overwrite_existing);
  fields.refresh();
  EXPECT_NEAR(mark_in_force(fields, 0), 0.3, 1e-6) << "mended";
  EXPECT_EQ(fields.trouble(), "");
}

TEST(IssuedFields, ADamagedForecastAtTheStartLeavesTheOtherSitesServed) {
  IssuedStore store;
  damage(store.file_of(store.issue(IssuedStore::small("a", 0, 0.1))));
  store.issue(IssuedStore::small("b", 0, 0.2));
  IssuedFields fields(store.path(), never);
  ASSERT_EQ(fields.catalogue()->sites.size(), 1U);
  EXPECT_EQ(fields.catalogue()->sites.front().site_id, "b");
  EXPECT_NE(fields.trouble(), "");
}

TEST(IssuedFields, ADamagedOlderForecastIsUnavailableWithoutPathsAndDegradesUntilItIsMended) {
  IssuedStore store;
  const std::int64_t id = store.issue(IssuedStore::small("a", 0, 0.1));
  store.issue(IssuedStore::small("a", 1, 0.2));
  const std::filesystem::path copy = store.beside("copy.nc");
  std::filesystem::copy_file(store.file_of(id), copy);
  damage(store.file_of(id));
  IssuedFields fields(store.path(), never);
  EXPECT_EQ(fields.trouble(), "") << "nobody has asked for it";
  const std::string name = fields.catalogue()->instances.back().instance;
  const Error error = error_of([&] { static_cast<void>(fields.field(name)); });
  EXPECT_EQ(error.kind(), ErrorKind::unavailable) << "not the client's fault";
  EXPECT_EQ(error.message().find('/' + std::string("files")), std::string::npos);
  EXPECT_EQ(error.message().find(store.path().string()), std::string::npos) << error.message();
  EXPECT_NE(fields.trouble(), "");
  EXPECT_TRUE(fields.is_following()) << "one damaged forecast is no reason to turn clients away";
  std::filesystem::copy_file(copy, store.file_of(id),
                             std::filesystem::copy_options::overwrite_existing);
  fields.refresh();
  EXPECT_EQ(fields.trouble(), "") << "without anybody asking again";
  EXPECT_NEAR(mark_of(*fields.field(name)), 0.1, 1e-6);
}

TEST(IssuedFields, AStoreThatVanishesIsTroubleAndItsForecastsStayUntilItIsBack) {
  IssuedStore store;
  store.issue(IssuedStore::small("a", 0, 0.1));
  IssuedFields fields(store.path(), never);
  const std::filesystem::path elsewhere = store.beside("elsewhere");
  store.move_to(elsewhere);
  fields.refresh();
  EXPECT_NE(fields.trouble(), "");
  EXPECT_EQ(fields.trouble().find(store.path().string()), std::string::npos) << fields.trouble();
  EXPECT_NEAR(mark_in_force(fields), 0.1, 1e-6);
  EXPECT_FALSE(fields.is_following());
  std::filesystem::rename(elsewhere, store.path());
  fields.refresh();
  EXPECT_EQ(fields.trouble(), "");
  EXPECT_TRUE(fields.is_following());
}

TEST(IssuedFields, AStoreThatIsReplacedByAnotherIsFollowed) {
  IssuedStore store;
  store.issue(IssuedStore::small("a", 0, 0.1));
  IssuedFields fields(store.path(), never);
  store.move_to(store.beside("old"));
  store.issue(IssuedStore::small("c", 2, 0.7));  // into a new store at the old place
  fields.refresh();
  ASSERT_EQ(fields.catalogue()->sites.size(), 1U);
  EXPECT_EQ(fields.catalogue()->sites.front().site_id, "c");
  EXPECT_NEAR(mark_in_force(fields), 0.7, 1e-6);
}

TEST(IssuedFields, ReadingOnAnyThreadPrintsNothing) {
  IssuedStore store;
  store.issue(IssuedStore::small("a", 0, 0.1));
  store.issue(IssuedStore::small("a", 1, 0.1));
  IssuedFields fields(store.path(), never);
  testing::internal::CaptureStderr();
  std::thread([&] {
    EXPECT_NEAR(mark_of(*fields.field(fields.catalogue()->instances.back().instance)), 0.1, 1e-6);
  }).join();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "HDF5 silences the first thread alone";
}

TEST(IssuedFields, AFolderWithoutAStoreIsRefusedAtOnce) {
  const tests::TemporaryFolder folder;
  EXPECT_EQ(error_of([&] { const IssuedFields fields(folder / "nothing", never); }).kind(),
            ErrorKind::not_found);
}

}  // namespace
}  // namespace slackwater::api::issued_fields_test
