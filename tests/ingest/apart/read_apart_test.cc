// What is read in a process of its own is what is read here, to the last bit.
#include "ingest/apart/read_apart.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "fields/base/error.h"
#include "ingest/apart/decode_apart.h"
#include "ingest/apart/packed.h"
#include "ingest/apart/read_forecast_apart.h"
#include "ingest/apart/read_tracks_apart.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/support/error_of.h"
#include "tests/support/made_up_forecast.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::read_apart_test {
namespace {

using namespace ingest;
namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A member that did not come over would be missing in the file that is written of it.
TEST(ReadApart, AForecastIsTheSame) {
  const TemporaryFolder folder;
  Snapshot forecast = made_up_forecast({2, 3, 5, 4, 1});
  add_made_up_level(forecast);
  write_forecast(folder / "forecast.nc", forecast);
  write_forecast(folder / "here.nc", read_forecast(folder / "forecast.nc"));
  write_forecast(folder / "apart.nc", read_forecast_apart(folder / "forecast.nc"));
  EXPECT_EQ(bytes_of(folder / "apart.nc"), bytes_of(folder / "here.nc"));
}

TEST(ReadApart, ALogIsTheSame) {
  const TemporaryFolder folder;
  TrajectoryFile tracks;
  tracks.names = {"a", "b"};
  tracks.t_s = {0, 0.1, 0.3};
  tracks.variables = {{"x", "", "m", "east", 1, {1, 2, 3, 4, 5, -0.0}},
                      {"thrust", "", "N", "of each", 2, std::vector<double>(12, 1.0 / 3)}};
  tracks.tables = {
      {"alarm", {{"begin", "s", "when", {1, 2}}}, {{"who", "name", {"x", "\xc3\xa4"}}}}};
  tracks.attributes = {{"scenario", "name: a\n"}, {"source", "tests"}};
  write_trajectories(tracks, folder / "log.nc");
  write_trajectories(read_tracks_apart(folder / "log.nc"), folder / "apart.nc");
  EXPECT_EQ(bytes_of(folder / "apart.nc"), bytes_of(folder / "log.nc"));
}

TEST(ReadApart, AProductIsTheSame) {
  const TemporaryFolder folder;
  const auto products = ProductCatalogue::load(source_folder() / "data" / "products", {});
  const fs::path file =
      write_product(folder / "product.nc", current_product(parse_day("2025-03-10")));
  for (const char* const name : {"here", "apart"}) fs::create_directory(folder / name);
  std::vector<double> shares;
  int meanwhile = 0;
  const Ingested here = decode_file(file, products, {}, folder / "here", {});
  const Ingested apart = decode_apart(
      file, products, {}, folder / "apart", [&](double share) { shares.push_back(share); },
      [&] { ++meanwhile; });
  EXPECT_EQ(meanwhile, 1);
  EXPECT_FALSE(shares.empty());
  EXPECT_EQ(apart.warnings, here.warnings);
  EXPECT_EQ(apart.published, here.published);
  ASSERT_EQ(apart.granules.size(), here.granules.size());
  for (std::size_t i = 0; i < here.granules.size(); ++i) {
    const Granule &a = apart.granules[i].granule, &h = here.granules[i].granule;
    EXPECT_EQ(a.grid, h.grid);
    EXPECT_EQ(a.variables, h.variables);
    EXPECT_EQ(a.status, h.status);
    EXPECT_EQ(a.reference_time, h.reference_time);
    EXPECT_EQ(a.product_id, h.product_id);
    EXPECT_EQ(a.dataset_id, h.dataset_id);
    EXPECT_EQ(a.attribution, h.attribution);
    EXPECT_EQ(apart.granules[i].content_file.parent_path(), folder / "apart");
    EXPECT_EQ(bytes_of(apart.granules[i].content_file), bytes_of(here.granules[i].content_file));
  }
}

TEST(ReadApart, ARefusalIsTheSame) {
  const TemporaryFolder folder;
  std::ofstream(folder / "log.nc") << "no log";
  EXPECT_EQ(error_of([&] { return read_tracks_apart(folder / "log.nc"); }),
            error_of([&] { return read_trajectories(folder / "log.nc"); }));
  try {
    static_cast<void>(read_tracks_apart(folder / "nothing.nc"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
  }
}

using Values = std::map<std::string, std::vector<std::optional<double>>>;

TEST(Packed, IsUnpackedWhole) {
  const Values values{{"a", {1.0 / 3, std::nullopt, -0.0}}, {"", {}}};
  EXPECT_EQ(unpacked<Values>(packed(values)), values);
}

// Of a reader that was taken over.
TEST(Packed, OtherBytesAreRefusedBeforeAnythingIsMadeOfThem) {
  const Values values{{"a", {1, 2, std::nullopt}}, {"another", {4}}};
  const std::string bytes = packed(values);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(static_cast<void>(unpacked<Values>(bytes.substr(0, size))), Error) << size;
  EXPECT_THROW(static_cast<void>(unpacked<Values>(bytes + 'x')), Error);
  EXPECT_THROW(static_cast<void>(unpacked<std::vector<double>>(packed(~std::uint64_t{0}))), Error);
  std::mt19937 random(1);
  for (int turn = 0; turn < 2000; ++turn) {
    std::string other = bytes;
    other[random() % other.size()] = static_cast<char>(random());
    try {
      static_cast<void>(unpacked<Values>(other));
    } catch (const std::exception&) {
      continue;  // and ASan sees whatever else there is
    }
  }
}

}  // namespace
}  // namespace slackwater::tests::read_apart_test
