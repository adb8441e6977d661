#include "fields/record/choose.h"

#include <algorithm>
#include <cmath>

#include "fields/record/cadence.h"
#include "fields/record/join.h"
#include "fields/record/product_run.h"
#include "fields/record/run_steps.h"

namespace slackwater {
namespace {

/// How near a run of another quantity is to this one: 0 of the same dataset, 1 of the same product
/// and grid, where datasets hold a quantity each, 2 of another.
int unlikeness(const Origin& one, const Origin& other, bool are_means) {
  const RunName a = run_name_of(one);
  const RunName b = run_name_of(other);
  if (a == b && (are_means || one.ensemble_member == other.ensemble_member)) return 0;
  const bool is_as_old = a.is_forecast == b.is_forecast && a.reference_time == b.reference_time;
  const bool is_of_product =
      one.is_of_named_product && one.product_id == other.product_id && one.station == other.station;
  const bool is_as_fine =
      std::abs(one.rank.spacing_deg - other.rank.spacing_deg) <= 0.01 * other.rank.spacing_deg;
  return is_as_old && is_of_product && is_as_fine && a.dataset != b.dataset ? 1 : 2;
}

/// The values of a run that lie in time that nobody has taken, in parts that hang together.
template <typename T>
std::vector<Part<T>> parts_left(const ProductRun<T>& run, std::size_t rank, const TakenTime& taken,
                                const FilledPauses& filled) {
  std::vector<Part<T>> parts;
  const std::vector<UtcTime> centres = run.centres();
  bool hangs_together = false;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    if (i > 0 && (!hangs_on(centres, i) || taken.reaches_into(centres[i - 1], centres[i]) ||
                  filled.holds(centres[i - 1], centres[i])))
      hangs_together = false;
    if (taken.holds(centres[i])) {
      hangs_together = false;
    } else if (hangs_together) {
      ++parts.back().count;
    } else {
      parts.push_back({&run, rank, i, 1});
      hangs_together = true;
    }
  }
  return parts;
}

/// Who speaks when: each run in the order given takes what is left of its time.
template <typename T>
std::vector<Part<T>> shared_out(const std::vector<const ProductRun<T>*>& runs) {
  std::vector<Part<T>> parts;
  TakenTime taken;
  for (std::size_t rank = 0; rank < runs.size(); ++rank) {
    const std::vector<UtcTime> centres = runs[rank]->centres();
    const FilledPauses filled(*runs[rank], runs);
    for (Part<T>& part : parts_left(*runs[rank], rank, taken, filled)) parts.push_back(part);
    const auto is_filled = [&](UtcTime after, UtcTime before) {
      return filled.holds(after, before);
    };
    for (const TimeSpan& span : whole_parts(centres, is_filled)) taken.take(span);
  }
  return parts;
}

/// The same runs as in another series, each for its time there.
template <typename T>
std::vector<Part<T>> shared_out_like(const std::vector<const ProductRun<T>*>& runs,
                                     const std::vector<Stretch>& like) {
  std::vector<Part<T>> parts;
  for (const Stretch& stretch : like) {
    const auto unlike = [&](const ProductRun<T>* run) {
      const bool is_mean = run->members > 0;
      if (is_mean != (stretch.members > 0)) return 2;
      return unlikeness(run->origin(), *stretch.origin, is_mean);
    };
    const auto nearest =
        std::min_element(runs.begin(), runs.end(),
                         [&](const auto* a, const auto* b) { return unlike(a) < unlike(b); });
    if (nearest == runs.end() || unlike(*nearest) > 1) continue;
    const ProductRun<T>& run = **nearest;
    Part<T> part{&run, static_cast<std::size_t>(nearest - runs.begin()), 0, 0};
    for (std::size_t i = 0; i < run.values.size(); ++i) {
      const UtcTime centre = run.values[i].cell.centre();
      if (centre < stretch.from || centre > stretch.to) continue;
      if (part.count++ == 0) part.first = i;
    }
    if (part.count > 0) parts.push_back(part);
  }
  return parts;
}

/// "the analysis of ECMWF", "the run of 2024-06-11T00:00:00Z of ECMWF", "station X".
template <typename T>
std::string name_of_run(const ProductRun<T>& run) {
  const Origin& origin = run.origin();
  if (origin.is_point_series) return "station " + origin.station;
  const RunName name = run_name_of(origin);
  if (!name.is_forecast) return "the analysis of " + origin.product_id;
  if (!name.reference_time) return "the forecast of " + origin.product_id;
  return "the run of " + format_utc(*name.reference_time) + " of " + origin.product_id;
}

/// Where a part stands beside a better one: after its end, or before its beginning; else empty.
template <typename T>
std::string beside_better(const std::vector<Part<T>>& parts, std::size_t p) {
  if (p > 0 && parts[p - 1].rank < parts[p].rank)
    return "where " + name_of_run(*parts[p - 1].run) + " ends";
  if (p + 1 < parts.size() && parts[p + 1].rank < parts[p].rank)
    return "before " + name_of_run(*parts[p + 1].run) + " begins";
  return {};
}

/// Why a part speaks: where it stands, and what puts it before the best of the others that have
/// values in its time.
template <typename T>
std::string reason_for(const std::vector<Part<T>>& parts, std::size_t p,
                       const std::vector<const ProductRun<T>*>& runs) {
  const Part<T>& part = parts[p];
  const auto next = std::find_if(runs.begin() + static_cast<std::ptrdiff_t>(part.rank) + 1,
                                 runs.end(), [&](const ProductRun<T>* run) {
                                   return run->values.front().cell.centre() <= part.to() &&
                                          run->values.back().cell.centre() >= part.from();
                                 });
  const std::string beside = beside_better(parts, p);
  if (next == runs.end()) return beside.empty() ? "nothing else is there" : beside;
  const std::string why = reason_before(standing_of(*part.run), standing_of(**next));
  return beside.empty() ? why : beside + ", " + why;
}

template <typename T>
Stretch stretch_of(const Part<T>& part) {
  const ProductRun<T>& run = *part.run;
  Stretch stretch;
  stretch.origin = run.values[part.first].piece->origin;
  stretch.from = part.from();
  stretch.to = part.to();
  stretch.members = run.members;
  stretch.distance_m = run.first->distance_m;
  stretch.from_height_m = run.first->from_height_m;
  stretch.may_be_revised = run.may_be_revised;
  std::vector<UtcTime> revised = run.revised;
  std::sort(revised.begin(), revised.end());
  revised.erase(std::unique(revised.begin(), revised.end()), revised.end());
  stretch.revised_times =
      static_cast<std::size_t>(std::count_if(revised.begin(), revised.end(), [&](UtcTime time) {
        return time >= stretch.from && time <= stretch.to;
      }));
  return stretch;
}

template <typename T>
Column<T> series_of(const std::vector<Part<T>>& parts, std::vector<const Origin*>& origin) {
  Column<T> out;
  const Column<T>& pattern = parts.front().run->first->column;
  out.point = pattern.point;
  out.vertical = pattern.vertical;
  out.levels_m = pattern.levels_m;
  for (const Part<T>& part : parts) {
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
      const RunValue<T>& value = part.run->values[i];
      const Column<T>& from = value.piece->column;
      out.time.push_back(value.cell);
      out.source.push_back(from.source[value.t]);
      origin.push_back(value.piece->origin);
      for (std::size_t k = 0; k < from.levels(); ++k) {
        out.value.push_back(from.value[from.offset(value.t, k)]);
        out.status.push_back(from.status[from.offset(value.t, k)]);
      }
    }
  }
  return out;
}

/// The runs in order, those alone that stand on the levels of the best.
template <typename T>
std::vector<const ProductRun<T>*> in_order(const std::vector<ProductRun<T>>& runs) {
  std::vector<const ProductRun<T>*> order;
  order.reserve(runs.size());
  for (const ProductRun<T>& run : runs) order.push_back(&run);
  std::stable_sort(order.begin(), order.end(), [](const ProductRun<T>* a, const ProductRun<T>* b) {
    return counts_before(standing_of(*a), standing_of(*b));
  });
  std::erase_if(order,
                [&, best = order.empty() ? nullptr : order.front()](const ProductRun<T>* run) {
                  return run->first->column.levels_m != best->first->column.levels_m;
                });
  return order;
}

template <typename T>
Chosen<T> choose_from(const Record<T>& record, const Knowledge& knowledge, const Choice& choice) {
  const std::vector<ProductRun<T>> runs = runs_of(record, knowledge, choice);
  const std::vector<const ProductRun<T>*> order = in_order(runs);
  std::vector<Part<T>> parts =
      choice.like != nullptr ? shared_out_like(order, *choice.like) : shared_out(order);
  Chosen<T> chosen;
  if (parts.empty()) return chosen;
  std::sort(parts.begin(), parts.end(),
            [](const Part<T>& a, const Part<T>& b) { return a.from() < b.from(); });
  chosen.column = series_of(parts, chosen.origin);
  if (choice.ramp > Duration(0)) join_parts(chosen.column, parts, choice.ramp);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    chosen.stretches.push_back(stretch_of(parts[p]));
    chosen.stretches.back().why =
        choice.like != nullptr ? "of the same run" : reason_for(parts, p, order);
  }
  return chosen;
}

}  // namespace

bool is_known(const Origin& origin, const TimeCell& cell, const Knowledge& knowledge) {
  if (origin.status == DataStatus::forecast && origin.reference_time) {
    return is_published_by(origin, knowledge.forecasts_issued_by);
  }
  return cell.end <= knowledge.values_until ||
         (origin.received && *origin.received <= knowledge.received_by);
}

Chosen<Horizontal> choose(const VectorRecord& record, const Knowledge& knowledge,
                          const Choice& choice) {
  return choose_from(record, knowledge, choice);
}

Chosen<double> choose(const ScalarRecord& record, const Knowledge& knowledge,
                      const Choice& choice) {
  return choose_from(record, knowledge, choice);
}

}  // namespace slackwater
