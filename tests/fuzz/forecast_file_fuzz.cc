#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "fields/service/field.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "tests/fuzz/fuzz_case.h"
#include "tests/fuzz/scratch_folder.h"

namespace {

using namespace slackwater;

/// What a snapshot promises to those who sample it.
void claim_whole(const Snapshot& snapshot) {
  fuzz::claim(!snapshot.columns.empty() && !snapshot.time.empty(),
              "a forecast without columns or times");
  const std::size_t times = snapshot.time.size();
  const std::size_t cells = times * snapshot.depth_m.size();
  fuzz::claim(snapshot.members >= 1, "a forecast without a central member");
  const std::size_t more = snapshot.members - 1;
  for (const ForecastColumn& column : snapshot.columns) {
    const std::size_t currents = column.current_m_s.size();
    fuzz::claim(currents == 0 || currents == cells, "currents for some times or depths only");
    fuzz::claim(
        column.current_sigma_m_s.size() == currents && column.current_status.size() == currents,
        "currents without their spread or status");
    fuzz::claim(column.wind_m_s.empty() || column.wind_m_s.size() == times,
                "wind for some times only");
    fuzz::claim(column.member_m_s.empty() || column.member_m_s.size() == more * currents,
                "members for some times or depths only");
    fuzz::claim(column.wind_member_m_s.empty() ||
                    column.wind_member_m_s.size() == more * column.wind_m_s.size(),
                "wind of members for some times only");
    fuzz::claim(column.wind_member_number.empty() ||
                    (!column.wind_member_m_s.empty() && column.wind_member_number.size() == more),
                "numbers of winds for some members only");
    fuzz::claim(column.wind_source.size() == column.wind_m_s.size(), "wind without its source");
    fuzz::claim(column.sea.empty() || column.sea.size() == times, "waves for some times only");
    fuzz::claim(column.sea_source.size() == column.sea.size(), "waves without their source");
  }
}

void claim_sampling_is_safe(const Snapshot& snapshot) {
  const std::array depths_m{-1.0, 0.0, 3.0, 50.0, 20000.0};
  std::array<CurrentSample, depths_m.size()> samples;
  const auto last = snapshot.time.back();
  const Field field(std::make_shared<const Snapshot>(snapshot));
  const GeoPoint& point = snapshot.columns.front().point;
  for (const UtcTime time :
       {snapshot.time.front(), last, snapshot.time.front() + std::chrono::minutes(30)}) {
    for (const std::size_t member : {std::size_t{0}, snapshot.members - 1, snapshot.members}) {
      field.sample_profile(point.longitude_deg(), point.latitude_deg(), time, depths_m, samples,
                           member);
      for (const CurrentSample& sample : samples) {
        fuzz::claim(!has_value(sample.status) || (std::isfinite(sample.velocity_m_s.real()) &&
                                                  std::isfinite(sample.velocity_m_s.imag())),
                    "a served current that is not finite");
      }
    }
  }
}

/// What is read column by column is what is read at once.
void claim_parts_are_the_whole(const std::filesystem::path& file, const Snapshot& whole) {
  Snapshot part = ingest::read_forecast(file, ingest::Members::none);
  const std::size_t last = whole.columns.size() - 1;
  ingest::read_members(file, part, last);
  fuzz::claim(part.members == whole.members &&
                  part.columns[last].member_m_s == whole.columns[last].member_m_s &&
                  part.columns[last].wind_member_m_s == whole.columns[last].wind_member_m_s &&
                  part.columns[last].wind_member_number == whole.columns[last].wind_member_number,
              "members of one column that are not those of the whole file");
}

}  // namespace

/// Issued forecasts, as a damaged disk or a stranger might hand them in.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz::scratch_folder().file_of(data, size, "forecast.nc");
  fuzz::accepts([&] {
    const Snapshot snapshot = ingest::read_forecast(file);
    claim_whole(snapshot);
    claim_sampling_is_safe(snapshot);
    claim_parts_are_the_whole(file, snapshot);
  });
  return 0;
}
