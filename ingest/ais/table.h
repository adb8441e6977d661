#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/ais/report.h"

namespace slackwater::ingest {

/// Rows of AIS, one position with the vessel's particulars a row, UTC, as two authorities publish
/// them:
///
///   MarineCadastre.gov to 2024   MMSI,BaseDateTime,LAT,LON,SOG,COG,Heading,VesselName,IMO,
///                                CallSign,VesselType,Status,Length,Width,Draft,Cargo,
///                                TransceiverClass
///   MarineCadastre.gov, csv2     mmsi,base_date_time,longitude,latitude,sog,cog,heading,
///                                vessel_name,imo,call_sign,vessel_type,status,length,width,draft,
///                                cargo,transceiver
///   Danish Maritime Authority    # Timestamp,Type of mobile,MMSI,Latitude,Longitude,...,ROT,SOG,
///                                COG,Heading,IMO,Callsign,Name,Ship type,...,A,B,C,D
///
/// Columns are found by name, whatever the case, blanks and underscores, in any order; who, when
/// and where are needed. Knots, degrees, metres; days stand first in Danish times (31/12/2015
/// 23:59:59). `NA`, `Unknown`, `Undefined` and nothing are absent, and so are the values by which
/// ITU-R M.1371 says "not available". Danish words for ship types become the first number of the
/// type (cargo 70). Source: marinecadastre.gov/ais, data dictionary; web.ais.dk/aisdata,
/// !_README_information_CSV_files.txt.
class AisTable {
 public:
  /// Whether a file that begins with this line is one of these.
  [[nodiscard]] static bool is_header(std::string_view line);
  /// Whether the line names columns of AIS, of these or of another table.
  [[nodiscard]] static bool looks_like_one(std::string_view line);
  explicit AisTable(std::string_view header);
  /// @return nothing for a row without MMSI or time, or that is no row of this table; type 0 for a
  ///         row of no ship (an aid to navigation, a transponder in the water)
  [[nodiscard]] std::optional<AisReport> report_of(std::string_view row) const;

 private:
  std::map<std::string, std::size_t, std::less<>> column_;  ///< by our own name for it
  std::size_t columns_ = 0;
  bool is_danish_ = false;
};

/// The fields of one line of comma-separated values; quotes as RFC 4180 has them.
[[nodiscard]] std::vector<std::string> fields_of_csv(std::string_view line);

}  // namespace slackwater::ingest
