#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "api/door/edr/read/wkt.h"
#include "tests/fuzz/fuzz_case.h"

namespace {

using namespace slackwater;
using namespace slackwater::api::edr;

/// Calls `visit` for each vertex.
template <typename Visit>
void for_each_vertex(const Geometry& geometry, const Visit& visit) {
  for (const Part& part : geometry.parts) {
    for (const Path& path : part) {
      for (const Vertex& vertex : path) visit(vertex);
    }
  }
}

std::string text_of(const Vertex& v, const Geometry& geometry) {
  std::array<char, 128> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.17g %.17g", v.longitude_deg, v.latitude_deg);
  std::string text = buffer.data();
  if (geometry.has_vertical) {
    std::snprintf(buffer.data(), buffer.size(), " %.17g", v.vertical);
    text += buffer.data();
  }
  if (geometry.has_time) {
    const double seconds = static_cast<double>(v.time.time_since_epoch().count()) / 1000.0;
    std::snprintf(buffer.data(), buffer.size(), " %.3f", seconds);
    text += buffer.data();
  }
  return text;
}

template <typename Items, typename Write>
std::string list_of(const Items& items, const Write& write) {
  std::string text = "(";
  for (const auto& item : items) {
    if (text.size() > 1) text += ',';
    text += write(item);
  }
  return text + ")";
}

std::string written(const Geometry& g) {
  const auto path = [&](const Path& p) {
    return list_of(p, [&](const Vertex& v) { return text_of(v, g); });
  };
  const auto part = [&](const Part& p) { return list_of(p, path); };
  std::string text(name_of(g.type));
  if (g.has_vertical) text += 'Z';
  if (g.has_time) text += 'M';
  switch (g.type) {
    case GeometryType::polygon:
      return text + part(g.parts[0]);
    case GeometryType::multi_polygon:
      return text + list_of(g.parts, part);
    case GeometryType::multi_line_string:
      return text + list_of(g.parts, [&](const Part& p) { return path(p[0]); });
    default:
      return text + path(g.parts[0][0]);
  }
}

void check(const Geometry& geometry) {
  const Box box = bounding_box(geometry);
  std::size_t count = 0;
  for_each_vertex(geometry, [&](const Vertex& v) {
    ++count;
    fuzz::claim(v.longitude_deg >= -180 && v.longitude_deg <= 360, "a longitude out of range");
    fuzz::claim(std::abs(v.latitude_deg) <= 90, "a latitude out of range");
    fuzz::claim(std::abs(v.vertical) <= max_vertical_m, "a level out of range");
    fuzz::claim(v.longitude_deg >= box.west_deg && v.longitude_deg <= box.east_deg &&
                    v.latitude_deg >= box.south_deg && v.latitude_deg <= box.north_deg,
                "a vertex outside the bounding box");
  });
  fuzz::claim(count > 0 && count <= max_wkt_vertices, "none, or too many vertices");
  fuzz::claim(!contains(geometry, box.east_deg, box.north_deg + 1),
              "a place north of all vertices");
  (void)contains(geometry, (box.west_deg + box.east_deg) / 2, box.south_deg);
}

bool is_same(const Geometry& a, const Geometry& b) {
  return a.type == b.type && a.has_vertical == b.has_vertical && a.has_time == b.has_time &&
         a.parts == b.parts;
}

}  // namespace

/// Well Known Text: what is read is in range, and the same when it is written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::accepts([&] {
    const Geometry read = parse_wkt("coords", fuzz::text_of(data, size));
    check(read);
    const std::string text = written(read);
    // Numbers in full are longer than those read: the limit may be passed.
    if (text.size() <= max_wkt_bytes) {
      fuzz::claim(is_same(parse_wkt("coords", text), read),
                  "a geometry changes when it is written and read");
    }
  });
  return 0;
}
