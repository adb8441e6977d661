#include "twin/mission/limit.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "fields/base/advice.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

using Variable = LimitVariable;

constexpr std::array words{
    LimitWord{Variable::significant_wave_height,
              "significant_wave_height_m",
              "m",
              "significant wave height",
              {0.05, 20}},
    LimitWord{Variable::wave_peak_period, "wave_peak_period_s", "s", "peak wave period", {1, 30}},
    LimitWord{Variable::wind_speed_10m, "wind_speed_10m_m_s", "m/s", "wind at 10 m", {0.5, 60}},
    LimitWord{Variable::wind_speed, "wind_speed_m_s", "m/s", "wind at the work", {0.5, 60}},
    LimitWord{Variable::gust_speed, "gust_speed_m_s", "m/s", "gusts at the work", {0.5, 80}},
    LimitWord{Variable::current_speed, "current_speed_m_s", "m/s", "current", {0.02, 10}},
    LimitWord{Variable::deck_motion, "deck_motion_m", "m", "motion of the deck", {0.02, 20}},
    LimitWord{Variable::fender_force, "fender_force_n", "N", "force on the fender", {10, 1e8}},
    LimitWord{Variable::visibility, "visibility_m", "m", "visibility", {1, 1e5}, false},
    LimitWord{Variable::water_visibility,
              "water_visibility_m",
              "m",
              "visibility under water",
              {0.01, 100},
              false},
    LimitWord{Variable::rain_rate, "rain_mm_h", "mm/h", "rain", {0, 200}, false},
    LimitWord{Variable::air_temperature,
              "air_temperature_c",
              "degrees C",
              "air temperature",
              {-60, 60},
              false},
    LimitWord{Variable::sea_surface_height,
              "sea_surface_height_m",
              "m",
              "level of the sea",
              {-15, 15},
              true,
              true},
};

std::string keys() {
  std::vector<std::string> all;
  all.reserve(words.size());
  for (const LimitWord& word : words) all.emplace_back(word.key);
  return joined(all, ", ");
}

/// Depth down or height up, at most one of them.
std::optional<double> read_down(const Config& config) {
  const auto high = config.optional_number("at_height_m", {0, 500});
  const auto deep = config.optional_number("at_depth_m", {0, 12000});
  if (high && deep) config.refuse("at_depth_m", "found beside at_height_m; give one of them");
  if (high) return -*high;
  return deep;
}

PhaseSet read_phases(const Config& config) {
  PhaseSet phases;
  const std::vector<std::string> named = config.texts("phases");
  if (named.empty()) return phases;
  phases.bits = 0;
  for (const std::string& name : named) {
    const auto phase = phase_of(name);
    if (!phase)
      config.refuse("phases",
                    "found " + name + ", expected transit, launch, work, recovery or return");
    phases.add(*phase);
  }
  return phases;
}

/// The heading beside a table whose bounds go by the angle off the bow.
std::optional<double> read_heading(const Config& config, const HeightTable& table) {
  const auto heading = config.optional_number("heading_deg", {-360, 360});
  if (!heading) return std::nullopt;
  if (table.off_bow_rad.empty())
    config.refuse("heading_deg",
                  "found beside a table without rows by from_bow_deg; it changes nothing, leave it "
                  "out");
  return *heading * constants::degree;
}

/// A table in the place of the bound on a height of waves.
std::optional<Limit> read_limit_by_sea(const Config& config) {
  const LimitWord& word = word_of(Variable::significant_wave_height);
  if (!config.is_mapping(word.key)) return std::nullopt;
  for (const char* const key : {"from_bow_deg", "peak_period_between_s"})
    if (config.has(key))
      config.refuse(key, std::string("found beside a table of ") + word.key +
                             ", which says by itself what counts; leave one of them out");
  Limit limit;
  limit.variable = word.variable;
  limit.table = read_height_table(config.child(word.key), word.range);
  limit.table->heading_rad = read_heading(config, *limit.table);
  limit.bound = limit.table->least_m();
  return limit;
}

Limit read_limit(const Config& config) {
  std::optional<Limit> limit = read_limit_by_sea(config);
  for (const LimitWord& word : words) {
    for (const bool is_least : {false, true}) {
      const std::string key = (is_least ? "least_" : "") + std::string(word.key);
      if (limit && limit->table && limit->variable == word.variable && !is_least) continue;
      const auto bound = config.optional_number(key, word.range);
      if (!bound) continue;
      if (limit)
        config.refuse(key, std::string("found beside ") + word_of(limit->variable).key +
                               "; give each limit an entry of its own");
      limit.emplace();
      limit->variable = word.variable;
      limit->is_least = is_least;
      limit->bound = *bound;
    }
  }
  if (!limit)
    config.refuse("limits", "found an entry without a variable, expected one of " + keys() +
                                ", or least_ before one");
  limit->down_m = read_down(config);
  if (!limit->table) limit->waves = read_wave_sector(config);
  if (limit->waves && (limit->variable != Variable::significant_wave_height || limit->is_least))
    config.refuse(limit->waves->off_bow_rad ? "from_bow_deg" : "peak_period_between_s",
                  "says which waves an upper bound on their height is of; found beside another "
                  "limit, leave it out");
  limit->phases = read_phases(config);
  if (const auto missing = config.optional_text("if_missing")) {
    if (*missing != "not_checked" && *missing != "error")
      config.refuse("if_missing", "found " + *missing + ", expected not_checked or error");
    limit->may_be_missing = *missing == "not_checked";
  }
  limit->source = config.optional_text("source").value_or("");
  limit->status = config.optional_text("status").value_or("");
  return *limit;
}

constexpr const char* no_assumption =
    "cannot be assumed; expected visibility_m, water_visibility_m, rain_mm_h or "
    "air_temperature_c, which no forecast here serves, or "
    "sea_surface_height_m, which not every one has";

/// Null for what the twin knows itself, and for what nobody knows.
const LimitWord* assumable(std::string_view key) {
  const auto word =
      std::find_if(words.begin(), words.end(), [&](const LimitWord& w) { return key == w.key; });
  return word == words.end() || !word->may_be_assumed ? nullptr : &*word;
}

}  // namespace

std::span<const LimitWord> limit_words() noexcept { return words; }

const LimitWord& word_of(LimitVariable variable) noexcept {
  return words[static_cast<std::size_t>(variable)];
}

std::string text_of(const Limit& limit) {
  const LimitWord& word = word_of(limit.variable);
  std::string text = formatted("{} at {} {:g} {}", word.meaning, limit.is_least ? "least" : "most",
                               limit.bound, word.unit);
  if (limit.table)
    text = formatted("{} at most {:g} to {:g} {} ", word.meaning, limit.bound,
                     limit.table->greatest_m(), word.unit) +
           text_of(*limit.table);
  if (limit.down_m && *limit.down_m < 0)
    text += formatted(" at a height of {:g} m", -*limit.down_m);
  if (limit.down_m && *limit.down_m >= 0) text += formatted(" at a depth of {:g} m", *limit.down_m);
  if (limit.waves) text += " " + text_of(*limit.waves);
  return text;
}

std::vector<Limit> read_limits(const Config& config) {
  std::vector<Limit> limits;
  for (const Config& entry : config.children("limits")) limits.push_back(read_limit(entry));
  for (std::size_t i = 0; i < limits.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Limit &a = limits[i], &b = limits[j];
      if (a.variable != b.variable || a.is_least == b.is_least || a.down_m != b.down_m ||
          (a.phases.bits & b.phases.bits) == 0)
        continue;
      const Limit& upper = a.is_least ? b : a;
      const double most = upper.table ? upper.table->greatest_m() : upper.bound;
      const double least = a.is_least ? a.bound : b.bound;
      if (least > most)
        config.refuse("limits", formatted("{} has to be at least {:g} and at most {:g} {} at the "
                                          "same time, which is impossible; correct one of them",
                                          word_of(a.variable).meaning, least, most,
                                          word_of(a.variable).unit));
    }
  return limits;
}

std::vector<Assumption> read_assumptions(const Config& config) {
  std::vector<Assumption> out;
  const auto assume = config.optional_child("assume");
  if (!assume) return out;
  for (const std::string& key : assume->keys()) {
    const LimitWord* const word = assumable(key);
    if (word == nullptr) assume->refuse(key, no_assumption);
    out.push_back({word->variable, assume->number(key, word->range)});
  }
  return out;
}

Assumption parse_assumption(const std::string& text) {
  const std::string found = "--assume: found " + text;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw Error(ErrorKind::invalid_input,
                found + ", expected NAME=NUMBER, as in visibility_m=5000");
  const LimitWord* const word = assumable(trimmed(text.substr(0, equals)));
  if (word == nullptr) throw Error(ErrorKind::invalid_input, found + ", which " + no_assumption);
  std::string number(trimmed(text.substr(equals + 1)));
  if (number.starts_with('+')) number.erase(0, 1);
  const char* const end = number.data() + number.size();
  double value = 0;
  const auto [stop, problem] = std::from_chars(number.data(), end, value);
  const auto [low, high] = word->range;
  if (problem != std::errc() || stop != end || !(value >= low && value <= high)) {
    const auto meant = with_decimal_point(number);
    throw Error(ErrorKind::invalid_input,
                found +
                    formatted(", expected a number from {:g} to {:g} {}", low, high, word->unit) +
                    (meant ? "; use a decimal point: write " + *meant : ""));
  }
  return {word->variable, value};
}

}  // namespace slackwater::twin
