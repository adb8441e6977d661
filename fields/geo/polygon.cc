#include "fields/geo/polygon.h"

#include <algorithm>

#include "fields/base/text.h"
#include "fields/base/turn.h"

namespace slackwater {
namespace {

double cross_of(Horizontal a, Horizontal b) { return a.real() * b.imag() - a.imag() * b.real(); }

/// Whether two stretches have a point in common, ends included.
bool meet(Horizontal a, Horizontal b, Horizontal c, Horizontal d) {
  const double at_c = cross_of(b - a, c - a), at_d = cross_of(b - a, d - a);
  const double at_a = cross_of(d - c, a - c), at_b = cross_of(d - c, b - c);
  if (((at_c > 0) != (at_d > 0)) && ((at_a > 0) != (at_b > 0)) && at_c != 0 && at_d != 0)
    return true;
  const auto lies_on = [](Horizontal p, Horizontal q, Horizontal x) {
    if (cross_of(q - p, x - p) != 0) return false;
    return std::min(p.real(), q.real()) <= x.real() && x.real() <= std::max(p.real(), q.real()) &&
           std::min(p.imag(), q.imag()) <= x.imag() && x.imag() <= std::max(p.imag(), q.imag());
  };
  return lies_on(a, b, c) || lies_on(a, b, d) || lies_on(c, d, a) || lies_on(c, d, b);
}

}  // namespace

std::vector<Horizontal> degrees_about_first(const std::vector<GeoPoint>& corners) {
  std::vector<Horizontal> plane;
  for (const GeoPoint& corner : corners)
    plane.emplace_back(short_way_deg(corner.longitude_deg() - corners.front().longitude_deg()),
                       corner.latitude_deg());
  return plane;
}

std::optional<std::string> flaw_of_polygon(const std::vector<Horizontal>& c) {
  const std::size_t n = c.size();
  if (n < 3) return formatted("found {} corners, expected three and more", n);
  for (std::size_t i = 0; i < n; ++i)
    if (c[i] == c[(i + 1) % n]) return "found a corner twice";
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // sides that share a corner
      if (meet(c[i], c[(i + 1) % n], c[j], c[(j + 1) % n]))
        return "its sides cross; list the corners in order round it";
    }
  return std::nullopt;
}

bool is_inside(const std::vector<Horizontal>& corners, Horizontal place) {
  bool is_in = false;
  const std::size_t n = corners.size();
  for (std::size_t i = 0, j = n - 1; i < n; j = i++) {
    const Horizontal a = corners[i] - place, b = corners[j] - place;
    if ((a.imag() > 0) == (b.imag() > 0)) continue;
    const double crossing = a.real() - a.imag() * (b.real() - a.real()) / (b.imag() - a.imag());
    if (crossing > 0) is_in = !is_in;
  }
  return is_in;
}

bool leads_through(const std::vector<Horizontal>& corners, Horizontal from, Horizontal to) {
  if (is_inside(corners, from) || is_inside(corners, to)) return true;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++)
    if (meet(corners[j], corners[i], from, to)) return true;
  return false;
}

}  // namespace slackwater
