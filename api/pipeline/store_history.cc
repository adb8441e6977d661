#include "api/pipeline/store_history.h"

#include <optional>

#include "api/pipeline/load_site_data.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/record/choose.h"
#include "ingest/history/offer.h"

namespace slackwater::api {
namespace {

constexpr double missing = constants::nan;

/// Values at one level, NaN where there is none, or only a forecast.
template <typename T>
struct Level {
  std::vector<UtcTime> time;
  std::vector<std::optional<T>> value;
};

bool is_past(DataStatus source) {
  return source == DataStatus::analysis || source == DataStatus::observation;
}

template <typename T>
Level<T> level_of(const Column<T>& column, const std::vector<double>& weight) {
  Level<T> level;
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (!is_past(column.source[t])) continue;
    T sum{};
    bool has_all = true;
    for (std::size_t k = 0; k < column.levels(); ++k) {
      if (weight[k] == 0) continue;
      has_all = has_all && column.has(t, k);
      if (has_all) sum += weight[k] * column.value[column.offset(t, k)];
    }
    level.time.push_back(column.time[t].start);
    level.value.push_back(has_all ? std::optional<T>(sum) : std::nullopt);
  }
  return level;
}

/// How much each level counts at a depth; above the first level the first, as elsewhere.
std::vector<double> weights_at(const std::vector<double>& levels_m, std::optional<double> depth_m) {
  if (levels_m.size() < 2) return {1.0};
  if (!depth_m)
    throw Error(ErrorKind::invalid_input,
                formatted("found currents at {} levels, from {:g} to {:g} m; say which with "
                          "--depth METRES",
                          levels_m.size(), levels_m.front(), levels_m.back()));
  std::vector<double> weight(levels_m.size(), 0);
  if (*depth_m <= levels_m.front()) {
    weight.front() = 1;
    return weight;
  }
  for (std::size_t k = 0; k + 1 < levels_m.size(); ++k) {
    if (*depth_m > levels_m[k + 1]) continue;
    const double share = (*depth_m - levels_m[k]) / (levels_m[k + 1] - levels_m[k]);
    weight[k] = 1 - share;
    weight[k + 1] = share;
    return weight;
  }
  throw Error(ErrorKind::invalid_input,
              formatted("found --depth {:g}, expected at most {:g} m, the deepest level stored",
                        *depth_m, levels_m.back()));
}

/// What is made of the components of a vector; nothing for a component itself.
std::optional<ingest::VectorPart> part_named(const std::string& name) {
  if (name.ends_with("_speed")) return ingest::VectorPart::speed;
  if (name.ends_with("_from_direction")) return ingest::VectorPart::from_direction;
  if (name.ends_with("_to_direction")) return ingest::VectorPart::to_direction;
  return std::nullopt;
}

class StoreHistory {
 public:
  StoreHistory(const SiteData& data, std::optional<double> depth_m,
               const ingest::Vocabulary& vocabulary)
      : column_(data.columns.front()),
        source_("the store at site " + data.site.id),
        depth_m_(depth_m),
        vocabulary_(vocabulary) {}

  [[nodiscard]] std::vector<std::string> offered() const {
    std::vector<std::string> names;
    for (const char* name :
         {"sea_surface_wave_significant_height",
          "sea_surface_wave_period_at_variance_spectral_density_maximum",
          "sea_surface_wave_from_direction", "wind_speed", "wind_from_direction", "eastward_wind",
          "northward_wind", "sea_water_speed", "sea_water_velocity_to_direction",
          "eastward_sea_water_velocity", "northward_sea_water_velocity"}) {
      if (is_stored(name)) names.emplace_back(name);
    }
    return names;
  }

  [[nodiscard]] std::optional<HistorySeries> series(const std::string& name) const {
    if (!is_stored(name)) return std::nullopt;
    HistorySeries series;
    series.name = name;
    series.standard_name = name;
    series.source = source_;
    series.unit = vocabulary_.by_standard_name(name)->unit;
    series.is_single_precision = true;
    if (const ScalarRecord* record = scalar(name)) {
      // Period and direction are those of the run whose height it is.
      const Chosen<double> height = choose(column_.significant_height, {}, {});
      Choice choice;
      if (!height.empty()) choice.like = &height.stretches;
      const auto level = level_of(choose(*record, {}, choice).column, {1.0});
      series.time = level.time;
      for (const auto& value : level.value) series.value.push_back(value.value_or(missing));
    } else {
      const auto column = choose(*vector(name), {}, {}).column;
      const auto level = level_of(column, weights_at(column.levels_m, depth_m_));
      series.time = level.time;
      for (const auto& value : level.value) {
        if (!value)
          series.value.push_back(missing);
        else if (const auto part = part_named(name))
          series.value.push_back(
              static_cast<float>(ingest::part_of(*part, value->real(), value->imag())));
        else
          series.value.push_back(name.starts_with("east") ? value->real() : value->imag());
      }
    }
    return series;
  }

 private:
  [[nodiscard]] const ScalarRecord* scalar(const std::string& name) const {
    if (name == "sea_surface_wave_significant_height") return &column_.significant_height;
    if (name == "sea_surface_wave_period_at_variance_spectral_density_maximum")
      return &column_.peak_period;
    if (name == "sea_surface_wave_from_direction") return &column_.wave_direction;
    return nullptr;
  }
  [[nodiscard]] const VectorRecord* vector(const std::string& name) const {
    if (name == "wind_speed" || name == "wind_from_direction" || name.ends_with("ward_wind"))
      return &column_.wind;
    if (name == "sea_water_speed" || name == "sea_water_velocity_to_direction" ||
        name.ends_with("ward_sea_water_velocity"))
      return &column_.current;
    return nullptr;
  }
  [[nodiscard]] bool is_stored(const std::string& name) const {
    const ScalarRecord* one = scalar(name);
    if (one != nullptr) return !one->pieces.empty();
    const VectorRecord* two = vector(name);
    return two != nullptr && !two->pieces.empty();
  }

  const ColumnData& column_;
  std::string source_;
  std::optional<double> depth_m_;
  const ingest::Vocabulary& vocabulary_;
};

}  // namespace

ingest::HistoryOfFile read_store_history(store::Store& store, const Site& site,
                                         const std::vector<std::string>& wanted,
                                         std::optional<double> depth_m,
                                         const ingest::Vocabulary& vocabulary) {
  Site point = site;
  point.columns.clear();
  point.column_block.reset();
  static const UtcTime earliest = parse_utc("1600-01-01T00:00:00Z");
  static const UtcTime latest = parse_utc("2500-01-01T00:00:00Z");
  const SiteData data = load_site_data(store, point, earliest, latest);
  const StoreHistory history(data, depth_m, vocabulary);
  ingest::HistoryOfFile answer;
  answer.offered = history.offered();
  if (!data.damage.empty()) answer.warnings.push_back(data.damage);
  for (const std::string& name : wanted)
    answer.series.push_back(history.series(ingest::current_name(name, vocabulary)));
  return answer;
}

}  // namespace slackwater::api
