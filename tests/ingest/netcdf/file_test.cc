#include "ingest/netcdf/file.h"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <fstream>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::netcdf::file_test {
namespace {

using slackwater::tests::contains;
using slackwater::tests::TemporaryFolder;

std::string refusal(const std::filesystem::path& path) {
  try {
    (void)File::open(path);
  } catch (const Error& error) {
    return std::string(name_of(error.kind())) + ": " + error.message();
  }
  return "nothing was thrown";
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// A classic file with a fixed and two record variables, 100 records.
void write_classic(const std::filesystem::path& path, int format) {
  int file = 0;
  int record = 0;
  int place = 0;
  ASSERT_EQ(nc_create(path.c_str(), NC_CLOBBER | format, &file), NC_NOERR);
  nc_def_dim(file, "time", NC_UNLIMITED, &record);
  nc_def_dim(file, "x", 7, &place);
  const int dimensions[] = {record, place};
  int fixed = 0;
  int series = 0;
  int bytes = 0;
  nc_def_var(file, "fixed", NC_DOUBLE, 1, &place, &fixed);
  nc_def_var(file, "series", NC_FLOAT, 2, dimensions, &series);
  nc_def_var(file, "bytes", NC_BYTE, 2, dimensions, &bytes);
  nc_put_att_text(file, NC_GLOBAL, "title", 5, "hello");
  nc_enddef(file);
  for (std::size_t t = 0; t < 100; ++t) {
    const std::size_t start[] = {t, 0};
    const std::size_t count[] = {1, 7};
    const float values[7] = {1, 2, 3, 4, 5, 6, 7};
    nc_put_vara_float(file, series, start, count, values);
    nc_put_vara_float(file, bytes, start, count, values);
  }
  ASSERT_EQ(nc_close(file), NC_NOERR);
}

TEST(NetcdfFile, WhatIsWrittenIsRead) {
  const TemporaryFolder folder;
  Writer writer = Writer::create(folder / "f.nc");
  const int x = writer.dimension("x", 3);
  const int letters = writer.dimension("letters", 8);
  const int values = writer.variable("values", Type::int16, {x}, {{}, 0, -7.0});
  const int name = writer.variable("name", Type::character, {letters});
  writer.attribute(values, "units", "m s-1");
  writer.attribute(values, "scale_factor", 0.5);
  writer.attribute(Writer::global, "title", "t");
  writer.end_definitions();
  writer.write_all(values, std::vector<double>{1, -7, 3});
  writer.write_text(name, "FINO1");
  writer.close();

  const File file = File::open(folder / "f.nc");
  const Variable* found = file.find("values");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->type, Type::int16);
  EXPECT_EQ(found->shape, std::vector<std::size_t>{3});
  EXPECT_EQ(found->number("_FillValue"), -7.0);
  EXPECT_EQ(found->number("scale_factor"), 0.5);
  EXPECT_EQ(found->text("units"), "m s-1");
  EXPECT_EQ(file.text("title"), "t");
  EXPECT_EQ(file.read_all(*found), (std::vector<double>{1, -7, 3}));
  EXPECT_EQ(file.read_text(*file.find("name")), "FINO1");
  EXPECT_EQ(file.find("absent"), nullptr);
  std::vector<float> part(2);
  file.read(*found, std::vector<std::size_t>{1}, std::vector<std::size_t>{2},
            std::span<float>(part));
  EXPECT_EQ(part, (std::vector<float>{-7.0F, 3.0F}));
  EXPECT_THROW(file.read(*found, std::vector<std::size_t>{2}, std::vector<std::size_t>{2},
                         std::span<float>(part)),
               ContractViolation);
}

TEST(NetcdfFile, AnyNumberOfTextsIsReadRowByRow) {
  const TemporaryFolder folder;
  // Three slices and a bit: rows begin and end on both sides of a cut.
  constexpr std::size_t rows = 450'001, width = 7;
  std::vector<std::string> written(rows);
  std::string letters;
  for (std::size_t i = 0; i < rows; ++i) {
    written[i] = i % 5 == 0 ? "" : std::to_string(i).append(i % 2, ' ');
    letters += written[i] + std::string(width - written[i].size(), '\0');
  }
  Writer writer = Writer::create(folder / "f.nc");
  const int row = writer.dimension("row", rows), letter = writer.dimension("letter", width);
  const int texts = writer.variable("texts", Type::character, {row, letter});
  writer.end_definitions();
  writer.write_text(texts, letters);
  writer.close();
  const File file = File::open(folder / "f.nc");
  EXPECT_EQ(file.read_texts(*file.find("texts")), written);
}

/// A header of 10 kB claims what it likes.
TEST(NetcdfFile, TextsThatNoFileCanHoldAreRefusedBeforeTheyAreMade) {
  const TemporaryFolder folder;
  const auto refusal_of = [&](std::size_t rows, std::size_t width, Writer::Layout layout) {
    Writer writer = Writer::create(folder / "f.nc");
    const int row = writer.dimension("row", rows), letter = writer.dimension("letter", width);
    (void)writer.variable("texts", Type::character, {row, letter}, layout);
    writer.end_definitions();
    writer.close();
    EXPECT_LT(std::filesystem::file_size(folder / "f.nc"), 20'000U);
    const File file = File::open(folder / "f.nc");
    try {
      (void)file.read_texts(*file.find("texts"));
    } catch (const Error& error) {
      return std::string(name_of(error.kind())) + ": " + error.message();
    }
    return std::string("nothing was thrown");
  };
  const std::string contiguous = refusal_of(1'000'000, 8, {});
  EXPECT_TRUE(contains(contiguous, "1000000 texts of 8 letters, more than the ")) << contiguous;
  const std::string deflated = refusal_of(std::size_t{1} << 26, 1, {{1 << 16, 1}, 1, {}});
  EXPECT_TRUE(contains(deflated, "invalid_input: ")) << deflated;
  EXPECT_TRUE(contains(deflated, "67108864 texts of 1 letters; expected at most 1 GiB"))
      << deflated;
  const std::string vast = refusal_of(std::size_t{1} << 40, 8, {{1 << 16, 8}, 1, {}});
  EXPECT_TRUE(contains(vast, "expected at most 1 GiB")) << vast;
}

TEST(NetcdfFile, WhatIsNoNetcdfFileIsRefusedWithAReason) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(refusal(folder / "absent.nc"), "not_found: no such file"));
  write_bytes(folder / "empty.nc", "");
  EXPECT_TRUE(contains(refusal(folder / "empty.nc"), "is empty (0 bytes)"));
  write_bytes(folder / "text.nc", "time,u,v\n1,2,3\n");
  EXPECT_TRUE(
      contains(refusal(folder / "text.nc"), "is not a NetCDF file (it starts with 'time,u,v')"));
  write_bytes(folder / "magic.nc", "CDF\x01");
  EXPECT_TRUE(contains(refusal(folder / "magic.nc"), "truncated inside its header"));
  EXPECT_TRUE(contains(refusal(folder.path()), "is not a regular file"));
}

TEST(NetcdfFile, AClassicFileThatEndsEarlyIsRefusedAtAnyLength) {
  const TemporaryFolder folder;
  for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA}) {
    write_classic(folder / "whole.nc", format);
    const auto whole = std::filesystem::file_size(folder / "whole.nc");
    EXPECT_EQ(File::open(folder / "whole.nc").find("series")->shape,
              (std::vector<std::size_t>{100, 7}));
    for (std::uintmax_t size = 1; size + 4 < whole; size += 97) {
      std::filesystem::copy_file(folder / "whole.nc", folder / "cut.nc",
                                 std::filesystem::copy_options::overwrite_existing);
      std::filesystem::resize_file(folder / "cut.nc", size);
      EXPECT_TRUE(contains(refusal(folder / "cut.nc"), "invalid_input"))
          << "cut to " << size << " bytes";
    }
  }
}

TEST(NetcdfFile, AnHdf5FileThatEndsEarlyIsRefused) {
  const TemporaryFolder folder;
  Writer writer = Writer::create(folder / "whole.nc");
  const int x = writer.dimension("x", 5000);
  const int values = writer.variable("values", Type::float64, {x});
  writer.end_definitions();
  writer.write_all(values, std::vector<double>(5000, 1.0));
  writer.close();
  const auto whole = std::filesystem::file_size(folder / "whole.nc");
  for (const std::uintmax_t size : {std::uintmax_t{8}, std::uintmax_t{100}, whole / 2, whole - 1}) {
    std::filesystem::copy_file(folder / "whole.nc", folder / "cut.nc",
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(folder / "cut.nc", size);
    EXPECT_TRUE(contains(refusal(folder / "cut.nc"), "damaged or truncated"))
        << "cut to " << size << " bytes";
  }
}

TEST(NetcdfFile, AnHdf5FileWithADamagedHeapIsRefusedNotWalkedForever) {
  const TemporaryFolder folder;
  Writer writer = Writer::create(folder / "f.nc");
  const int x = writer.dimension("x", 3);
  const int y = writer.dimension("y", 4);
  writer.variable("x", Type::float64, {x});
  writer.variable("values", Type::float64,
                  {x, y});  // the references of its axes lie in a global heap
  writer.end_definitions();
  writer.close();
  std::string bytes;
  {
    std::ifstream stream(folder / "f.nc", std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
  }
  const std::size_t heap = bytes.find("GCOL");
  ASSERT_NE(heap, std::string::npos);
  EXPECT_NO_THROW((void)File::open(folder / "f.nc"));
  std::string stands_still = bytes;
  std::fill_n(stands_still.begin() + static_cast<std::ptrdiff_t>(heap + 16), 16, '\0');
  write_bytes(folder / "still.nc", stands_still);
  EXPECT_TRUE(contains(refusal(folder / "still.nc"), "a global heap of HDF5"));
  std::string runs_over = bytes;
  runs_over[heap + 16 + 12] = '\x7f';
  write_bytes(folder / "over.nc", runs_over);
  EXPECT_TRUE(contains(refusal(folder / "over.nc"), "a global heap of HDF5"));
}

TEST(NetcdfFile, ADimensionOfNothingReadsAsNothing) {
  const TemporaryFolder folder;
  Writer writer = Writer::create(folder / "f.nc");
  const int values = writer.variable("values", Type::float32, {writer.unlimited_dimension("time")});
  (void)values;
  writer.end_definitions();
  writer.close();
  const File file = File::open(folder / "f.nc");
  EXPECT_EQ(file.find("values")->size(), 0U);
  EXPECT_TRUE(file.read_all(*file.find("values")).empty());
}

TEST(NetcdfWriter, AWriterThatIsNotClosedLeavesNothing) {
  const TemporaryFolder folder;
  { Writer writer = Writer::create(folder / "f.nc"); }
  EXPECT_FALSE(std::filesystem::exists(folder / "f.nc"));
  try {
    (void)Writer::create(folder / "absent" / "f.nc");
    FAIL() << "a folder that does not exist was written";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::unavailable);
  }
}

}  // namespace
}  // namespace slackwater::ingest::netcdf::file_test
