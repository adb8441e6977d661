#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/ais/report.h"

namespace slackwater::ingest {

/// Rows of AIS as MarineCadastre.gov publishes it, one position with the vessel's particulars a
/// row, UTC:
///
///   MMSI,BaseDateTime,LAT,LON,SOG,COG,Heading,VesselName,IMO,CallSign,VesselType,Status,
///   Length,Width,Draft,Cargo,TransceiverClass
///
/// Columns are found by name, in any order; the first four are needed. Knots, degrees, metres; `NA`
/// and nothing are absent, and so are the values by which ITU-R M.1371 says "not available".
/// Source: marinecadastre.gov/ais, data dictionary.
class MarineCadastreReader {
 public:
  /// Whether a file that begins with this line is one of these.
  [[nodiscard]] static bool is_header(std::string_view line);
  explicit MarineCadastreReader(std::string_view header);
  /// @return nothing for a row without MMSI or time, or that is no row of this table
  [[nodiscard]] std::optional<AisReport> report_of(std::string_view row) const;

 private:
  std::map<std::string, std::size_t, std::less<>> column_;
  std::size_t columns_ = 0;
};

/// The fields of one line of comma-separated values; quotes as RFC 4180 has them.
[[nodiscard]] std::vector<std::string> fields_of_csv(std::string_view line);

}  // namespace slackwater::ingest
