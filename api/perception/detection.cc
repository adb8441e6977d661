#include "api/perception/detection.h"

#include <algorithm>

namespace slackwater::api {
namespace {

double shared_area(const PixelBox& a, const PixelBox& b) noexcept {
  const double wide = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double high = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return wide > 0 && high > 0 ? wide * high : 0;
}

}  // namespace

double PixelBox::area() const noexcept {
  return std::max(0.0, right - left) * std::max(0.0, bottom - top);
}

double overlap(const PixelBox& a, const PixelBox& b) noexcept {
  const double shared = shared_area(a, b);
  return shared > 0 ? shared / (a.area() + b.area() - shared) : 0;
}

std::vector<Detection> surest_first(std::vector<Detection> found) {
  std::stable_sort(found.begin(), found.end(), [](const Detection& a, const Detection& b) {
    return a.confidence > b.confidence;
  });
  return found;
}

std::vector<Detection> without_doubles(std::vector<Detection> found, double most_overlap,
                                       std::size_t most) {
  std::vector<Detection> kept;
  for (Detection& one : surest_first(std::move(found))) {
    if (kept.size() == most) break;
    const bool is_double = std::any_of(kept.begin(), kept.end(), [&](const Detection& before) {
      return before.of == one.of && overlap(before.box, one.box) > most_overlap;
    });
    if (!is_double) kept.push_back(std::move(one));
  }
  return kept;
}

}  // namespace slackwater::api
