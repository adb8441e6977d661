#include "fields/record/product_run.h"

#include <limits>
#include <map>

#include "fields/record/cadence.h"

namespace slackwater {
namespace {

constexpr double stated_height_m = 10.0;

template <typename T>
bool has_any(const Column<T>& column, std::size_t t) {
  for (std::size_t k = 0; k < column.levels(); ++k)
    if (column.has(t, k)) return true;
  return false;
}

/// The piece may take part as far as its kind goes.
bool is_let_in(const Origin& origin, const Choice& choice) {
  if (choice.dataset && origin.dataset != *choice.dataset) return false;
  if (choice.only_grids && origin.is_point_series) return false;
  if (choice.only_series && !origin.is_point_series) return false;
  return !choice.only_forecasts || origin.status == DataStatus::forecast;
}

/// A record as it was when `seen_by` was now, where that can be told.
class Archive {
 public:
  template <typename T>
  Archive(const Record<T>& record, UtcTime seen_by) : seen_by_(seen_by) {
    for (const PieceColumn<T>& piece : record.pieces) {
      if (piece.origin->received && *piece.origin->received <= seen_by) is_live_ = true;
    }
  }
  [[nodiscard]] bool shows(const Origin& origin) const {
    return !is_live_ || !origin.received || *origin.received <= seen_by_;
  }
  /// Whether the values may have been others then.
  [[nodiscard]] bool is_late(const Origin& origin) const {
    return origin.published ? *origin.published > seen_by_
                            : origin.received && *origin.received > seen_by_;
  }
  /// Larger counts, of values of one run at one time.
  [[nodiscard]] auto edition(const Origin& origin) const {
    const UtcTime published = origin.published.value_or(UtcTime::min());
    const bool is_published_later = origin.published && published > seen_by_;
    // Of what was published later the earliest is nearest to what stood there.
    const Duration age = published - UtcTime{};
    return std::tuple(!is_published_later, origin.published.has_value(),
                      is_published_later ? -age : age, origin.received.value_or(UtcTime::min()),
                      origin.granules.empty() ? 0 : origin.granules.front());
  }

 private:
  UtcTime seen_by_;
  bool is_live_ = false;
};

/// The dataset of the nearest point series with a known value; nothing where a dataset is asked for
/// or there is no series.
template <typename T>
std::optional<std::string> nearest_series(const Record<T>& record, const Knowledge& knowledge,
                                          const Archive& archive, const Choice& choice) {
  if (choice.dataset || choice.every_series) return std::nullopt;
  const PieceColumn<T>* nearest = nullptr;
  const auto place = [](const PieceColumn<T>& piece) {
    return std::tie(piece.distance_m, piece.origin->dataset);
  };
  for (const PieceColumn<T>& piece : record.pieces) {
    if (!piece.origin->is_point_series || !archive.shows(*piece.origin)) continue;
    if (nearest != nullptr && place(*nearest) <= place(piece)) continue;
    for (std::size_t t = 0; t < piece.column.times(); ++t) {
      if (!has_any(piece.column, t) || !is_known(*piece.origin, piece.column.time[t], knowledge))
        continue;
      nearest = &piece;
      break;
    }
  }
  if (nearest == nullptr) return std::nullopt;
  return nearest->origin->dataset;
}

/// What names a run while its pieces are gathered: a member of an ensemble by itself, and pieces on
/// other levels.
auto key_of(const Origin& origin, const std::vector<double>& levels_m) {
  const RunName name = run_name_of(origin);
  return std::tuple(name.dataset, name.is_forecast, name.reference_time, levels_m,
                    origin.ensemble_member);
}

/// One run of all pieces that share a key: the last edition speaks as long as it lasts.
template <typename T>
ProductRun<T> gathered(std::vector<const PieceColumn<T>*> pieces, const Knowledge& knowledge,
                       const Archive& archive) {
  std::stable_sort(pieces.begin(), pieces.end(), [&](const auto* a, const auto* b) {
    return archive.edition(*a->origin) > archive.edition(*b->origin);
  });
  ProductRun<T> run;
  TakenTime taken;
  for (const PieceColumn<T>* piece : pieces) {
    const Column<T>& column = piece->column;
    std::vector<UtcTime> centres;
    const std::size_t before = run.values.size();
    for (std::size_t t = 0; t < column.times(); ++t) {
      if (!is_known(*piece->origin, column.time[t], knowledge) || !has_any(column, t)) continue;
      centres.push_back(column.time[t].centre());
      if (taken.holds(centres.back())) {
        run.revised.push_back(centres.back());
      } else {
        run.values.push_back({column.time[t], piece, t});
      }
    }
    for (const TimeSpan& span : whole_parts(centres)) taken.take(span);
    if (run.values.size() > before && archive.is_late(*piece->origin)) run.may_be_revised = true;
  }
  std::sort(run.values.begin(), run.values.end(),
            [](const auto& a, const auto& b) { return a.cell.centre() < b.cell.centre(); });
  if (!run.values.empty()) run.first = run.values.front().piece;
  return run;
}

/// The mean of an ensemble's members, at the times and levels that all of them have.
template <typename T>
ProductRun<T> mean_of(const std::vector<ProductRun<T>>& members) {
  const ProductRun<T>& lowest = members.front();
  auto mean = std::make_unique<PieceColumn<T>>(*lowest.first);
  Column<T>& out = mean->column;
  out.time.clear();
  out.value.clear();
  out.status.clear();
  out.source.clear();
  std::vector<std::size_t> at(members.size(), 0);
  for (const RunValue<T>& value : lowest.values) {
    const UtcTime centre = value.cell.centre();
    std::vector<T> sum(out.levels(), T{});
    std::vector<bool> has(out.levels(), true);
    bool is_whole = true;
    for (std::size_t m = 0; m < members.size() && is_whole; ++m) {
      const auto& values = members[m].values;
      while (at[m] < values.size() && values[at[m]].cell.centre() < centre) ++at[m];
      is_whole = at[m] < values.size() && values[at[m]].cell == value.cell;
      if (!is_whole) break;
      const Column<T>& from = values[at[m]].piece->column;
      for (std::size_t k = 0; k < out.levels() && is_whole; ++k) {
        has[k] = has[k] && from.has(values[at[m]].t, k);
        if (has[k]) sum[k] += from.value[from.offset(values[at[m]].t, k)];
      }
    }
    if (!is_whole) continue;
    out.time.push_back(value.cell);
    out.source.push_back(value.piece->column.source[value.t]);
    for (std::size_t k = 0; k < out.levels(); ++k) {
      out.value.push_back(sum[k] / static_cast<double>(members.size()));
      out.status.push_back(has[k] ? SampleStatus::ok : SampleStatus::missing);
    }
  }
  ProductRun<T> run;
  run.members = members.size();
  run.mean = std::move(mean);
  run.first = run.mean.get();
  for (std::size_t t = 0; t < run.mean->column.times(); ++t) {
    if (has_any(run.mean->column, t))
      run.values.push_back({run.mean->column.time[t], run.mean.get(), t});
  }
  return run;
}

template <typename T>
std::vector<ProductRun<T>> runs_from(const Record<T>& record, const Knowledge& knowledge,
                                     const Choice& choice) {
  const Archive archive(record, knowledge.seen_by);
  const auto series = nearest_series(record, knowledge, archive, choice);
  std::map<decltype(key_of({}, {})), std::vector<const PieceColumn<T>*>> by_run;
  for (const PieceColumn<T>& piece : record.pieces) {
    const Origin& origin = *piece.origin;
    if (!is_let_in(origin, choice) || !archive.shows(origin)) continue;
    if (series && origin.is_point_series && origin.dataset != *series) continue;
    by_run[key_of(origin, piece.column.levels_m)].push_back(&piece);
  }
  std::vector<ProductRun<T>> runs;
  std::vector<ProductRun<T>> members;
  const auto settle_members = [&] {
    if (members.size() == 1) runs.push_back(std::move(members.front()));
    if (members.size() > 1) {
      ProductRun<T> mean = mean_of(members);
      if (!mean.values.empty()) runs.push_back(std::move(mean));
    }
    members.clear();
  };
  for (const auto& [key, pieces] : by_run) {
    ProductRun<T> run = gathered(pieces, knowledge, archive);
    if (run.values.empty()) continue;
    const bool is_sibling = !members.empty() &&
                            run_name_of(members.front().origin()) == run_name_of(run.origin()) &&
                            members.front().first->column.levels_m == run.first->column.levels_m;
    if (!is_sibling) settle_members();
    if (run.origin().ensemble_member == 0) {
      runs.push_back(std::move(run));
    } else {
      members.push_back(std::move(run));
    }
  }
  settle_members();
  return runs;
}

/// Only a product that is said to lack the tide stands behind for it.
bool lacks_tide(const Origin& origin) { return origin.rank.has_tide == false; }

/// Coarseness of a grid in steps of a fifth; what is not known counts as coarsest.
int coarseness(const Origin& origin) {
  if (origin.rank.spacing_deg <= 0) return 1000;
  return static_cast<int>(std::lround(4 * std::log2(origin.rank.spacing_deg)));
}

double height_off(const RunStanding& standing) {
  return standing.from_height_m ? std::abs(std::log(*standing.from_height_m / stated_height_m)) : 0;
}

/// Smaller counts first; the phrases beside name what each stands for.
auto order_of(const RunStanding& standing) {
  const Origin& origin = *standing.origin;
  const bool is_forecast = origin.status == DataStatus::forecast;
  const auto [tide, is_global, grid] = product_precedence(origin);
  const Duration::rep age = is_forecast && origin.reference_time
                                ? -origin.reference_time->time_since_epoch().count()
                                : std::numeric_limits<Duration::rep>::max();
  return std::tuple(is_forecast, is_in_situ(origin), tide, is_global, grid, age,
                    standing.is_mean_of_members, origin.ensemble_member, height_off(standing),
                    -static_cast<int>(standing.levels), origin.dataset);
}
constexpr const char* reasons[] = {"analysed",
                                   "a product, made for the place asked about",
                                   "not without the tide",
                                   "made for the region",
                                   "of finer grid",
                                   "of the newest run",
                                   "the control of its ensemble",
                                   "the control of its ensemble",
                                   "stated nearer to 10 m",
                                   "on more levels",
                                   "first by name"};

}  // namespace

RunName run_name_of(const Origin& origin) {
  const bool is_forecast = origin.status == DataStatus::forecast;
  return {origin.dataset, is_forecast, is_forecast ? origin.reference_time : std::nullopt};
}

std::vector<ProductRun<Horizontal>> runs_of(const VectorRecord& record, const Knowledge& knowledge,
                                            const Choice& choice) {
  return runs_from(record, knowledge, choice);
}

std::vector<ProductRun<double>> runs_of(const ScalarRecord& record, const Knowledge& knowledge,
                                        const Choice& choice) {
  return runs_from(record, knowledge, choice);
}

VectorColumn column_of(const ProductRun<Horizontal>& run) {
  VectorColumn column;
  const VectorColumn& pattern = run.first->column;
  column.point = pattern.point;
  column.vertical = pattern.vertical;
  column.levels_m = pattern.levels_m;
  for (const RunValue<Horizontal>& value : run.values) {
    const VectorColumn& from = value.piece->column;
    column.time.push_back(value.cell);
    column.source.push_back(from.source[value.t]);
    for (std::size_t k = 0; k < from.levels(); ++k) {
      column.value.push_back(from.value[from.offset(value.t, k)]);
      column.status.push_back(from.status[from.offset(value.t, k)]);
    }
  }
  return column;
}

std::tuple<bool, bool, int> product_precedence(const Origin& origin) {
  return {lacks_tide(origin), !origin.rank.is_regional, coarseness(origin)};
}

bool counts_before(const RunStanding& one, const RunStanding& other) {
  return order_of(one) < order_of(other);
}

std::string reason_before(const RunStanding& one, const RunStanding& other) {
  const auto a = order_of(one);
  const auto b = order_of(other);
  std::size_t first = std::size(reasons) - 1;
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (void)((std::get<i>(a) != std::get<i>(b) && (first = i, true)) || ...);
  }
  (std::make_index_sequence<std::size(reasons)>{});
  return reasons[first];
}

}  // namespace slackwater
