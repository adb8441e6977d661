#include "api/door/edr/write/content.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/number.h"
#include "fields/base/check.h"
#include "fields/base/text.h"

namespace slackwater::api::edr {
namespace {

constexpr std::size_t max_accept_bytes = 4096;
constexpr std::size_t max_f_bytes = 256;

struct Known {
  Format format;
  std::string_view name;
  std::string_view media_type;
  std::string_view also;  ///< another media type in use
};

constexpr std::array known{
    Known{Format::coverage_json, "CoverageJSON", "application/prs.coverage+json",
          "application/vnd.cov+json"},
    Known{Format::geojson, "GeoJSON", "application/geo+json", "application/vnd.geo+json"},
    Known{Format::csv, "CSV", "text/csv", "application/csv"},
    Known{Format::netcdf, "NetCDF", "application/netcdf", "application/x-netcdf"},
    Known{Format::json, "JSON", "application/json", "text/json"},
    Known{Format::html, "HTML", "text/html", "application/xhtml+xml"}};

const Known& known_of(Format format) { return known[static_cast<std::size_t>(format)]; }

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The next piece up to a separator, trimmed.
std::string_view take(char separator, std::string_view& rest) {
  const std::size_t end = std::min(rest.find(separator), rest.size());
  const std::string_view piece = trimmed(rest.substr(0, end));
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return piece;
}

/// One entry of an Accept header: "text/*;q=0.8".
struct Range {
  std::string type;
  double weight = 1;
};

std::vector<Range> ranges_of(std::string_view accept) {
  std::vector<Range> ranges;
  while (!accept.empty()) {
    std::string_view entry = take(',', accept);
    Range range{lower_case(take(';', entry)), 1};
    while (!entry.empty()) {
      const std::string_view property = take(';', entry);
      if (!property.starts_with("q=") && !property.starts_with("Q=")) continue;
      range.weight = std::clamp(number_of(property.substr(2)).value_or(0.0), 0.0, 1.0);
    }
    if (!range.type.empty()) ranges.push_back(std::move(range));
  }
  return ranges;
}

/// How closely a range names a type: 3 itself, 2 "text/*", 1 "*/*", 0 not.
int closeness(const std::string& range, const Known& type) {
  if (range == type.media_type || range == type.also) return 3;
  if (range == "*/*") return 1;
  const std::size_t slash = type.media_type.find('/') + 1;
  return range == std::string(type.media_type.substr(0, slash)) + "*" ? 2 : 0;
}

/// The weight of the range that names the type most closely; 0 where none does.
double weight_of(const std::vector<Range>& ranges, const Known& type) {
  int closest = 0;
  double weight = 0;
  for (const Range& range : ranges) {
    const int close = closeness(range.type, type);
    if (close > closest) {
      closest = close;
      weight = range.weight;
    }
  }
  return weight;
}

Format named_by(std::string_view f, std::span<const Format> offered) {
  expect_short("f", f, max_f_bytes);
  std::string wanted = lower_case(trimmed(f));
  // The '+' of a media type becomes a blank where a client does not encode it.
  std::replace(wanted.begin(), wanted.end(), ' ', '+');
  std::string list;
  for (const Format format : offered) {
    const Known& candidate = known_of(format);
    if (wanted == lower_case(candidate.name) || wanted == candidate.media_type ||
        wanted == candidate.also) {
      return format;
    }
    list += (list.empty() ? "" : ", ") + std::string(candidate.name);
  }
  throw bad_parameter("f", f, "one of " + list);
}

}  // namespace

std::string_view name_of(Format format) noexcept { return known_of(format).name; }
std::string_view media_type_of(Format format) noexcept { return known_of(format).media_type; }

Format choose_format(std::string_view f, std::string_view accept, std::span<const Format> offered) {
  expects(!offered.empty(), "choose_format: something is offered");
  if (!f.empty()) return named_by(f, offered);
  if (accept.size() > max_accept_bytes) return offered.front();
  const std::vector<Range> ranges = ranges_of(accept);
  Format best = offered.front();
  double best_weight = 0;
  for (const Format format : offered) {
    const double weight = weight_of(ranges, known_of(format));
    if (weight > best_weight) {
      best_weight = weight;
      best = format;
    }
  }
  return best;
}

}  // namespace slackwater::api::edr
