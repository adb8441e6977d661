// made_up_forecast OUT COLUMNS [LEVELS [MEMBERS]]: writes a forecast with an ensemble for
// strangers' tools to open, reads it back, and prints its size and both times.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

#include "ingest/cf/forecast/forecast_file.h"
#include "tests/support/made_up_forecast.h"

namespace {

using namespace slackwater;

template <typename Work>
double milliseconds_of(Work&& work) {
  const auto from = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count();
}

std::size_t number(int argc, char** argv, int index, std::size_t otherwise) {
  return index < argc ? static_cast<std::size_t>(std::strtoul(argv[index], nullptr, 10))
                      : otherwise;
}

void write_and_measure(int argc, char** argv) {
  const std::filesystem::path out = argv[1];
  tests::MadeUpForecast size;
  size.columns = number(argc, argv, 2, size.columns);
  size.levels = number(argc, argv, 3, size.levels);
  size.members = number(argc, argv, 4, size.members);
  const Snapshot made = tests::made_up_forecast(size);
  const double writing = milliseconds_of([&] { ingest::write_forecast(out, made); });
  Snapshot read;
  const double reading = milliseconds_of([&] { read = ingest::read_forecast(out); });
  const double central =
      milliseconds_of([&] { read = ingest::read_forecast(out, ingest::Members::none); });
  const double one = milliseconds_of([&] { ingest::read_members(out, read, size.columns / 2); });
  std::printf(
      "%zu columns, %zu stamps, %zu levels, %zu members: %.2f MB; written in %.0f ms, read in %.0f "
      "ms, without members in %.0f ms, members of one column in %.1f ms more\n",
      size.columns, made.time.size(), size.levels, size.members,
      static_cast<double>(std::filesystem::file_size(out)) / 1e6, writing, reading, central, one);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "give OUT COLUMNS [LEVELS [MEMBERS]]\n");
    return 2;
  }
  try {
    write_and_measure(argc, argv);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
  return 0;
}
