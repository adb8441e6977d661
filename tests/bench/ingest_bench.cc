// Whole `slackwater ingest` (hash, decode, commit with fsync) against whole `cdo -f nc4 copy`, run
// in pairs one after the other on the same file: a 6 GB product made here, and the French coast of
// the real data. What was stored is compared with the file before any time is printed.
//
// SLACKWATER_BENCH_DIR    where the large files go (default: the current folder; 20 GB free)
// SLACKWATER_BENCH_HOURS  hours in the large product (default 24, which make 6.1 GB)
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>

#include "tests/bench/bench_report.h"
#include "tests/bench/big_product_file.h"
#include "tests/bench/stored_answer.h"
#include "tests/bench/timed_child.h"
#include "tests/support/shared_data.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr int pairs_of_big_file = 3;
constexpr int pairs_of_real_file = 7;
constexpr double most_resident_mb = 512;
constexpr double target_ratio = 1.0;

/// A folder for large files, gone with its owner.
class BenchFolder {
 public:
  BenchFolder() {
    const char* named = std::getenv("SLACKWATER_BENCH_DIR");
    const std::filesystem::path parent = named != nullptr ? named : ".";
    path_ = std::filesystem::absolute(parent) /
            ("slackwater-ingest-bench-" + std::to_string(::getpid()));
    std::filesystem::create_directories(path_);
  }
  ~BenchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  BenchFolder(const BenchFolder&) = delete;
  BenchFolder& operator=(const BenchFolder&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

struct Task {
  std::string name;
  std::filesystem::path product;
  std::vector<std::string> options;  ///< of `slackwater ingest`
  int pairs = 1;
  /// None where all that is read is also kept: cdo leaves gigabytes in memory that an ingest must
  /// bring to disk, so that the ratio measures the disk.
  std::optional<double> most_ratio;
};

/// Neither run may pay for the other's unwritten pages.
void settle(const std::filesystem::path& leftover) {
  std::filesystem::remove_all(leftover);
  ::sync();
}

template <typename Compare>
void run_task(BenchReport& report, const BenchFolder& folder, const Task& task, Compare&& compare) {
  const std::filesystem::path store = folder / "store";
  const std::filesystem::path copy = folder / "copy.nc";
  std::vector<std::string> ingest{"ingest", "--store", store.string()};
  ingest.insert(ingest.end(), task.options.begin(), task.options.end());
  ingest.push_back(task.product.string());
  const std::vector<std::string> cdo{"cdo",        "-s", "-f", "nc4", "copy", task.product.string(),
                                     copy.string()};
  std::vector<double> ours_s;
  std::vector<double> theirs_s;
  std::vector<double> ratio;
  std::vector<double> resident_mb;
  settle(store);
  for (int pair = 0; pair < task.pairs; ++pair) {
    const ChildCost ours = slackwater_or_throw(ingest);
    if (pair == 0) {
      const StoredAnswer answer = compare(store);
      report.answer(task.name, answer.right, answer.found);
      if (!answer.right) return;
    }
    settle(store);
    if (report.options().check_only) return;
    const ChildCost theirs = timed_child(cdo);
    settle(copy);
    if (theirs.exit_code != 0) {
      report.skipped(task.name, "no comparison: cdo ended with " +
                                    std::to_string(theirs.exit_code) + " " + theirs.out);
      return;
    }
    ours_s.push_back(ours.wall_s);
    theirs_s.push_back(theirs.wall_s);
    ratio.push_back(ours.wall_s / theirs.wall_s);
    resident_mb.push_back(static_cast<double>(ours.peak_resident_bytes) / 1e6);
  }
  report.figure(
      {task.name + ": ingest / cdo", "", ratio, task.most_ratio, "median ratio of pairs"});
  report.figure({"  slackwater ingest", "s", ours_s, std::nullopt, ""});
  report.figure({"  cdo -f nc4 copy", "s", theirs_s, std::nullopt, ""});
  report.figure({"  peak resident of ingest", "MB", resident_mb, most_resident_mb, ""});
}

BigProductFile::Shape shape_of_big_file(bool check_only) {
  BigProductFile::Shape shape;
  if (check_only) {
    shape = {3, 22, 100, 96, 11, 25, 24};
  } else if (const char* hours = std::getenv("SLACKWATER_BENCH_HOURS")) {
    shape.times = std::max(1UL, std::strtoul(hours, nullptr, 10));
  }
  return shape;
}

/// W,S,E,N of the cells between two shares of the grid.
std::string box_of(const BigProductFile::Shape& shape, double from, double to) {
  const auto at = [](std::size_t cells, double share) {
    return static_cast<std::size_t>(share * static_cast<double>(cells - 1));
  };
  char text[120];
  std::snprintf(text, sizeof text, "%.5f,%.5f,%.5f,%.5f",
                BigProductFile::longitude_deg(at(shape.columns, from)),
                BigProductFile::latitude_deg(at(shape.rows, from)),
                BigProductFile::longitude_deg(at(shape.columns, to)),
                BigProductFile::latitude_deg(at(shape.rows, to)));
  return text;
}

void bench_big_file(BenchReport& report, const BenchFolder& folder) {
  const BigProductFile::Shape shape = shape_of_big_file(report.options().check_only);
  const BigProductFile file(folder / "big.nc", shape);
  file.write();
  const auto compare = [&](const std::filesystem::path& store) {
    return compare_with(store, file);
  };
  run_task(report, folder,
           {"6 GB product, cut to 20 % x 20 % of the grid",
            file.path(),
            {"--bbox", box_of(shape, 0.4, 0.6)},
            pairs_of_big_file,
            target_ratio},
           compare);
  run_task(report, folder,
           {"6 GB product, box around the whole grid",
            file.path(),
            {"--bbox", box_of(shape, 0.0, 1.0)},
            1,
            std::nullopt},
           compare);
  std::filesystem::remove(file.path());
}

void bench_real_file(BenchReport& report, const BenchFolder& folder) {
  const auto shared = tests::shared_folder();
  if (!shared) {
    report.skipped("french_coast", "no real data; set SLACKWATER_SHARED to their folder");
    return;
  }
  const std::filesystem::path product =
      *shared / "data" / "french_coast_2025-02" / "dataset_french_coast.nc";
  run_task(report, folder, {"french_coast", product, {}, pairs_of_real_file, target_ratio},
           [&](const std::filesystem::path& store) { return compare_with_netcdf(store, product); });
}

}  // namespace

int main(int argc, char** argv) {
  BenchReport report(bench_options(argc, argv));
  try {
    const BenchFolder folder;
    // The large file first: comparing the real one whole would swell this driver, and its pages
    // count in a child's peak.
    bench_big_file(report, folder);
    bench_real_file(report, folder);
  } catch (const std::exception& problem) {
    report.answer("ingest", false, problem.what());
  }
  return report.exit_code();
}
