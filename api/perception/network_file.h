#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/config.h"

namespace slackwater::api {

// What the file of a network says of it (network.h has the format).

/// How a picture goes in.
struct NetworkInput {
  std::array<double, 3> mean{};
  std::array<double, 3> sd{};
  int multiple_of = 0;                       ///< of each side; or
  std::optional<std::array<int, 2>> fitted;  ///< wide, high
};
struct HeadGrid {
  std::string output;
  int stride_px = 0;
};
struct HeadRows {
  std::string output;
  bool has_objectness = false;
  bool is_transposed = false;
};
/// What one head must say of the test's picture.
struct HeadSays {
  std::string output;
  std::vector<double> at;
  std::vector<double> is;
};
struct NetworkProof {
  int seed = 0;
  int wide = 0;
  int high = 0;
  std::vector<HeadSays> heads;
};
struct NetworkFile {
  std::vector<std::string> kinds;
  NetworkInput input;
  std::vector<HeadGrid> grids;
  std::optional<HeadRows> rows;
  double least_confidence = 0.25;
  double most_overlap = 0.5;
  NetworkProof proof;
};

/// All but `file` and `sha256`. @throws Error(invalid_input) that names the key
[[nodiscard]] NetworkFile read_network_file(const Config& config);

}  // namespace slackwater::api
