#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/config.h"

namespace slackwater::ingest {

/// What a quantity belongs to: it decides what its vertical coordinate means.
enum class Realm {
  sea,      ///< in the water: the vertical axis is a depth
  air,      ///< above it: the vertical axis is a height
  surface,  ///< of the surface, the waves or the bed: no vertical axis
};

/// One name under which providers write a quantity, with the height or depth that the name implies.
struct Alias {
  std::string name;
  std::optional<double> height_m;  ///< u10 -> 10, u100 -> 100
};

/// One quantity that we take from files; `data/products/variables.yaml` holds the list.
struct Quantity {
  std::string standard_name;  ///< CF, the key at every boundary
  std::string unit;           ///< canonical SI; "degree" for directions, "K" for temperatures
  Realm realm = Realm::surface;
  bool is_static = false;  ///< does not change in time: bed, mask
  Range gross;             ///< a value outside is an instrument or packing error, canonical unit
  std::optional<double>
      spike;  ///< largest believable jump between neighbours in time, canonical unit
  std::optional<double> height_m;  ///< where a file names none (winds: 10 m)
  std::vector<std::string> also;   ///< older or kindred standard names that mean the same
  std::vector<Alias> aliases;      ///< product short names, the preferred one first

  [[nodiscard]] const Alias* alias(std::string_view name) const noexcept;
};

/// The quantities we know. Immutable.
class Vocabulary {
 public:
  /// Reads `variables.yaml`; strict. Throws Error(invalid_input).
  [[nodiscard]] static Vocabulary load(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<Quantity>& quantities() const noexcept { return quantities_; }
  /// By CF standard name (current or older); null if it is not ours.
  [[nodiscard]] const Quantity* by_standard_name(std::string_view name) const noexcept;
  /// By a provider's short name; null if none.
  [[nodiscard]] const Quantity* by_alias(std::string_view name) const noexcept;

 private:
  std::vector<Quantity> quantities_;
};

}  // namespace slackwater::ingest
