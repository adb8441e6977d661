#include "api/door/edr/read/wkt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/number.h"

namespace slackwater::api::edr {
namespace {

constexpr std::array all_types{GeometryType::point,       GeometryType::multi_point,
                               GeometryType::line_string, GeometryType::multi_line_string,
                               GeometryType::polygon,     GeometryType::multi_polygon};

/// 9999-12-31T23:59:59Z, the last second that RFC 3339 can write; the first is 0000-01-01.
constexpr double last_epoch_s = 253402300799.0;
constexpr double first_epoch_s = -62167219200.0;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// One pass over the text; each function reads what it is named after and moves on.
class Reader {
 public:
  Reader(std::string_view parameter, std::string_view text)
      : parameter_(parameter), text_(text), rest_(text) {}

  Geometry geometry(std::initializer_list<GeometryType> allowed) {
    head(allowed);
    switch (read_.type) {
      case GeometryType::point:
        read_.parts = {{vertices(1, 1)}};
        break;
      case GeometryType::multi_point:
        read_.parts = {{points()}};
        break;
      case GeometryType::line_string:
        read_.parts = {{line()}};
        break;
      case GeometryType::multi_line_string:
        list([&] { read_.parts.push_back({line()}); });
        break;
      case GeometryType::polygon:
        read_.parts = {polygon()};
        break;
      case GeometryType::multi_polygon:
        list([&] { read_.parts.push_back(polygon()); });
        break;
    }
    skip_blanks();
    if (!rest_.empty()) refuse("the end of the geometry");
    return std::move(read_);
  }

 private:
  [[noreturn]] void refuse(const std::string& expected) const {
    const std::size_t position = text_.size() - rest_.size();
    // Near the place, so that a long text shows the part that is wrong.
    const std::string_view near = text_.substr(position - std::min<std::size_t>(position, 30), 60);
    throw bad_parameter(parameter_, near,
                        expected + " at character " + std::to_string(position + 1) +
                            ", as in POINT(2.45 57.25) or POLYGON((2 57,3 57,3 58,2 57))");
  }

  void skip_blanks() {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  }

  bool take(char wanted) {
    skip_blanks();
    if (!rest_.starts_with(wanted)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void expect(char wanted) {
    if (!take(wanted)) refuse(std::string("'") + wanted + "'");
  }

  std::string word() {
    skip_blanks();
    const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_letter);
    std::string letters(rest_.begin(), end);
    std::transform(letters.begin(), letters.end(), letters.begin(), upper);
    rest_.remove_prefix(letters.size());
    return letters;
  }

  /// "LINESTRING", "LINESTRINGZM" or "LINESTRING ZM", into type and axes.
  void head(std::initializer_list<GeometryType> allowed) {
    const std::string_view start = rest_;
    const std::string name = word();
    // The longest name that fits first: none is the start of another but for the axes.
    const auto type = std::find_if(all_types.begin(), all_types.end(),
                                   [&](GeometryType t) { return name.starts_with(name_of(t)); });
    if (type == all_types.end() ||
        (allowed.size() > 0 && std::find(allowed.begin(), allowed.end(), *type) == allowed.end())) {
      rest_ = start;
      refuse(names(allowed));
    }
    read_.type = *type;
    std::string axes = name.substr(name_of(*type).size());
    if (axes.empty()) axes = word();
    if (axes == "EMPTY") refuse("coordinates, not EMPTY,");
    if (!axes.empty() && axes != "Z" && axes != "M" && axes != "ZM") {
      rest_ = start;
      refuse(std::string(name_of(*type)) + " with nothing, Z, M or ZM after it");
    }
    read_.has_vertical = axes.starts_with('Z');
    read_.has_time = axes.ends_with('M');
  }

  static std::string names(std::initializer_list<GeometryType> allowed) {
    std::string list;
    const auto add = [&](GeometryType type) {
      list += (list.empty() ? "" : " or ") + std::string(name_of(type));
    };
    if (allowed.size() == 0) std::for_each(all_types.begin(), all_types.end(), add);
    std::for_each(allowed.begin(), allowed.end(), add);
    return list;
  }

  double number(const std::string& what, double low, double high) {
    skip_blanks();
    const std::string_view start = rest_;
    const auto value = take_number(rest_);
    const bool ends = rest_.empty() || is_blank(rest_[0]) || rest_[0] == ',' || rest_[0] == ')';
    if (value && ends && *value >= low && *value <= high) return *value;
    rest_ = start;
    refuse(what);
  }

  Vertex vertex() {
    if (++vertices_ > max_wkt_vertices) {
      refuse("no more than " + std::to_string(max_wkt_vertices) + " vertices, the limit,");
    }
    Vertex v;
    v.longitude_deg = number("a longitude in [-180, 360]", -180, 360);
    v.latitude_deg = number("a latitude in [-90, 90]", -90, 90);
    if (read_.has_vertical) {
      static_assert(max_vertical_m == 20'000, "as the message says");
      v.vertical = number("a Z in metres within [-20000, 20000]", -max_vertical_m, max_vertical_m);
    }
    if (read_.has_time) {
      const double seconds = number("an M in seconds since 1970", first_epoch_s, last_epoch_s);
      v.time = UtcTime(Duration(static_cast<Duration::rep>(std::llround(seconds * 1000.0))));
    }
    return v;
  }

  template <typename Item>
  void list(const Item& item) {
    expect('(');
    do {
      item();
    } while (take(','));
    if (!take(')')) refuse("',' or ')'");
  }

  Path vertices(std::size_t fewest, std::size_t most) {
    Path path;
    list([&] { path.push_back(vertex()); });
    if (path.size() < fewest) {
      refuse(std::to_string(fewest) + " vertices, not " + std::to_string(path.size()) + ",");
    }
    if (path.size() > most) refuse("one vertex, not " + std::to_string(path.size()) + ",");
    return path;
  }

  Path points() {
    Path path;
    list([&] {
      const bool is_nested = take('(');
      path.push_back(vertex());
      if (is_nested) expect(')');
    });
    return path;
  }

  Path line() {
    Path path = vertices(2, max_wkt_vertices);
    const auto is_later = [](const Vertex& a, const Vertex& b) { return a.time < b.time; };
    if (!std::is_sorted(path.begin(), path.end(), is_later)) {
      refuse("times (M) that do not go back along the line that ends");
    }
    return path;
  }

  Path ring() {
    Path path = vertices(4, max_wkt_vertices);
    if (path.front() != path.back()) refuse("a ring whose last vertex repeats its first");
    return path;
  }

  Part polygon() {
    Part rings;
    list([&] { rings.push_back(ring()); });
    return rings;
  }

  std::string_view parameter_;
  std::string_view text_;
  std::string_view rest_;
  std::size_t vertices_ = 0;
  Geometry read_;
};

}  // namespace

Geometry parse_wkt(std::string_view parameter, std::string_view text,
                   std::initializer_list<GeometryType> allowed) {
  expect_short(parameter, text, max_wkt_bytes);
  return Reader(parameter, text).geometry(allowed);
}

}  // namespace slackwater::api::edr
