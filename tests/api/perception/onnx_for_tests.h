#pragma once
#include <string>
#include <vector>

namespace slackwater::tests {

/// One convolution without padding whose kernel is as wide as its stride, as an ONNX file says it:
/// output(o, i, j) = bias(o) + sum over c of weight(o, c) times the mean of plane c in the cell.
struct MeansOfCells {
  int stride_px = 8;
  std::vector<std::vector<float>> weight;  ///< outputs x 3
  std::vector<float> bias;
  std::string output = "head";
};

/// The bytes of the file (protobuf, by hand: onnx.proto3, IR version 7, operators 11).
[[nodiscard]] std::string onnx_of(const MeansOfCells& network);

}  // namespace slackwater::tests
