#include "ingest/copernicus/product.h"

#include <algorithm>

#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/geo/coverage.h"

namespace slackwater::ingest {
namespace {

MatchRule read_match(const Config& config) {
  MatchRule rule;
  rule.attribute = config.optional_text("attribute").value_or("");
  rule.contains = config.optional_text("contains").value_or("");
  if (const auto also = config.optional_child("also")) {
    for (const std::string& name : also->keys()) rule.also[name] = also->text(name);
  }
  rule.variables = config.texts("variables");
  if (rule.attribute.empty() && rule.variables.empty()) {
    config.refuse("attribute", "a match rule needs an attribute or variables");
  }
  return rule;
}

SettledAttributes read_settled(const Config& config) {
  return {config.text("variable"), config.optional_text("units"),
          config.optional_text("standard_name"), config.optional_text("positive")};
}

MeanLabel mean_label(const Config& config) {
  const std::string label = config.text("label");
  if (label == "centre") return MeanLabel::centre;
  if (label == "start") return MeanLabel::start;
  if (label == "end") return MeanLabel::end;
  if (label == "utc_day") return MeanLabel::utc_day;
  if (label == "utc_step") return MeanLabel::utc_step;
  if (label == "utc_month") return MeanLabel::utc_month;
  config.refuse("label", "found '" + label +
                             "'; expected centre, start, end, utc_step, utc_day or utc_month");
}

/// A number of whole days or hours; "month" is what lies between the stamps of two months.
Duration read_spacing(const Config& config) {
  const std::string text = config.text("spacing");
  const Duration spacing = text == "month" ? shortest_month : parse_duration(text);
  if (spacing <= Duration::zero())
    config.refuse("spacing", "expected the time between two stamps, longer than nothing");
  return spacing;
}

MeanRule read_mean(const Config& config) {
  constexpr Duration day = std::chrono::hours(24);
  MeanRule rule;
  rule.label = mean_label(config);
  if (config.has("spacing")) {
    rule.spacing = read_spacing(config);
    if (config.has("attribute"))
      config.refuse("spacing", "either what an attribute says, or how far apart the stamps are");
  } else {
    rule.attribute = config.text("attribute");
    rule.contains = config.text("contains");
  }
  rule.variables = config.texts("variables");
  if (rule.label == MeanLabel::utc_month) {
    if (config.has("step")) config.refuse("step", "a month has no fixed length; leave it out");
    return rule;
  }
  rule.step = parse_duration(config.text("step"));
  if (rule.step <= Duration::zero())
    config.refuse("step", "a mean needs an interval longer than nothing");
  if (rule.label == MeanLabel::utc_day && rule.step != day)
    config.refuse("step", "label utc_day needs step 24h");
  if (rule.label == MeanLabel::utc_step && day % rule.step != Duration::zero())
    config.refuse("step", "label utc_step needs a step that divides a day");
  return rule;
}

DownloadKind kind_of(const Config& config) {
  const std::string kind = config.text("kind");
  if (kind == "current") return DownloadKind::current;
  if (kind == "wave") return DownloadKind::wave;
  if (kind == "wind") return DownloadKind::wind;
  if (kind == "bathymetry") return DownloadKind::bathymetry;
  if (kind == "level") return DownloadKind::level;
  config.refuse("kind", "found '" + kind + "'; expected current, wave, wind, bathymetry or level");
}

std::vector<Water> water_of(const Config& config, const std::vector<Water>& waters,
                            const BoundingBox& domain) {
  std::vector<Water> water;
  for (const std::string& name : config.texts("water")) {
    const auto named = std::find_if(waters.begin(), waters.end(),
                                    [&](const Water& one) { return one.name == name; });
    if (named == waters.end()) {
      std::vector<std::string> known;
      for (const Water& one : waters) known.push_back(one.name);
      config.refuse("water", "found '" + name + "'; expected a name of `waters`" +
                                 (known.empty() ? ", and the product lists none"
                                                : ": " + joined(known, ", ")));
    }
    if (!overlaps(named->box(), domain))
      config.refuse("water", "'" + name +
                                 "' lies outside the domain; its corners are longitude, then "
                                 "latitude");
    water.push_back(*named);
  }
  return water;
}

Download read_download(const Config& config, const std::string& product_id,
                       const std::vector<Water>& waters) {
  Download download;
  download.product_id = product_id;
  download.dataset_id = config.text("dataset");
  download.kind = kind_of(config);
  download.variables = config.texts("variables");
  if (download.variables.empty())
    config.refuse("variables", "a download names at least one variable");
  const std::vector<double> box = config.numbers("domain", {-360.0, 360.0});
  if (box.size() != 4) config.refuse("domain", "expected [west, south, east, north] in degrees");
  download.domain = BoundingBox::from_degrees(box[0], box[1], box[2], box[3]);
  download.water = water_of(config, waters, download.domain);
  download.has_depth = config.optional_flag("depth").value_or(false);
  download.has_tide = config.optional_flag("tide").value_or(false);
  download.priority = config.optional_integer("priority", 0, 1000).value_or(100);
  download.horizon_h = config.optional_number("horizon_h", {0.0, 1000.0}).value_or(0.0);
  download.part = config.optional_text("part");
  if (const auto since = config.optional_text("since")) {
    try {
      download.since = parse_day(*since);
    } catch (const Error& problem) {
      config.refuse("since", problem.message());
    }
  }
  return download;
}

const std::optional<std::string>& settled(const SettledAttributes& entry, std::string_view name) {
  static const std::optional<std::string> none;
  if (name == "units") return entry.units;
  if (name == "standard_name") return entry.standard_name;
  if (name == "positive") return entry.positive;
  return none;
}

}  // namespace

bool Download::covers(const GeoPoint& place) const {
  return domain.contains(place) &&
         (water.empty() || std::any_of(water.begin(), water.end(),
                                       [&](const Water& one) { return one.contains(place); }));
}

Product Product::load(const std::filesystem::path& file) {
  const Config config = Config::load(file);
  Product product;
  product.sha256 = sha256_of_file(file);
  product.id = config.text("id");
  product.title = config.text("title");
  product.doi = config.optional_text("doi").value_or("");
  product.attribution = config.optional_text("attribution").value_or("");
  product.match_order = config.optional_integer("match_order", 0, 1000).value_or(50);
  for (const Config& rule : config.children("match")) product.match.push_back(read_match(rule));
  for (const Config& entry : config.children("settles"))
    product.settles.push_back(read_settled(entry));
  for (const Config& rule : config.children("means")) product.means.push_back(read_mean(rule));
  product.reference_time = config.texts("reference_time");
  product.contains_stokes = config.texts("contains_stokes");
  product.is_regional = config.optional_flag("regional").value_or(false);
  if (const auto after = config.optional_text("published_after"))
    product.published_after = parse_duration(*after);
  product.tide_in = config.texts("tide_in");
  product.has_tide = config.optional_flag("tide");
  if (product.has_tide && !product.tide_in.empty())
    config.refuse("tide_in", "either `tide`, of all its currents, or `tide_in`, of some");
  product.current_depth_m = config.optional_number("current_depth_m", {0.0, 20.0});
  if (const auto variables = config.optional_child("variables")) {
    for (const std::string& name : variables->keys())
      product.variables[name] = variables->text(name);
  }
  const std::vector<Water> waters = read_waters(config);
  for (const Config& entry : config.children("downloads")) {
    product.downloads.push_back(read_download(entry, product.id, waters));
  }
  config.expect_all_read();
  return product;
}

std::optional<bool> Product::tide_of(const std::string& variable) const {
  if (tide_in.empty()) return has_tide;
  return std::find(tide_in.begin(), tide_in.end(), variable) != tide_in.end();
}

bool Product::matches(const netcdf::File& file) const {
  const auto says = [&](const std::string& attribute, const std::string& words) {
    const auto text = file.text(attribute);
    return text && contains_ignoring_case(*text, words);
  };
  return std::any_of(match.begin(), match.end(), [&](const MatchRule& rule) {
    if (!rule.attribute.empty() && !says(rule.attribute, rule.contains)) return false;
    const bool says_all = std::all_of(rule.also.begin(), rule.also.end(), [&](const auto& other) {
      return says(other.first, other.second);
    });
    if (!says_all) return false;
    return std::all_of(rule.variables.begin(), rule.variables.end(),
                       [&](const std::string& name) { return file.find(name) != nullptr; });
  });
}

std::optional<std::string> Product::attribute(const netcdf::Variable& variable,
                                              std::string_view name) const {
  if (auto own = variable.text(name); own && !own->empty()) return own;
  for (const SettledAttributes& entry : settles) {
    if (entry.variable == variable.name) {
      if (const auto& text = settled(entry, name)) return text;
    }
  }
  return std::nullopt;
}

}  // namespace slackwater::ingest
