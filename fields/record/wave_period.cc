#include "fields/record/wave_period.h"

#include <iterator>
#include <set>

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

std::set<std::string> datasets_of(const ScalarRecord& record) {
  std::set<std::string> datasets;
  for (const auto& piece : record.pieces) datasets.insert(piece.origin->dataset);
  return datasets;
}

}  // namespace

WavePeriod wave_period_at(const SitePieces& pieces, const GeoPoint& point, bool has_heights) {
  WavePeriod found{record_at(pieces.peak_period, point), {}};
  if (!has_heights) return found;
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
    const std::set<std::string> given = datasets_of(found.peak_period);
    std::erase_if(record.pieces, [&](const auto& p) { return given.contains(p.origin->dataset); });
    if (record.pieces.empty()) continue;
    found.note += found.note.empty() ? "" : "; ";
    found.note += given.empty() ? "no peak period of the waves is stored"
                                : "no peak period of " + record.pieces.front().origin->product_id +
                                      " is stored";
    found.note += ": it is computed as " + formatted("{:.2f}", other.to_peak_period(1)) +
                  " times the " + other.name + ", as in a JONSWAP sea of gamma 3.3";
    record = converted(std::move(record), other.to_peak_period);
    std::move(record.pieces.begin(), record.pieces.end(),
              std::back_inserter(found.peak_period.pieces));
  }
  if (found.peak_period.pieces.empty())
    found.note = "no period of the waves is stored: their heights are served without one";
  return found;
}

}  // namespace slackwater
