#include "ingest/copernicus/vocabulary.h"

#include <algorithm>
#include <set>

namespace slackwater::ingest {
namespace {

constexpr Range any_value{-1e6, 1e6};

Realm realm_of(const Config& config) {
  const std::string text = config.text("realm");
  if (text == "sea") return Realm::sea;
  if (text == "air") return Realm::air;
  if (text == "surface") return Realm::surface;
  config.refuse("realm", "found '" + text + "'; expected sea, air or surface");
}

Quantity read_quantity(const std::string& standard_name, const Config& config) {
  Quantity quantity;
  quantity.standard_name = standard_name;
  quantity.unit = config.text("unit");
  quantity.realm = realm_of(config);
  quantity.is_static = config.optional_flag("static").value_or(false);
  const std::vector<double> gross = config.numbers("gross_range", any_value);
  if (gross.size() != 2 || !(gross[0] < gross[1])) {
    config.refuse("gross_range", "expected [low, high] with low < high, in the canonical unit");
  }
  quantity.gross = {gross[0], gross[1]};
  quantity.spike = config.optional_number("spike", {0.0, 1e6});
  quantity.height_m = config.optional_number("height_m", {0.0, 500.0});
  quantity.also = config.texts("also");
  for (const std::string& name : config.texts("aliases"))
    quantity.aliases.push_back({name, std::nullopt});
  if (const auto heights = config.optional_child("alias_heights_m")) {
    for (const std::string& name : heights->keys()) {
      const auto found = std::find_if(quantity.aliases.begin(), quantity.aliases.end(),
                                      [&](const Alias& alias) { return alias.name == name; });
      if (found == quantity.aliases.end())
        heights->refuse(name, "not among the aliases of " + standard_name);
      found->height_m = heights->number(name, {0.0, 500.0});
    }
  }
  return quantity;
}

}  // namespace

const Alias* Quantity::alias(std::string_view name) const noexcept {
  const auto found = std::find_if(aliases.begin(), aliases.end(),
                                  [&](const Alias& alias) { return alias.name == name; });
  return found == aliases.end() ? nullptr : &*found;
}

Vocabulary Vocabulary::load(const std::filesystem::path& file) {
  const Config config = Config::load(file);
  Vocabulary vocabulary;
  std::set<std::string> names;
  for (const std::string& standard_name : config.keys()) {
    Quantity quantity = read_quantity(standard_name, config.child(standard_name));
    std::vector<std::string> all = quantity.also;
    all.push_back(standard_name);
    for (const Alias& alias : quantity.aliases) all.push_back(alias.name);
    for (const std::string& name : all) {
      if (!names.insert(name).second)
        config.refuse(standard_name, "the name '" + name + "' is given twice");
    }
    vocabulary.quantities_.push_back(std::move(quantity));
  }
  config.expect_all_read();
  return vocabulary;
}

const Quantity* Vocabulary::by_standard_name(std::string_view name) const noexcept {
  for (const Quantity& quantity : quantities_) {
    if (quantity.standard_name == name) return &quantity;
    if (std::find(quantity.also.begin(), quantity.also.end(), name) != quantity.also.end())
      return &quantity;
  }
  return nullptr;
}

const Quantity* Vocabulary::by_alias(std::string_view name) const noexcept {
  for (const Quantity& quantity : quantities_) {
    if (quantity.alias(name) != nullptr) return &quantity;
  }
  return nullptr;
}

}  // namespace slackwater::ingest
