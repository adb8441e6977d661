#include "api/door/edr/sample/collection.h"

#include <algorithm>
#include <limits>

#include "fields/base/error.h"
#include "fields/wave/growth.h"

namespace slackwater::api::edr {
namespace {

/// Heights at which a range of wind is given.
constexpr std::array wind_heights_m{10.0,  20.0,  40.0,  60.0,  80.0,
                                    100.0, 120.0, 150.0, 200.0, 300.0};

Parameter of_member(const Parameter& central, std::size_t member) {
  const std::string number = std::to_string(member);
  Parameter parameter = central;
  parameter.name += "_member_" + number;
  parameter.method = "member " + number;
  parameter.description = parameter.label + ", " + parameter.method;
  return parameter;
}

void sample_member(const Field& field, std::span<const Place> places, std::size_t member,
                   std::span<CurrentSample> out) {
  field.sample_current(places, out, member);
}

void sample_member(const Field& field, std::span<const Place> places, std::size_t member,
                   std::span<WindSample> out) {
  field.sample_wind(places, out, member);
}

/// Seas have no members.
void sample_member(const Field& field, std::span<const Place> places, std::size_t /*member*/,
                   std::span<SeaSample> out) {
  field.sample_sea(places, out);
}

void sample_member(const Field& field, std::span<const Place> places, std::size_t member,
                   std::span<SeaLevelSample> out) {
  field.sample_sea_level(places, out, member);
}

void count_doubtful(std::span<const WindSample> /*samples*/, Absences& /*absences*/) {}

void count_doubtful(std::span<const SeaLevelSample> /*samples*/, Absences& /*absences*/) {}

void count_doubtful(std::span<const CurrentSample> samples, Absences& absences) {
  for (const CurrentSample& s : samples)
    if (s.status == SampleStatus::carried) ++absences.carried;
}

void count_doubtful(std::span<const SeaSample> samples, Absences& absences) {
  for (const SeaSample& s : samples) {
    const SeaState& sea = s.sea;
    if (has_value(s.status) && sea.significant_height_m > steepest_height_m(sea.peak_period_s))
      ++absences.too_steep;
  }
}

template <typename Sample>
void count_absent(std::span<const Sample> samples, Absences& absences) {
  for (const Sample& s : samples)
    if (!has_value(s.status)) ++absences.count[static_cast<std::size_t>(s.status)];
}

/// Parameters of one member that follow each other are had from the same samples. What is absent
/// counts once a place; of members, where each may lack its own, once a value.
template <typename Sample>
void append_samples(Quantities<Sample> quantities, bool is_of_members, const Field& field,
                    std::span<const std::size_t> selected, std::span<const Place> places,
                    std::vector<std::vector<double>>& values, Absences& absences) {
  std::vector<Sample> samples(places.size());
  const std::span<const Sample> found(samples);
  std::size_t held = std::numeric_limits<std::size_t>::max();
  for (std::size_t p = 0; p < selected.size(); ++p) {
    const std::size_t member = selected[p] / quantities.size();
    const bool is_new = member != held;
    if (is_new) {
      sample_member(field, places, member, samples);
      count_doubtful(found, absences);
      held = member;
    }
    if (is_new || is_of_members) count_absent(found, absences);
    quantities[selected[p] % quantities.size()].append(found, values[p]);
  }
}

}  // namespace

const Collection& collection_named(const std::string& id) {
  std::string known;
  for (const Collection& collection : collections()) {
    if (collection.id == id) return collection;
    known += (known.empty() ? "" : ", ") + collection.id;
  }
  throw Error(
      ErrorKind::not_found,
      "found no collection of that name; there are " + known +
          ", product-KIND-ID for each stored product, and instrument-KIND-NAME for what was "
          "measured (see /collections)");
}

std::vector<Parameter> parameters_of(const Collection& collection, std::size_t members) {
  std::vector<Parameter> list;
  const auto add_all = [&](const auto& quantities) {
    if (!collection.is_of_members) {
      for (const auto& quantity : quantities) list.push_back(quantity.parameter);
      return;
    }
    for (std::size_t m = 0; m < members; ++m) {
      for (const auto& quantity : quantities) list.push_back(of_member(quantity.parameter, m));
    }
  };
  std::visit(add_all, collection.quantities);
  return list;
}

bool is_offered_by(const Collection& collection, const Snapshot& forecast) {
  if (!std::holds_alternative<Quantities<SeaLevelSample>>(collection.quantities)) return true;
  return std::any_of(forecast.columns.begin(), forecast.columns.end(),
                     [](const ForecastColumn& column) { return !column.sea_level.empty(); });
}

std::vector<double> native_levels(const Collection& collection, const Field& field) {
  if (collection.vertical == Vertical::depth_down) return field.snapshot().depth_m;
  if (collection.vertical == Vertical::height_up) return {10.0};
  return {};
}

std::vector<double> all_levels(const Collection& collection, const Field& field) {
  if (collection.vertical == Vertical::height_up)
    return {wind_heights_m.begin(), wind_heights_m.end()};
  return native_levels(collection, field);
}

std::pair<double, double> vertical_range(const Collection& collection, const Field& field) {
  if (collection.vertical == Vertical::height_up) return {lowest_wind_m, highest_wind_m};
  return {0.0, field.range().deepest_m};
}

void sample(const Collection& collection, const Field& field, std::span<const std::size_t> selected,
            std::span<const Place> places, std::vector<std::vector<double>>& values,
            Absences& absences) {
  values.resize(selected.size());
  std::visit(
      [&](const auto& quantities) {
        append_samples(quantities, collection.is_of_members, field, selected, places, values,
                       absences);
      },
      collection.quantities);
}

}  // namespace slackwater::api::edr
