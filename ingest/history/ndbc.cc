#include "ingest/history/ndbc.h"

#include <array>

namespace slackwater::ingest {
namespace {

constexpr std::string_view peak_period =
    "sea_surface_wave_period_at_variance_spectral_density_maximum";
constexpr std::string_view peak_direction =
    "sea_surface_wave_from_direction_at_variance_spectral_density_maximum";

constexpr std::array ndbc_columns{
    NdbcColumn{"WDIR", "wind_from_direction", "degree", 999},
    NdbcColumn{"WD", "wind_from_direction", "degree", 999},
    NdbcColumn{"WSPD", "wind_speed", "m s-1", 99},
    NdbcColumn{"GST", "wind_speed_of_gust", "m s-1", 99},
    NdbcColumn{"WVHT", "sea_surface_wave_significant_height", "m", 99},
    NdbcColumn{"DPD", peak_period, "s", 99},
    NdbcColumn{"APD", "", "s", 99},
    NdbcColumn{"MWD", peak_direction, "degree", 999},
    NdbcColumn{"PRES", "air_pressure_at_mean_sea_level", "hPa", 9999},
    NdbcColumn{"BAR", "air_pressure_at_mean_sea_level", "hPa", 9999},
    NdbcColumn{"PTDY", "tendency_of_air_pressure", "hPa", 99},
    NdbcColumn{"ATMP", "air_temperature", "degC", 999},
    NdbcColumn{"WTMP", "sea_water_temperature", "degC", 999},
    NdbcColumn{"DEWP", "dew_point_temperature", "degC", 999},
    NdbcColumn{"VIS", "visibility_in_air", "nautical_mile", 99},
    NdbcColumn{"TIDE", "", "ft", 99},
};

}  // namespace

const NdbcColumn* ndbc_column(std::string_view name) noexcept {
  for (const NdbcColumn& column : ndbc_columns) {
    if (column.name == name) return &column;
  }
  return nullptr;
}

std::vector<std::string> blank_separated(std::string_view line) {
  std::vector<std::string> words;
  if (line.starts_with('#')) line.remove_prefix(1);
  for (std::size_t at = 0;;) {
    at = line.find_first_not_of(" \t\r", at);
    if (at == std::string_view::npos) return words;
    const std::size_t end = line.find_first_of(" \t\r", at);
    words.emplace_back(line.substr(at, end - at));
    if (end == std::string_view::npos) return words;
    at = end;
  }
}

bool is_ndbc_head(std::string_view line) {
  if (line.find(',') != std::string_view::npos) return false;
  const std::vector<std::string> words = blank_separated(line);
  return words.size() >= 5 && (words[0] == "YY" || words[0] == "YYYY") && words[1] == "MM" &&
         words[2] == "DD" && words[3] == "hh";
}

}  // namespace slackwater::ingest
