#include "api/door/edr/read/bbox.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/number.h"
#include "api/door/edr/read/wkt.h"

namespace slackwater::api::edr {
namespace {

constexpr std::size_t max_bbox_bytes = 256;
constexpr std::string_view form =
    "four numbers, west,south,east,north in degrees, as in 2.3,57.2,2.5,57.3 (or six, with low and "
    "high levels as third and sixth)";

std::vector<double> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  std::string_view rest = text;
  for (;;) {
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    const auto number = take_number(rest);
    if (!number || (!rest.empty() && rest[0] != ',')) throw bad_parameter("bbox", text, form);
    numbers.push_back(*number);
    if (rest.empty()) return numbers;
    rest.remove_prefix(1);
  }
}

bool is_longitude(double value) { return value >= -180 && value <= 360; }
bool is_latitude(double value) { return value >= -90 && value <= 90; }

}  // namespace

BoundingBox parse_bbox(std::string_view text) {
  expect_short("bbox", text, max_bbox_bytes);
  const std::vector<double> numbers = numbers_of(text);
  if (numbers.size() != 4 && numbers.size() != 6) throw bad_parameter("bbox", text, form);
  const std::size_t half = numbers.size() / 2;
  BoundingBox read;
  read.box = {numbers[0], numbers[1], numbers[half], numbers[half + 1]};
  Box& box = read.box;
  if (!is_longitude(box.west_deg) || !is_longitude(box.east_deg)) {
    throw bad_parameter("bbox", text,
                        "longitudes in [-180, 360]; the order is west,south,east,north");
  }
  if (!is_latitude(box.south_deg) || !is_latitude(box.north_deg)) {
    throw bad_parameter("bbox", text, "latitudes in [-90, 90]; the order is west,south,east,north");
  }
  if (box.south_deg > box.north_deg) {
    throw bad_parameter("bbox", text, "south before north; the order is west,south,east,north");
  }
  if (box.west_deg > box.east_deg) {
    // West by its name in [-180, 180]; then east, by one of its names, is not west of it.
    if (box.west_deg > 180) box.west_deg -= 360;
    if (box.west_deg > box.east_deg) box.east_deg += 360;
  }
  if (half == 3) {
    if (!(numbers[2] <= numbers[5]) || std::abs(numbers[2]) > max_vertical_m ||
        std::abs(numbers[5]) > max_vertical_m) {
      throw bad_parameter("bbox", text, "the smaller level third and the greater sixth, in metres");
    }
    read.levels = LevelRange{numbers[2], numbers[5]};
  }
  return read;
}

}  // namespace slackwater::api::edr
