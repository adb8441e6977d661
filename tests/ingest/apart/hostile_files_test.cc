// Files that crash the library that reads them, unpack to more than there is room for, or keep
// their reader waiting: each is one refusal that names it, and this process lives on.
#include <gtest/gtest.h>
#include <netcdf.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>

#include "fields/base/error.h"
#include "ingest/apart/decode_apart.h"
#include "ingest/apart/read_apart.h"
#include "ingest/apart/read_tracks_apart.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/support/contains.h"
#include "tests/support/error_of.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::hostile_files_test {
namespace {

using namespace ingest;
using std::chrono::seconds;

struct HostileFiles : testing::Test {
  HostileFiles() { std::filesystem::create_directory(staging); }
  [[nodiscard]] std::string refusal(const std::filesystem::path& file) const {
    return error_of(
        [&] { return decode_apart(file, products, {}, staging, {}, {}).granules.size(); });
  }
  const TemporaryFolder folder;
  const std::filesystem::path staging = folder / "staging";
  const ProductCatalogue products =
      ProductCatalogue::load(source_folder() / "data" / "products", {});
};

TEST_F(HostileFiles, EndTheirReaderAlone) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "tests" / "fuzz" /
                                                               "corpus" / "apart")) {
    const std::string message = refusal(entry.path());
    EXPECT_TRUE(contains(message, entry.path().filename().string())) << message;
    EXPECT_TRUE(contains(message, "damaged")) << message;
    EXPECT_TRUE(std::filesystem::is_empty(staging)) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 1U);
}

TEST_F(HostileFiles, KeepNobodyWaiting) {
  ASSERT_EQ(::mkfifo((folder / "pipe.nc").c_str(), 0600), 0);
  EXPECT_TRUE(contains(refusal(folder / "pipe.nc"), "found a pipe or a device"));
  EXPECT_TRUE(contains(refusal("/dev/zero"), "found a pipe or a device"));
  EXPECT_TRUE(contains(error_of([&] { return read_tracks_apart(folder / "pipe.nc"); }),
                       "found a pipe or a device"));
}

/// A file of zeros in one chunk each time: a thousandth of them, packed.
std::filesystem::path bomb(const std::filesystem::path& file, std::size_t chunks,
                           std::size_t chunk_values) {
  int nc = 0, time = 0, place = 0, variable = 0;
  EXPECT_EQ(nc_create(file.c_str(), NC_NETCDF4, &nc), NC_NOERR);
  nc_def_dim(nc, "time", chunks, &time);
  nc_def_dim(nc, "place", chunk_values, &place);
  const std::array dims{time, place};
  nc_def_var(nc, "uo", NC_FLOAT, 2, dims.data(), &variable);
  const std::array<std::size_t, 2> chunk{1, chunk_values};
  nc_def_var_chunking(nc, variable, NC_CHUNKED, chunk.data());
  nc_def_var_deflate(nc, variable, 0, 1, 9);
  nc_enddef(nc);
  const std::vector<float> zeros(chunk_values, 0.0F);
  for (std::size_t i = 0; i < chunks; ++i) {
    const std::array<std::size_t, 2> start{i, 0}, count{1, chunk_values};
    EXPECT_EQ(nc_put_vara_float(nc, variable, start.data(), count.data(), zeros.data()), NC_NOERR);
  }
  EXPECT_EQ(nc_close(nc), NC_NOERR);
  return file;
}

/// Reads all of it, as long as it may.
std::string read_all(const std::filesystem::path& file, std::uint64_t memory_bytes,
                     seconds processor) {
  Allowance allowance = allowance_for(file);
  allowance.memory_bytes = memory_bytes;
  allowance.processor = processor;
  return error_of([&] {
    return read_apart(file, allowance, [&](const TellShare&) {
      int nc = 0;
      std::size_t times = 0, places = 0;
      if (nc_open(file.c_str(), NC_NOWRITE, &nc) != NC_NOERR) return std::string("not opened");
      nc_inq_dimlen(nc, 0, &times);
      nc_inq_dimlen(nc, 1, &places);
      std::vector<float> values(places);
      while (true) {
        for (std::size_t i = 0; i < times; ++i) {
          const std::array<std::size_t, 2> start{i, 0}, count{1, places};
          nc_get_vara_float(nc, 0, start.data(), count.data(), values.data());
        }
      }
    });
  });
}

TEST_F(HostileFiles, UnpackToNoMoreThanThereIsRoomFor) {
  const auto file = bomb(folder / "bomb.nc", 1, 60'000'000);
  EXPECT_LT(std::filesystem::file_size(file), 1'000'000U);
  // A process of the tests has half a gigabyte of addresses before it begins.
  const std::string message = read_all(file, std::uint64_t{600} << 20U, seconds(60));
  EXPECT_TRUE(contains(message, "memory: the file is damaged")) << message;
}

TEST_F(HostileFiles, KeepTheirReaderForNoLongerThanItMay) {
  const auto file = bomb(folder / "bomb.nc", 100, 10'000);
  const std::string message = read_all(file, std::uint64_t{4} << 30U, seconds(1));
  EXPECT_TRUE(contains(message, "took the NetCDF library more than 1 s")) << message;
}

TEST_F(HostileFiles, AreNamedByTheirSignal) {
  std::ofstream(folder / "file.nc") << "CDF\1";
  const std::string message = error_of([&] {
    return read_apart(folder / "file.nc", allowance_for(folder / "file.nc"),
                      [](const TellShare&) -> std::string {
                        std::signal(SIGSEGV, SIG_DFL);
                        ::raise(SIGSEGV);
                        return {};
                      });
  });
  EXPECT_TRUE(contains(message, "file.nc crashed the NetCDF library (signal 11)")) << message;
}

}  // namespace
}  // namespace slackwater::tests::hostile_files_test
