// What it costs that `slackwater ingest` reads each file in a confined process of its own: the same
// ingest with and without, in pairs, each in a fresh process and a fresh store, on the French coast
// of the real data and on an uncompressed product of 1 GB made here of which a part is kept. What
// both stores hold is compared before any time is printed.
//
// SLACKWATER_BENCH_DIR  where the stores and the large file go (default: the temporary folder)
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>

#include "api/pipeline/ingest/ingest_files.h"
#include "fields/base/process/pipe.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/big_product_file.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;
namespace fs = std::filesystem;

constexpr int pairs = 9;
constexpr double most_ratio = 1.05;  ///< of a file that takes a second
constexpr double most_more_ms =
    40;  ///< of any: another process, its fences, the store opened twice

/// Seconds that `work` takes in a process of its own. @throws where it fails
template <typename Work>
double seconds_of(const Work& work) {
  Pipe pipe;
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process could be made");
  if (child == 0) {
    double took_s = -1;
    try {
      const auto from = std::chrono::steady_clock::now();
      work();
      took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
    } catch (const std::exception& problem) {
      std::fprintf(stderr, "%s\n", problem.what());
    }
    ::_exit(::write(pipe.writing(), &took_s, sizeof took_s) == sizeof took_s ? 0 : 1);
  }
  pipe.close_writing();  // so that a child that dies is heard of
  double took_s = -1;
  const bool is_told = ::read(pipe.reading(), &took_s, sizeof took_s) == sizeof took_s;
  ::waitpid(child, nullptr, 0);
  if (!is_told || took_s < 0) throw std::runtime_error("an ingest failed");
  return took_s;
}

/// Names and sizes: what lies in a store is named by its checksum.
std::set<std::string> content_of(const fs::path& store) {
  std::set<std::string> content;
  for (const auto& entry : fs::recursive_directory_iterator(store)) {
    if (entry.is_regular_file() && entry.path().extension() == ".nc")
      content.insert(entry.path().filename().string() + " " + std::to_string(entry.file_size()));
  }
  return content;
}

void bench_file(BenchReport& report, const std::string& name, const fs::path& file,
                const ingest::IngestOptions& options, const fs::path& work,
                std::optional<double> at_most) {
  const auto products =
      ingest::ProductCatalogue::load(tests::source_folder() / "data" / "products", {});
  const UtcTime now = UtcTime{parse_day("2025-06-01")};
  const auto here = [&] {
    store::Store store = store::Store::open(work / "here", store::OpenMode::create_or_write);
    static_cast<void>(api::ingest_file(store, products, file, options, now, {}));
  };
  const auto apart = [&] {
    static_cast<void>(api::ingest_file_apart(work / "apart", products, file, options, now, {}));
    static_cast<void>(store::Store::open(work / "apart", store::OpenMode::create_or_write));
  };
  std::vector<double> here_s, apart_s, ratios, more_ms;
  for (int pair = 0; pair <= pairs; ++pair) {
    for (const char* each : {"here", "apart"}) fs::remove_all(work / each);
    ::sync();
    const bool is_here_first = pair % 2 == 0;
    double of_here_s = is_here_first ? seconds_of(here) : 0;
    const double of_apart_s = seconds_of(apart);
    if (!is_here_first) of_here_s = seconds_of(here);
    if (pair == 0) {  // and the file is in memory now
      const auto found = content_of(work / "apart");
      report.answer(name, !found.empty() && found == content_of(work / "here"),
                    std::to_string(found.size()) + " content files, the same read apart as here");
      if (report.options().check_only || !report.all_right()) return;
      continue;
    }
    here_s.push_back(of_here_s);
    apart_s.push_back(of_apart_s);
    ratios.push_back(of_apart_s / of_here_s);
    more_ms.push_back(1000 * (of_apart_s - of_here_s));
  }
  report.figure({name + ": apart / here", "", ratios, at_most, "median ratio of pairs"});
  report.figure({"  apart - here", "ms", more_ms, most_more_ms, "median difference of pairs"});
  report.figure({"  apart", "s", apart_s, std::nullopt, ""});
  report.figure({"  here", "s", here_s, std::nullopt, ""});
}

void bench_apart(BenchReport& report) {
  const tests::TemporaryFolder temporary;
  const char* named = std::getenv("SLACKWATER_BENCH_DIR");
  const fs::path work = (named != nullptr ? fs::path(named) : temporary.path()) /
                        ("slackwater-apart-bench-" + std::to_string(::getpid()));
  fs::create_directories(work);
  if (const auto shared = tests::shared_folder()) {
    bench_file(report, "french_coast",
               *shared / "data" / "french_coast_2025-02" / "dataset_french_coast.nc", {}, work,
               std::nullopt);
  } else {
    report.skipped("french_coast", "no real data; set SLACKWATER_SHARED to their folder");
  }
  BigProductFile::Shape shape;
  shape.times = 4;
  if (report.options().check_only) shape = {3, 22, 100, 96, 11, 25, 24};
  const BigProductFile file(work / "big.nc", shape);
  file.write();
  const auto at = [](std::size_t cells, double share) {
    return static_cast<std::size_t>(share * static_cast<double>(cells - 1));
  };
  ingest::IngestOptions options;
  options.cut = BoundingBox{BigProductFile::longitude_deg(at(shape.columns, 0.4)),
                            BigProductFile::latitude_deg(at(shape.rows, 0.4)),
                            BigProductFile::longitude_deg(at(shape.columns, 0.6)),
                            BigProductFile::latitude_deg(at(shape.rows, 0.6))};
  bench_file(report, "1 GB product, cut to 20 % x 20 % of the grid", file.path(), options, work,
             most_ratio);
  fs::remove_all(work);
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "apart", bench_apart); }
