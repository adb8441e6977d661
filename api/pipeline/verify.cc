#include "api/pipeline/verify.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "api/pipeline/daily_job.h"
#include "api/pipeline/skill_pairs.h"
#include "fields/base/error.h"
#include "fields/base/random.h"
#include "fields/interpolate/temporal.h"
#include "ingest/cf/forecast_file.h"

namespace slackwater::api {
namespace {

using std::chrono::days;
using std::chrono::hours;

constexpr double whole_column_m = 1e5;

/// The whole column and the bands that operators speak of.
std::vector<DepthBand> bands_or_default(const VerifyOptions& options) {
  if (!options.bands.empty()) return options.bands;
  return {{0, whole_column_m}, {0, 5}, {5, 20}, {20, 50}, {50, whole_column_m}};
}

void append(Pairs& all, const Pairs& more) {
  const auto join = [](auto& a, const auto& b) { a.insert(a.end(), b.begin(), b.end()); };
  join(all.forecast, more.forecast);
  join(all.truth, more.truth);
  join(all.sigma_m_s, more.sigma_m_s);
  join(all.depth_m, more.depth_m);
  join(all.lead_h, more.lead_h);
  join(all.block, more.block);
}

/// The pairs of one band and lead bin; a shallow column's own depth ends the bands.
Pairs select(const Pairs& pairs, const DepthBand& band, const LeadBin& lead) {
  Pairs part;
  for (std::size_t i = 0; i < pairs.truth.size(); ++i) {
    if (pairs.depth_m[i] < band.from_m || pairs.depth_m[i] > band.to_m) continue;
    if (!(pairs.lead_h[i] > lead.from_h && pairs.lead_h[i] <= lead.to_h)) continue;
    part.forecast.push_back(pairs.forecast[i]);
    part.truth.push_back(pairs.truth[i]);
    if (!pairs.sigma_m_s.empty()) part.sigma_m_s.push_back(pairs.sigma_m_s[i]);
    part.depth_m.push_back(pairs.depth_m[i]);
    part.lead_h.push_back(pairs.lead_h[i]);
    part.block.push_back(pairs.block[i]);
  }
  return part;
}

std::optional<calibration::Interval95> interval_of(const Pairs& pairs, UtcDay day) {
  std::vector<double> squared;
  for (std::size_t i = 0; i < pairs.truth.size(); ++i)
    squared.push_back(std::norm(pairs.forecast[i] - pairs.truth[i]));
  Rng random(static_cast<std::uint64_t>(day.time_since_epoch().count()), "verify/bootstrap");
  // Many columns make the sums long; fewer draws then say the same.
  const int draws = squared.size() > 20000 ? 200 : 1000;
  return calibration::bootstrap_rmse(squared, pairs.block, random, draws);
}

class Scorer {
 public:
  Scorer(const Snapshot& snapshot, const VerifyOptions& options)
      : snapshot_(snapshot), options_(options) {}

  void currents(const std::map<std::string, Pairs>& methods, std::optional<std::size_t> column,
                const std::string& truth) {
    for (const DepthBand& band : bands_or_default(options_)) {
      for (const LeadBin& lead : options_.leads) {
        for (const auto& [method, pairs] : methods) {
          const Pairs part = select(pairs, band, lead);
          if (part.truth.empty()) continue;
          SkillEntry entry = blank("sea_water_velocity", method, lead, truth);
          entry.column = column;
          entry.band = band;
          entry.vector = calibration::score_vectors(part.forecast, part.truth, part.sigma_m_s);
          if (!column) entry.interval = interval_of(part, snapshot_.day);
          entries_.push_back(std::move(entry));
        }
      }
    }
  }

  void wind(const Pairs& pairs, const std::string& truth) {
    for (const LeadBin& lead : options_.leads) {
      const Pairs part = select(pairs, {0, 0}, lead);
      if (part.truth.empty()) continue;
      SkillEntry entry = blank("wind", "forecast", lead, truth);
      entry.vector = calibration::score_vectors(part.forecast, part.truth, {});
      entry.interval = interval_of(part, snapshot_.day);
      entries_.push_back(std::move(entry));
    }
  }

  /// Scalar pairs travel as vectors with a zero north component.
  void waves(const std::map<std::string, Pairs>& methods, const std::string& truth) {
    for (const LeadBin& lead : options_.leads) {
      for (const auto& [method, pairs] : methods) {
        const Pairs part = select(pairs, {0, 0}, lead);
        if (part.truth.empty()) continue;
        std::vector<double> forecast;
        std::vector<double> found;
        for (std::size_t i = 0; i < part.truth.size(); ++i) {
          forecast.push_back(part.forecast[i].real());
          found.push_back(part.truth[i].real());
        }
        SkillEntry entry = blank("sea_surface_wave_significant_height", method, lead, truth);
        entry.scalar = calibration::score_scalars(forecast, found);
        entry.interval = interval_of(part, snapshot_.day);
        entries_.push_back(std::move(entry));
      }
    }
  }

  std::vector<SkillEntry> take() { return std::move(entries_); }

 private:
  SkillEntry blank(const std::string& variable, const std::string& method, const LeadBin& lead,
                   const std::string& truth) const {
    SkillEntry entry;
    entry.variable = variable;
    entry.site = snapshot_.site_id;
    entry.day = snapshot_.day;
    entry.issued = snapshot_.issued;
    entry.wind = snapshot_.wind_policy;
    entry.lead = lead;
    entry.method = method;
    entry.truth = truth;
    return entry;
  }

  const Snapshot& snapshot_;
  const VerifyOptions& options_;
  std::vector<SkillEntry> entries_;
};

void add_surface_pair(Pairs& pairs, Horizontal forecast, Horizontal truth, UtcTime time,
                      UtcTime end) {
  pairs.forecast.push_back(forecast);
  pairs.truth.push_back(truth);
  pairs.depth_m.push_back(0);
  pairs.lead_h.push_back(hours_between(end, time));
  pairs.block.push_back(static_cast<std::size_t>(time.time_since_epoch() / hours(6)));
}

/// A moored instrument where there is one, else the analysed product; never a forecast.
template <typename T>
Chosen<T> surface_truth(const Record<T>& record) {
  Record<T> known;
  for (const auto& piece : record.pieces) {
    if (piece.origin->status != DataStatus::forecast) known.pieces.push_back(piece);
  }
  Choice series;
  series.only_series = true;
  Chosen<T> chosen = choose(known, {}, series);
  if (!chosen.empty()) return chosen;
  Choice grids;
  grids.only_grids = true;
  return choose(known, {}, grids);
}

std::string truth_name(const Origin& origin) {
  return origin.is_point_series ? "station " + origin.station : origin.product_id;
}

/// Whether a forecast's value at a time is the later analysis itself (`--wind best` over the past): held against the
/// same analysis it would score nothing but its own copy.
bool is_its_own_truth(const Snapshot& snapshot, const std::vector<DataStatus>& source, UtcTime time,
                      const Origin& truth) {
  if (truth.is_point_series) return false;
  const auto place = place_in(snapshot.time, time);
  return place && place->low < source.size() && source[place->low] == DataStatus::analysis;
}

void score_wind(Scorer& scorer, const ColumnData& data, const Snapshot& snapshot, UtcTime end) {
  const ForecastColumn& column = snapshot.columns.front();
  if (column.wind_m_s.empty()) return;
  const Chosen<Horizontal> truth = surface_truth(data.wind);
  Pairs pairs;
  for (std::size_t t = 0; t < truth.column.times(); ++t) {
    const UtcTime time = truth.column.time[t].centre();
    if (time <= end || !truth.column.has(t)) continue;
    if (is_its_own_truth(snapshot, column.wind_source, time, *truth.origin[t])) continue;
    const auto forecast = mean_over(snapshot.time, column.wind_m_s, 1, 0, TimeCell::instant(time));
    if (forecast) add_surface_pair(pairs, *forecast, truth.column.value[t], time, end);
  }
  if (!pairs.truth.empty()) scorer.wind(pairs, truth_name(*truth.origin.back()));
}

void score_waves(Scorer& scorer, const ColumnData& data, const Snapshot& snapshot, UtcTime end) {
  const ForecastColumn& column = snapshot.columns.front();
  if (column.sea.empty()) return;
  const Chosen<double> truth = surface_truth(data.significant_height);
  std::vector<Horizontal> height;
  for (const SeaState& sea : column.sea) height.emplace_back(sea.significant_height_m, 0);
  // Persistence of waves: the last value that was known at the end of D.
  std::optional<double> last;
  std::map<std::string, Pairs> methods;
  for (std::size_t t = 0; t < truth.column.times(); ++t) {
    if (!truth.column.has(t)) continue;
    const UtcTime time = truth.column.time[t].centre();
    const double value = truth.column.value[t];
    if (time <= end) {
      last = value;
      continue;
    }
    if (is_its_own_truth(snapshot, column.sea_source, time, *truth.origin[t])) continue;
    const auto forecast = mean_over(snapshot.time, height, 1, 0, TimeCell::instant(time));
    if (!forecast || std::isnan(forecast->real())) continue;
    add_surface_pair(methods["forecast"], *forecast, value, time, end);
    if (last) add_surface_pair(methods["persistence"], *last, value, time, end);
  }
  if (!methods.empty()) scorer.waves(methods, truth_name(*truth.origin.back()));
}

std::string dataset_of_summary(const std::string& summary_json) {
  const auto summary = nlohmann::json::parse(summary_json, nullptr, false);
  if (summary.is_discarded() || !summary.contains("dataset")) return {};
  return summary["dataset"].get<std::string>();
}

}  // namespace

std::vector<SkillEntry> score_forecast(const SiteData& data, const Snapshot& snapshot,
                                       const std::string& dataset, const VerifyOptions& options) {
  Scorer scorer(snapshot, options);
  ForecastPlan plan;
  plan.day = snapshot.day;
  plan.issued = snapshot.issued;
  plan.wind = wind_policy_from(snapshot.wind_policy);
  plan.dataset = dataset;
  const UtcTime end = plan.end_of_day();
  const UtcTime until = snapshot.time.back();

  std::map<std::string, Pairs> pooled;
  std::string truth_label;
  for (std::size_t i = 0; i < snapshot.columns.size(); ++i) {
    const auto column = std::find_if(
        data.columns.begin(), data.columns.end(),
        [&](const ColumnData& c) { return distance_m(c.point, snapshot.columns[i].point) < 50.0; });
    if (column == data.columns.end() || dataset.empty()) continue;
    const Chosen<Horizontal> truth = truth_of(*column, dataset, end, until);
    if (truth.empty()) continue;
    truth_label = truth_name(*truth.origin.back());
    const auto methods = current_pairs(*column, plan, snapshot, i, truth);
    for (const auto& [method, pairs] : methods) append(pooled[method], pairs);
    if (options.per_column && snapshot.columns.size() > 1) scorer.currents(methods, i, truth_label);
  }
  scorer.currents(pooled, std::nullopt, truth_label);
  if (!data.columns.empty()) {
    score_wind(scorer, data.columns.front(), snapshot, end);
    score_waves(scorer, data.columns.front(), snapshot, end);
  }
  return scorer.take();
}

namespace {

/// The last issued of each day and wind policy, in order of day.
std::vector<store::ForecastRow> forecasts_to_score(store::Store& store, const Site& site,
                                                   const VerifyOptions& options) {
  store::ForecastQuery query;
  query.site_id = site.id;
  query.from_day = options.from;
  query.to_day = options.to;
  std::map<std::pair<UtcDay, std::string>, store::ForecastRow> last;
  for (store::ForecastRow& row : store.find_forecasts(query)) {
    last.insert_or_assign({row.day, row.wind_policy}, std::move(row));
  }
  std::vector<store::ForecastRow> rows;
  for (auto& [key, row] : last) rows.push_back(std::move(row));
  return rows;
}

std::vector<SkillEntry> score_all(const store::Store& store,
                                  const std::vector<store::ForecastRow>& rows, const SiteData& data,
                                  const VerifyOptions& options) {
  std::vector<SkillEntry> entries;
  for (const store::ForecastRow& row : rows) {
    const Snapshot snapshot = ingest::read_forecast(store.content_path(row.content_sha256));
    auto scored = score_forecast(data, snapshot, dataset_of_summary(row.summary_json), options);
    entries.insert(entries.end(), std::make_move_iterator(scored.begin()),
                   std::make_move_iterator(scored.end()));
  }
  return entries;
}

}  // namespace

std::vector<SkillEntry> verify_with(store::Store& store, const Site& site, const SiteData& data,
                                    const VerifyOptions& options) {
  return score_all(store, forecasts_to_score(store, site, options), data, options);
}

std::vector<SkillEntry> verify(store::Store& store, const Site& site,
                               const VerifyOptions& options) {
  const std::vector<store::ForecastRow> rows = forecasts_to_score(store, site, options);
  if (rows.empty()) {
    throw Error(ErrorKind::not_found,
                "found no issued forecast for site " + site.id +
                    " in this range; run `slackwater forecast` or `slackwater hindcast` first");
  }
  UtcTime to = UtcTime::min();
  for (const store::ForecastRow& row : rows) to = std::max(to, row.valid_to);
  const SiteData data = load_site_data(store, site, UtcTime(rows.front().day) - history_read, to);
  return score_all(store, rows, data, options);
}

std::vector<DepthBand> parse_bands(const std::string& text) {
  std::vector<double> edges;
  std::istringstream stream(text);
  std::string part;
  const auto refuse = [&] {
    return Error(ErrorKind::usage,
                 "found bands '" + text +
                     "', expected ascending depths in metres such as 0,150 or 0,5,20,50");
  };
  while (std::getline(stream, part, ',')) {
    std::size_t used = 0;
    try {
      edges.push_back(std::stod(part, &used));
    } catch (const std::exception&) {
      throw refuse();
    }
    if (used != part.size() || !(edges.back() >= 0 && edges.back() <= whole_column_m))
      throw refuse();
    if (edges.size() > 1 && !(edges.back() > edges[edges.size() - 2])) throw refuse();
  }
  if (edges.size() < 2) throw refuse();
  std::vector<DepthBand> bands;
  for (std::size_t i = 1; i < edges.size(); ++i) bands.push_back({edges[i - 1], edges[i]});
  return bands;
}

}  // namespace slackwater::api
