#pragma once
#include <string>

#include "fields/base/text.h"

namespace slackwater::tests {

/// The first line of a table of AIS as MarineCadastre.gov has it: one needs no decoder.
inline const std::string ais_table_head =
    "MMSI,BaseDateTime,LAT,LON,SOG,COG,Heading,VesselName,VesselType,Length,Width,"
    "TransceiverClass\n";

/// One report; the speed is in knots, as the table has it.
struct AisRow {
  unsigned mmsi = 211000001;
  std::string time = "2025-03-04T06:00:00";
  double latitude_deg = 54;
  double longitude_deg = 6.5;
  double speed_kn = 10;
  double course_deg = 0;
  std::string name = "NORTHERN STAR";
  int type = 70;
  char speaker = 'A';
};

inline std::string ais_line(const AisRow& row) {
  std::string name;
  for (const char c : row.name) name += c == '"' ? "\"\"" : std::string(1, c);
  return formatted("{},{},{:.6f},{:.6f},{:.1f},{:.1f},511,\"{}\",{},90,14,{}\n", row.mmsi, row.time,
                   row.latitude_deg, row.longitude_deg, row.speed_kn, row.course_deg, name,
                   row.type, std::string(1, row.speaker));
}

}  // namespace slackwater::tests
