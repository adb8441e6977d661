#include "fields/record/wave_period.h"

#include "fields/base/text.h"
#include "fields/wave/peak_period.h"

namespace slackwater {
namespace {

ScalarRecord converted(ScalarRecord record, double (*to_peak_period)(double)) {
  for (PieceColumn<double>& piece : record.pieces) {
    ScalarColumn& column = piece.column;
    for (std::size_t i = 0; i < column.value.size(); ++i) {
      if (has_value(column.status[i])) column.value[i] = to_peak_period(column.value[i]);
    }
  }
  return record;
}

}  // namespace

WavePeriod wave_period_at(const SitePieces& pieces, const GeoPoint& point, bool has_heights) {
  WavePeriod found{record_at(pieces.peak_period, point), {}};
  if (!found.peak_period.pieces.empty() || !has_heights) return found;
  struct Other {
    const std::vector<ScalarPiece>& pieces;
    const char* name;
    double (*to_peak_period)(double);
  };
  for (const Other& other :
       {Other{pieces.energy_period, "energy period (VTM10)", peak_period_of_energy_period_s},
        Other{pieces.zero_crossing_period, "zero-crossing period (VTM02)",
              peak_period_of_zero_crossing_period_s}}) {
    ScalarRecord record = record_at(other.pieces, point);
    if (record.pieces.empty()) continue;
    found.peak_period = converted(std::move(record), other.to_peak_period);
    found.note = "no peak period of the waves is stored: it is computed as " +
                 formatted("{:.2f}", other.to_peak_period(1)) + " times the " + other.name +
                 ", as in a JONSWAP sea of gamma 3.3";
    return found;
  }
  found.note = "no period of the waves is stored: their heights are served without one";
  return found;
}

}  // namespace slackwater
