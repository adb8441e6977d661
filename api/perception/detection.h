#pragma once
#include <span>
#include <string>
#include <vector>

namespace slackwater::api {

/// A rectangle in a picture, pixels from its upper left corner: the first pixel is from 0 to 1.
struct PixelBox {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  [[nodiscard]] double area() const noexcept;
  bool operator==(const PixelBox&) const = default;
};

/// What two boxes have in common, of what they cover together: 0 apart, 1 equal.
[[nodiscard]] double overlap(const PixelBox& a, const PixelBox& b) noexcept;

/// A find that shares at least so much with what is there sends somebody to the right place: the
/// half that AP50 asks for is asked of who draws boxes.
inline constexpr double least_shared_to_be_found = 0.2;

/// What a detector believes to see.
struct Detection {
  std::string of;         ///< "corrosion"
  double confidence = 0;  ///< 0 to 1, by the detector's own measure: no probability
  PixelBox box;
};

/// Equal ones in their order.
[[nodiscard]] std::vector<Detection> surest_first(std::vector<Detection> found);

/// The surest of those of one kind that overlap by more than `most_overlap`, and at most `most` of
/// all: surest first, equal ones in their order.
[[nodiscard]] std::vector<Detection> without_doubles(std::vector<Detection> found,
                                                     double most_overlap, std::size_t most);

}  // namespace slackwater::api
