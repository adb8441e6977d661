#include "calibration/day/given/moored_instruments.h"

#include <algorithm>
#include <utility>

#include "fields/base/text.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using Piece = PieceColumn<Horizontal>;

bool has_values_until(const VectorColumn& column, UtcTime until) {
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (column.time[t].start > until) continue;
    for (std::size_t k = 0; k < column.levels(); ++k)
      if (column.has(t, k)) return true;
  }
  return false;
}

/// One piece of each in-situ dataset within reach, nearest first.
std::vector<const Piece*> series_in_reach(const ColumnData& column, const ForecastPlan& plan) {
  std::vector<const Piece*> found;
  for (const Piece& piece : column.current.pieces) {
    if (!is_in_situ(*piece.origin) || piece.column.vertical != VerticalKind::depth_m) continue;
    if (piece.distance_m > FusionSettings{}.farthest_m) continue;
    if (has_values_until(piece.column, plan.end_of_day())) found.push_back(&piece);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Piece* a, const Piece* b) { return a->distance_m < b->distance_m; });
  std::vector<const Piece*> of_each;
  for (const Piece* piece : found) {
    const bool is_known = std::any_of(of_each.begin(), of_each.end(), [&](const Piece* other) {
      return other->origin->dataset == piece->origin->dataset;
    });
    if (!is_known) of_each.push_back(piece);
  }
  return of_each;
}

MooredInstrument named(const Piece& piece) {
  MooredInstrument instrument;
  instrument.dataset = piece.origin->dataset;
  instrument.station = piece.origin->station;
  instrument.distance_m = piece.distance_m;
  return instrument;
}

/// The largest error that any of its files states.
std::optional<double> stated_error(const std::vector<const Origin*>& origins) {
  std::optional<double> stated;
  for (const Origin* origin : origins) {
    if (origin->stated_error_m_s) stated = std::max(stated.value_or(0), *origin->stated_error_m_s);
  }
  return stated;
}

/// "station X at 2.1 km".
std::string name_of(const MooredInstrument& instrument) {
  return "station " + instrument.station +
         formatted(" at {:.1f} km", instrument.distance_m / 1000.0);
}

/// "station X at 2.1 km is not used: it ended 4.0 days before", or what was left out of one that
/// is used; empty where there is nothing to say.
std::string remark_on(const MooredInstrument& instrument) {
  const MooredInstrumentVerdict& verdict = instrument.verdict;
  if (!instrument.is_used()) return name_of(instrument) + " is not used: " + verdict.why;
  if (verdict.remarks.empty()) return {};
  return name_of(instrument) + ": " + joined(verdict.remarks, "; ");
}

/// Of one that lies: rejected, or stuck up to the end.
std::optional<MooredInstrumentTrouble> trouble_with(const MooredInstrument& instrument) {
  if (instrument.is_rejected())
    return MooredInstrumentTrouble{instrument.station, remark_on(instrument)};
  if (!instrument.verdict.is_stuck_at_the_end) return std::nullopt;
  return MooredInstrumentTrouble{instrument.station, name_of(instrument) + " is stuck: " +
                                                         joined(instrument.verdict.remarks, "; ")};
}

}  // namespace

Chosen<Horizontal> known_of(const ColumnData& column, const ForecastPlan& plan,
                            const std::string& dataset) {
  Choice choice;
  choice.dataset = dataset;
  Chosen<Horizontal> chosen = choose(column.current, plan.knowledge(), choice);
  Chosen<Horizontal> known;
  known.column = slice(chosen.column, UtcTime::min(), plan.end_of_day());
  // A surface product without a depth axis speaks of the surface.
  if (known.column.levels_m.empty()) {
    known.column.levels_m = {0.0};
    known.column.vertical = VerticalKind::depth_m;
  }
  chosen.origin.resize(known.column.times());
  known.origin = std::move(chosen.origin);
  known.stretches = std::move(chosen.stretches);
  return known;
}

std::vector<MooredInstrument> instruments_beside(const ColumnData& column, const ForecastPlan& plan,
                                                 const VectorColumn& product) {
  std::vector<MooredInstrument> instruments;
  for (const Piece* piece : series_in_reach(column, plan)) {
    MooredInstrument instrument = named(*piece);
    const Chosen<Horizontal> known = known_of(column, plan, instrument.dataset);
    if (known.empty()) continue;
    for (const Origin* origin : known.origin) {
      if (std::find(instrument.origins.begin(), instrument.origins.end(), origin) ==
          instrument.origins.end())
        instrument.origins.push_back(origin);
    }
    instrument.stretches = known.stretches;
    instrument.stated_error_m_s = stated_error(instrument.origins);
    instrument.verdict = check_instrument(product, known.column, instrument.distance_m,
                                          plan.end_of_day(), instrument.stated_error_m_s);
    instruments.push_back(std::move(instrument));
  }
  return instruments;
}

std::vector<MooredInstrument> instruments_without_product(const ColumnData& column,
                                                          const ForecastPlan& plan) {
  std::vector<MooredInstrument> instruments;
  for (const Piece* piece : series_in_reach(column, plan)) {
    instruments.push_back(named(*piece));
    instruments.back().verdict.use = MooredInstrumentUse::apart;
    instruments.back().verdict.why = "no current product is stored to combine it with";
  }
  return instruments;
}

RecordRemarks remarks_on(const std::vector<MooredInstrument>& instruments,
                         const std::string& dataset, bool has_product) {
  RecordRemarks remarks;
  for (const MooredInstrument& instrument : instruments) {
    if (auto trouble = trouble_with(instrument)) remarks.troubles.push_back(std::move(*trouble));
    if (instrument.dataset == dataset) {
      remarks.notes.push_back(
          "currents of " + name_of(instrument) +
          (has_product ? " fused with a coarser product" : " alone, no product"));
      if (!has_product) continue;
    } else if (instrument.is_used()) {
      remarks.notes.push_back("fused with " + name_of(instrument));
    }
    const std::string remark = remark_on(instrument);
    if (!remark.empty()) remarks.notes.push_back(remark);
  }
  return remarks;
}

}  // namespace slackwater::calibration
