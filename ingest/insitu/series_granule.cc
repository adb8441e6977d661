#include "ingest/insitu/series_granule.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields/base/error.h"

namespace slackwater::ingest {
namespace {

/// At which times a series has a record: a value, or one that was rejected.
std::vector<bool> records_of(const SeriesValues& series) {
  std::vector<bool> records(series.times, false);
  for (std::size_t t = 0; t < series.times; ++t) {
    for (std::size_t k = 0; k < series.levels; ++k) {
      if (series.status[series.at(t, k)] != SampleStatus::missing) records[t] = true;
    }
  }
  return records;
}

std::size_t count(const std::vector<bool>& marks) {
  return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), true));
}

/// A group while it is being filled.
struct Gathering {
  SeriesLevels levels;
  std::vector<bool> records;
  std::vector<const SeriesValues*> series;

  [[nodiscard]] bool takes(const PlacedSeries& placed, const std::vector<bool>& its_records) const {
    if (placed.levels.kind != levels.kind || placed.levels.levels_m != levels.levels_m)
      return false;
    std::size_t common = 0;
    for (std::size_t t = 0; t < records.size(); ++t) common += records[t] && its_records[t] ? 1 : 0;
    return 2 * common >= std::min(count(records), count(its_records));
  }
};

SeriesValues cut_to(const SeriesValues& series, const std::vector<std::size_t>& times) {
  SeriesValues out = series;
  out.times = times.size();
  out.values.clear();
  out.status.clear();
  for (const std::size_t t : times) {
    for (std::size_t k = 0; k < series.levels; ++k) {
      out.values.push_back(series.values[series.at(t, k)]);
      out.status.push_back(series.status[series.at(t, k)]);
    }
  }
  return out;
}

void keep_levels(SeriesGroup& group, const std::vector<std::size_t>& order) {
  for (SeriesValues& series : group.series) {
    SeriesValues kept = series;
    kept.levels = order.size();
    kept.values.clear();
    kept.status.clear();
    for (std::size_t t = 0; t < series.times; ++t) {
      for (const std::size_t k : order) {
        kept.values.push_back(series.values[series.at(t, k)]);
        kept.status.push_back(series.status[series.at(t, k)]);
      }
    }
    series = std::move(kept);
  }
  std::vector<double> levels;
  levels.reserve(order.size());
  for (const std::size_t k : order) levels.push_back(group.levels.levels_m[k]);
  group.levels.levels_m = std::move(levels);
  group.levels.side_lobe.clear();
}

std::string rounded(double metres) {
  std::string text = std::to_string(std::round(metres * 10.0) / 10.0);
  return text.substr(0, text.find('.') + 2);
}

}  // namespace

std::vector<SeriesGroup> group_series(const std::vector<PlacedSeries>& placed,
                                      const SeriesTimes& times) {
  std::vector<Gathering> gatherings;
  for (const PlacedSeries& one : placed) {
    std::vector<bool> records = records_of(one.series);
    for (std::size_t t = 0; t < records.size(); ++t) records[t] = records[t] && times.usable[t];
    if (count(records) == 0) continue;
    const auto home =
        std::find_if(gatherings.begin(), gatherings.end(),
                     [&](const Gathering& gathering) { return gathering.takes(one, records); });
    if (home == gatherings.end()) {
      gatherings.push_back({one.levels, std::move(records), {&one.series}});
      continue;
    }
    home->series.push_back(&one.series);
    for (std::size_t t = 0; t < records.size(); ++t)
      home->records[t] = home->records[t] || records[t];
  }

  std::vector<SeriesGroup> groups;
  for (const Gathering& gathering : gatherings) {
    std::vector<std::size_t> kept;
    SeriesGroup group;
    group.levels = gathering.levels;
    for (std::size_t t = 0; t < gathering.records.size(); ++t) {
      if (!gathering.records[t]) continue;
      kept.push_back(t);
      group.times.push_back(times.cells[t]);
    }
    for (const SeriesValues* series : gathering.series)
      group.series.push_back(cut_to(*series, kept));
    groups.push_back(std::move(group));
  }
  return groups;
}

void reject_side_lobes(SeriesGroup& group, std::vector<std::string>& warnings) {
  if (group.levels.side_lobe.empty()) return;
  std::size_t rejected = 0;
  for (std::size_t k = 0; k < group.levels.side_lobe.size(); ++k) {
    if (!group.levels.side_lobe[k]) continue;
    bool any = false;
    for (SeriesValues& series : group.series) {
      for (std::size_t t = 0; t < series.times; ++t) {
        SampleStatus& status = series.status[series.at(t, k)];
        if (status != SampleStatus::not_checked) continue;
        status = SampleStatus::suspect;
        any = true;
      }
    }
    rejected += any ? 1 : 0;
  }
  if (rejected > 0) {
    warnings.push_back("rejected " + std::to_string(rejected) +
                       " bins within reach of the side lobes or beyond the bed or the surface");
  }
}

void keep_useful_levels(SeriesGroup& group, const std::optional<double>& water_depth_m,
                        std::vector<std::string>& warnings) {
  if (group.levels.kind == VerticalKind::none) return;
  const bool depths = group.levels.kind == VerticalKind::depth_m;
  std::vector<std::size_t> order;
  std::string dropped;
  for (std::size_t k = 0; k < group.levels.levels_m.size(); ++k) {
    const double level = group.levels.levels_m[k];
    const bool in_water =
        depths ? level >= 0.0 && level <= water_depth_m.value_or(12000.0) : std::isfinite(level);
    bool accepted = false;
    for (const SeriesValues& series : group.series) {
      for (std::size_t t = 0; t < series.times && !accepted; ++t)
        accepted = has_value(series.status[series.at(t, k)]);
    }
    if (in_water && accepted) {
      order.push_back(k);
    } else {
      dropped += (dropped.empty() ? "" : ", ") + rounded(level);
    }
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return group.levels.levels_m[a] < group.levels.levels_m[b];
  });
  const auto twice =
      std::adjacent_find(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return group.levels.levels_m[a] == group.levels.levels_m[b];
      });
  if (twice != order.end()) {
    throw Error(ErrorKind::invalid_input,
                "two levels at " + rounded(group.levels.levels_m[*twice]) +
                    " m; expected levels that differ; correct the depths or heights");
  }
  if (!dropped.empty()) {
    warnings.push_back("left out " + std::to_string(group.levels.levels_m.size() - order.size()) +
                       " of " + std::to_string(group.levels.levels_m.size()) +
                       " levels, out of the water or without an accepted value: " + dropped + " m");
  }
  keep_levels(group, order);
}

}  // namespace slackwater::ingest
