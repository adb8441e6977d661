#pragma once
#include <array>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "api/door/edr/sample/answer.h"
#include "fields/service/field.h"

namespace slackwater::api::edr {

/// A quantity of a collection, all that it is: what clients are told of it, and how it is had from
/// samples, each of which says by its status whether it has a value.
template <typename Sample>
struct Quantity {
  Parameter parameter;
  /// Appends one value a sample, NaN where it has none: a call a batch, not a call a value.
  void (*append)(std::span<const Sample> samples, std::vector<double>& values) = nullptr;
};
template <typename Sample>
using Quantities = std::span<const Quantity<Sample>>;

/// A group of quantities that are asked together.
struct Collection {
  std::string id;
  std::string title;
  std::string description;
  std::vector<std::string> keywords;
  Vertical vertical = Vertical::none;
  /// Its parameters are these; with `is_of_members` these of each member, member by member.
  std::variant<Quantities<CurrentSample>, Quantities<WindSample>, Quantities<SeaSample>,
               Quantities<SeaLevelSample>>
      quantities;
  bool is_of_members = false;
};

/// currents, currents-members, wind, wind-members, waves, sea-level (collections.cc). Members have
/// collections of their own, because who names no parameter is given all of a collection's.
[[nodiscard]] std::span<const Collection> collections();
/// @throws Error(not_found) that lists what there is
[[nodiscard]] const Collection& collection_named(const std::string& id);

/// What a collection offers of a forecast with so many members.
[[nodiscard]] std::vector<Parameter> parameters_of(const Collection& collection,
                                                   std::size_t members);

/// Whether any of a forecast's columns may have a value: a collection of sea levels says once, as a
/// refusal, that a forecast has none.
[[nodiscard]] bool is_offered_by(const Collection& collection, const Snapshot& forecast);

/// The vertical positions at which a collection is given where none are asked for: the forecast's
/// native levels, or 10 m for wind. Empty without a vertical.
[[nodiscard]] std::vector<double> native_levels(const Collection& collection, const Field& field);
/// Positions that a range of the vertical may choose from.
[[nodiscard]] std::vector<double> all_levels(const Collection& collection, const Field& field);
/// The range of the vertical: 0 to the deepest bed, or the heights of the wind profile.
[[nodiscard]] std::pair<double, double> vertical_range(const Collection& collection,
                                                       const Field& field);

/// What samples had to say beside their values.
struct Absences {
  /// Per SampleStatus: how often it came instead of a value.
  std::array<std::size_t, sample_status_count> count{};
  std::size_t carried = 0;    ///< currents below the water that the product knows
  std::size_t too_steep = 0;  ///< seas of a product beyond the breaking limit, served as they are
};

/// Samples the selected parameters (indices into `parameters_of`) at places and appends them to
/// `values`, one series a parameter; NaN where there is no value.
void sample(const Collection& collection, const Field& field, std::span<const std::size_t> selected,
            std::span<const Place> places, std::vector<std::vector<double>>& values,
            Absences& absences);

}  // namespace slackwater::api::edr
