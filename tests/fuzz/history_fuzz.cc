#include <cmath>

#include "api/ask/history/series_limit.h"
#include "fields/record/regular_history.h"
#include "ingest/history/csv_history.h"
#include "ingest/history/written_time.h"
#include "tests/fuzz/fuzz_case.h"
#include "tests/fuzz/granule_oracle.h"
#include "tests/fuzz/scratch_folder.h"

namespace {

using namespace slackwater;
using namespace slackwater::ingest;

void check_limit(const std::string& text) {
  fuzz::accepts([&] {
    const api::SeriesLimit limit = api::parse_series_limit(text);
    fuzz::claim(!limit.variable.empty() && std::isfinite(limit.bound.value), "a limit on nothing");
    static_cast<void>(api::expect_possible({limit}, fuzz::products().vocabulary()));
  });
  fuzz::accepts([&] { static_cast<void>(parse_named_column(text)); });
  if (const auto time = read_written_time(text)) {
    if (time->utc() >= UtcTime{}) static_cast<void>(format_utc(time->utc()));
  }
}

void check_series(const HistorySeries& series) {
  fuzz::claim(series.time.size() == series.value.size(), "more values than times, or fewer");
  fuzz::claim(!series.unit.empty(), "a series without a unit");
  for (std::size_t t = 0; t < series.time.size(); ++t) {
    fuzz::claim(!std::isinf(series.value[t]), "an infinite value");
    if (t > 0) fuzz::claim(series.time[t - 1] < series.time[t], "times that do not ascend");
  }
  if (series.time.size() < 2) return;
  if (series.time.back() - series.time.front() > std::chrono::hours(1000)) return;  // takes room
  fuzz::accepts([&] {
    const RegularHistory regular = on_regular_steps({&series, 1});
    fuzz::claim(regular.values.front().size() == regular.clock.steps, "a value for each step");
    fuzz::claim(regular.clock.end() > series.time.back(), "the last value is left out");
  });
}

}  // namespace

/// A limit in the first line, in the others a table with the past of a place.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  check_limit(std::string(text.substr(0, end)));
  const std::size_t rest = std::min(end + 1, size);
  const auto file = fuzz::scratch_folder().file_of(data + rest, size - rest, "history.csv");
  HistoryOptions options;
  options.columns = {{"Hs", "sea_surface_wave_significant_height", "cm"}, {"v", "visibility", "m"}};
  options.assume_utc = size % 2 == 0;
  fuzz::accepts([&] {
    const HistoryOfFile found =
        read_csv_history(file, {"sea_surface_wave_significant_height", "wind_speed", "v"}, options,
                         fuzz::products().vocabulary());
    for (const auto& series : found.series)
      if (series) check_series(*series);
  });
  return 0;
}
