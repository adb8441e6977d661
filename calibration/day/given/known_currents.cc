#include "calibration/day/given/known_currents.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibration/fuse/fusion.h"
#include "calibration/fuse/instrument_noise.h"
#include "fields/base/text.h"
#include "fields/interpolate/column_levels.h"
#include "fields/record/leading_dataset.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using Piece = PieceColumn<Horizontal>;

const Piece* piece_of(const ColumnData& column, const std::string& dataset) {
  for (const Piece& piece : column.current.pieces)
    if (piece.origin->dataset == dataset) return &piece;
  return nullptr;
}

bool is_series(const Piece* piece) { return piece != nullptr && is_in_situ(*piece->origin); }

/// The product behind a series that leads; nothing where there is none on D.
std::optional<std::string> product_behind(const ColumnData& column, const ForecastPlan& plan) {
  VectorRecord products;
  for (const Piece& piece : column.current.pieces)
    if (!is_in_situ(*piece.origin)) products.pieces.push_back(piece);
  return leading_dataset(products, UtcTime(plan.day), plan.end_of_day(), plan.knowledge());
}

/// What the record of a plan is made of.
struct Ingredients {
  Chosen<Horizontal> leading;                 ///< the plan's dataset
  std::optional<Chosen<Horizontal>> behind;   ///< the product, where a series leads
  std::vector<MooredInstrument> instruments;  ///< nearest first, the leading series among them
};

Ingredients ingredients_of(const ColumnData& column, const ForecastPlan& plan) {
  Ingredients parts;
  parts.leading = known_of(column, plan, plan.dataset);
  if (!is_series(piece_of(column, plan.dataset))) {
    if (!parts.leading.empty())
      parts.instruments = instruments_beside(column, plan, parts.leading.column);
    return parts;
  }
  if (const auto product = product_behind(column, plan)) {
    Chosen<Horizontal> known = known_of(column, plan, *product);
    if (!known.empty()) parts.behind = std::move(known);
  }
  parts.instruments = parts.behind ? instruments_beside(column, plan, parts.behind->column)
                                   : instruments_without_product(column, plan);
  return parts;
}

/// The product brought to the cells and depths of a series, fused there, and the series itself
/// where the product has nothing.
FusedColumn fused_on_series(const VectorColumn& series, const VectorColumn& product,
                            double distance_m, const MooredInstrumentErrors& errors) {
  const VectorColumn background =
      at_times(at_depths(product, series.levels_m), series.time, std::chrono::hours(30));
  FusedColumn fused = fuse(background, series, distance_m, {}, errors);
  VectorColumn& column = fused.column;
  for (std::size_t i = 0; i < column.value.size(); ++i) {
    if (has_value(column.status[i])) continue;
    column.value[i] = series.value[i];
    column.status[i] = series.status[i];
    if (!errors.noise_m_s.empty()) fused.noise_m_s[i] = errors.noise_m_s[i % series.levels()];
  }
  column.point = series.point;
  column.source = series.source;
  return fused;
}

/// What error is left where the next instrument speaks: the root mean square of those after the
/// instruments before it, the product's own where there were none.
double error_left(const FusedColumn& fused, const VectorColumn& next) {
  if (fused.sigma_m_s.empty()) return FusionSettings{}.product_error_m_s;
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t t = 0; t < fused.column.times(); ++t) {
    const UtcTime time = fused.column.time[t].centre();
    if (next.time.empty() || time < next.time.front().start || time > next.time.back().end)
      continue;
    for (std::size_t k = 0; k < fused.column.levels(); ++k) {
      const double sigma = fused.sigma_m_s[fused.column.offset(t, k)];
      if (sigma <= 0) continue;
      squares += sigma * sigma;
      ++count;
    }
  }
  if (count == 0) return FusionSettings{}.product_error_m_s;
  return std::min(FusionSettings{}.product_error_m_s,
                  std::sqrt(squares / static_cast<double>(count)));
}

/// Draws a column towards one more instrument.
void take_in(const MooredInstrument& instrument, FusedColumn& fused) {
  FusionSettings settings;
  const VectorColumn& series = instrument.verdict.column;
  settings.product_error_m_s = error_left(fused, series);
  const std::vector<double> before = std::move(fused.noise_m_s);
  fused = fuse(fused.column, series, instrument.distance_m, settings, instrument.verdict.errors);
  for (std::size_t i = 0; i < before.size(); ++i)
    fused.noise_m_s[i] = std::hypot(fused.noise_m_s[i], before[i]);
}

/// The noise of a series that stands alone and states an error: as its own values show it, no more
/// than is stated. What lasts of an error is no noise.
std::vector<double> stated_noise(const Chosen<Horizontal>& series) {
  std::optional<double> stated;
  for (const Origin* origin : series.origin) {
    if (origin != nullptr && origin->stated_error_m_s)
      stated = std::max(stated.value_or(0), *origin->stated_error_m_s);
  }
  if (!stated) return {};
  std::vector<double> noise;
  const std::vector<double> of_level = instrument_noise(series.column);
  for (std::size_t i = 0; i < series.column.value.size(); ++i)
    noise.push_back(std::min(*stated, of_level[i % of_level.size()]));
  return noise;
}

void add_origins(const std::vector<const Origin*>& more, Chosen<Horizontal>& known) {
  for (const Origin* origin : more) {
    if (std::find(known.origin.begin(), known.origin.end(), origin) == known.origin.end())
      known.origin.push_back(origin);
  }
}

void add_stretches(const std::vector<Stretch>& more, const char* why, Chosen<Horizontal>& known) {
  for (Stretch stretch : more) {
    stretch.why = why;
    known.stretches.push_back(std::move(stretch));
  }
}

/// The plan's dataset with its instruments in it.
/// @param is_series  the dataset is one itself
Chosen<Horizontal> fused_record(Ingredients parts, const ForecastPlan& plan, bool is_series) {
  Chosen<Horizontal> known = std::move(parts.leading);
  if (known.empty()) return known;
  if (is_series && !parts.behind) {
    known.noise_m_s = stated_noise(known);
    return known;
  }
  FusedColumn fused;
  fused.column = std::move(known.column);
  if (parts.behind) {
    const auto own = std::find_if(
        parts.instruments.begin(), parts.instruments.end(),
        [&](const MooredInstrument& instrument) { return instrument.dataset == plan.dataset; });
    if (own != parts.instruments.end()) {
      // Its levels and times are those of the record, whatever is thought of it now: the choice of
      // the day decided that it leads.
      fused = fused_on_series(own->verdict.column, parts.behind->column, own->distance_m,
                              own->verdict.errors);
      parts.instruments.erase(own);
      add_origins(parts.behind->origin, known);
      add_stretches(parts.behind->stretches, "behind the instrument", known);
    }
  }
  for (const MooredInstrument& instrument : parts.instruments) {
    if (!instrument.is_used()) continue;
    take_in(instrument, fused);
    add_origins(instrument.origins, known);
    add_stretches(instrument.stretches, "fused with it", known);
  }
  known.column = std::move(fused.column);
  known.noise_m_s = std::move(fused.noise_m_s);
  return known;
}

}  // namespace

KnownCurrents known_currents(const ColumnData& column, const ForecastPlan& plan) {
  const Piece* leading = piece_of(column, plan.dataset);
  if (leading == nullptr) return {};
  Ingredients parts = ingredients_of(column, plan);
  KnownCurrents known;
  known.remarks = remarks_on(parts.instruments, plan.dataset, parts.behind.has_value());
  known.is_contradicted = std::any_of(
      parts.instruments.begin(), parts.instruments.end(), [&](const MooredInstrument& instrument) {
        return instrument.dataset == plan.dataset && instrument.is_rejected();
      });
  known.record = fused_record(std::move(parts), plan, is_series(leading));
  return known;
}

std::optional<TrustedCurrents> trusted_currents(const ColumnData& column, UtcDay day,
                                                UtcTime issued, UtcTime seen_by) {
  ForecastPlan plan;
  plan.day = day;
  plan.issued = issued;
  plan.seen_by = seen_by;
  VectorRecord trusted = column.current;
  while (true) {
    const auto dataset =
        leading_dataset(trusted, UtcTime(day), plan.end_of_day(), plan.knowledge());
    if (!dataset) return std::nullopt;
    plan.dataset = *dataset;
    KnownCurrents known = known_currents(column, plan);
    if (!known.is_contradicted) return TrustedCurrents{*dataset, std::move(known.record)};
    std::erase_if(trusted.pieces,
                  [&](const Piece& piece) { return piece.origin->dataset == *dataset; });
  }
}

bool is_of_a_forecast(const Chosen<Horizontal>& record, const VectorColumn& part) {
  std::size_t all = 0, of_runs = 0;
  for (std::size_t t = 0; t < std::min(record.column.times(), record.origin.size()); ++t) {
    const UtcTime time = record.column.time[t].centre();
    if (time < part.time.front().centre() || time > part.time.back().centre()) continue;
    ++all;
    of_runs += record.origin[t]->status == DataStatus::forecast ? 1U : 0U;
  }
  return 2 * of_runs > all;
}

}  // namespace slackwater::calibration
