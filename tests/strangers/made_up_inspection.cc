// made_up_inspection OUT: writes the page of a made-up inspection as whoever flew it has it and
// with the truth, and its findings: OUT/{flown,truth}.{html,geojson,csv}; and a page of many
// surfaces' worth of patches, OUT/large.html.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "api/show/coverage/findings_file.h"
#include "api/show/rehearse/run_page.h"
#include "tests/api/show/coverage/made_up_inspection.h"

namespace {

using namespace slackwater;

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

void write_all(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const ingest::TrajectoryFile log = tests::made_up_inspection();
  for (const bool shows_truth : {false, true}) {
    const char* name = shows_truth ? "truth" : "flown";
    api::write_run_page(log, folder / (std::string(name) + ".html"), {shows_truth});
    write(folder / (std::string(name) + ".geojson"), api::findings_geojson(log, {shows_truth}));
    write(folder / (std::string(name) + ".csv"), api::findings_csv(log, {shows_truth}));
  }
  api::write_run_page(tests::made_up_inspection({.columns = 400, .rows = 250}),
                      folder / "large.html", {true});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    write_all(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "made_up_inspection: %s\n", error.what());
    return 1;
  }
  return 0;
}
