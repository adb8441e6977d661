#include "tests/support/known_series_for_tests.h"

#include <cmath>

namespace slackwater::tests {
namespace {

constexpr Horizontal absurd_m_s(7.0, -9.0);
constexpr double absurd = 13.0;

SampleStatus status_of(Horizontal value) {
  return std::isnan(value.real()) ? SampleStatus::missing : SampleStatus::ok;
}

void make_absurd(Horizontal& value) { value += absurd_m_s; }
void make_absurd(double& value) { value += absurd; }

/// @param which  (origin, cell) -> whether the values of the cell are to be spoilt
template <typename T, typename Which>
void spoil(Record<T>& record, Which which) {
  for (PieceColumn<T>& piece : record.pieces) {
    Column<T>& column = piece.column;
    for (std::size_t t = 0; t < column.times(); ++t) {
      if (!which(*piece.origin, column.time[t])) continue;
      for (std::size_t k = 0; k < column.levels(); ++k)
        make_absurd(column.value[column.offset(t, k)]);
    }
  }
}

template <typename Which>
void spoil(ColumnData& data, Which which) {
  spoil(data.current, which);
  spoil(data.wind, which);
  spoil(data.nearest_wind, which);
  spoil(data.mixed_layer_depth, which);
  spoil(data.temperature, which);
  spoil(data.significant_height, which);
  spoil(data.peak_period, which);
  spoil(data.wave_direction, which);
  spoil(data.sea_level, which);
}

}  // namespace

FlowForTests steady(Horizontal value) {
  return [value](UtcTime, double) { return value; };
}

Origin analysis_of(const std::string& dataset, std::int64_t granule) {
  Origin origin;
  origin.granules = {granule};
  origin.dataset = dataset;
  origin.product_id = dataset;
  return origin;
}

Origin forecast_of(const std::string& dataset, UtcTime issued, std::int64_t granule) {
  Origin origin = analysis_of(dataset, granule);
  origin.status = DataStatus::forecast;
  origin.reference_time = issued;
  return origin;
}

Origin station_of(const std::string& name, std::int64_t granule) {
  Origin origin = analysis_of(name, granule);
  origin.status = DataStatus::observation;
  origin.station = name;
  origin.is_point_series = true;
  return origin;
}

std::vector<TimeCell> instants(UtcTime from, UtcTime to, Duration step) {
  std::vector<TimeCell> cells;
  for (UtcTime time = from; time <= to; time += step) cells.push_back(TimeCell::instant(time));
  return cells;
}

std::vector<TimeCell> means(UtcTime from, UtcTime to, Duration step) {
  std::vector<TimeCell> cells;
  for (UtcTime time = from; time + step <= to; time += step) cells.push_back({time, time + step});
  return cells;
}

PieceColumn<Horizontal> vector_piece(const Origin& origin, const std::vector<TimeCell>& time,
                                     const std::vector<double>& depth_m, const FlowForTests& flow,
                                     double distance_m) {
  VectorColumn column;
  column.point = GeoPoint::from_degrees(54.0, 6.5);
  column.time = time;
  column.vertical = depth_m.empty() ? VerticalKind::none : VerticalKind::depth_m;
  column.levels_m = depth_m;
  column.source.assign(time.size(), origin.status);
  for (const TimeCell& cell : time) {
    for (std::size_t k = 0; k < column.levels(); ++k) {
      const Horizontal value = flow(cell.centre(), depth_m.empty() ? 0.0 : depth_m[k]);
      column.status.push_back(status_of(value));
      column.value.push_back(has_value(column.status.back()) ? value : Horizontal{});
    }
  }
  return {&origin, std::move(column), distance_m};
}

PieceColumn<double> scalar_piece(const Origin& origin, const std::vector<TimeCell>& time,
                                 const LevelForTests& level) {
  ScalarColumn column;
  column.point = GeoPoint::from_degrees(54.0, 6.5);
  column.time = time;
  column.source.assign(time.size(), origin.status);
  for (const TimeCell& cell : time) {
    column.value.push_back(level(cell.centre()));
    column.status.push_back(std::isnan(column.value.back()) ? SampleStatus::missing
                                                            : SampleStatus::ok);
  }
  return {&origin, std::move(column), 0};
}

KnownSeriesForTests::KnownSeriesForTests() {
  data.point = GeoPoint::from_degrees(54.0, 6.5);
  data.water_depth = {30.0, "site"};
}

const Origin& KnownSeriesForTests::kept(const Origin& origin) {
  return origins_.emplace_back(origin);
}

void KnownSeriesForTests::current(const Origin& origin, const std::vector<TimeCell>& time,
                                  const std::vector<double>& depth_m, const FlowForTests& flow,
                                  double distance_m) {
  data.current.pieces.push_back(vector_piece(kept(origin), time, depth_m, flow, distance_m));
}

void KnownSeriesForTests::wind(const Origin& origin, const std::vector<TimeCell>& time,
                               const FlowForTests& flow) {
  data.wind.pieces.push_back(vector_piece(kept(origin), time, {}, flow));
  data.nearest_wind = data.wind;
}

void KnownSeriesForTests::waves(const Origin& origin, const std::vector<TimeCell>& time,
                                const LevelForTests& height_m, const LevelForTests& period_s,
                                const LevelForTests& from_direction_deg) {
  const Origin& from = kept(origin);
  data.significant_height.pieces.push_back(scalar_piece(from, time, height_m));
  data.peak_period.pieces.push_back(scalar_piece(from, time, period_s));
  data.wave_direction.pieces.push_back(scalar_piece(from, time, from_direction_deg));
}

void KnownSeriesForTests::sea_level(const Origin& origin, const std::vector<TimeCell>& time,
                                    const LevelForTests& level_m) {
  data.sea_level.pieces.push_back(scalar_piece(kept(origin), time, level_m));
}

SiteData site_of(std::vector<ColumnData> columns) {
  SiteData site;
  site.site.id = "made-up";
  site.site.name = "Made up";
  site.site.point = columns.front().point;
  site.columns = std::move(columns);
  return site;
}

void spoil_after(ColumnData& data, UtcTime time, UtcTime issued_by) {
  spoil(data, [&](const Origin& origin, const TimeCell& cell) {
    return origin.reference_time ? *origin.reference_time > issued_by : cell.end > time;
  });
}

void spoil_all_after(ColumnData& data, UtcTime time) {
  spoil(data, [&](const Origin&, const TimeCell& cell) { return cell.end > time; });
}

void turn(VectorRecord& record, Horizontal by) {
  for (auto& piece : record.pieces)
    for (Horizontal& value : piece.column.value) value *= by;
}

}  // namespace slackwater::tests
