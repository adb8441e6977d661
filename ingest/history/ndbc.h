#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slackwater::ingest {

/// A column of the National Data Buoy Center's text files.
struct NdbcColumn {
  std::string_view name;           ///< "WVHT"
  std::string_view standard_name;  ///< CF; empty where the file's own words name no CF quantity
  std::string_view unit;           ///< of files without a line of units
  double missing = 99;             ///< the number for "not measured" (`MM` in realtime files)
};

/// The column of this name; null where NDBC has none. Units, meanings and numbers for missing
/// values: NDBC, "Measurement Descriptions and Units" and "How are missing data denoted"
/// (ndbc.noaa.gov/faq/measdes.shtml, ndbc.noaa.gov/docs/ndbc_web_data_guide.pdf). The average
/// period APD has no CF name here: its definition changed with the payloads.
[[nodiscard]] const NdbcColumn* ndbc_column(std::string_view name) noexcept;

/// Whether a line begins an NDBC text file, historical or of `realtime2`:
///
///   #YY  MM DD hh mm WDIR WSPD GST  WVHT   DPD   APD MWD   PRES  ATMP  WTMP  DEWP  VIS  TIDE
///   YYYY MM DD hh    WD   WSPD GST  WVHT  DPD   APD  MWD  BAR    ATMP  WTMP  DEWP  VIS
[[nodiscard]] bool is_ndbc_head(std::string_view line);

/// The words of a line, with a leading # taken off.
[[nodiscard]] std::vector<std::string> blank_separated(std::string_view line);

}  // namespace slackwater::ingest
