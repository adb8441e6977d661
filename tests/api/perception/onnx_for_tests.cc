#include "tests/api/perception/onnx_for_tests.h"

#include <cstdint>
#include <cstring>

namespace slackwater::tests {
namespace {

std::string varint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7U) bytes += static_cast<char>(0x80U | (value & 0x7fU));
  return bytes + static_cast<char>(value);
}
std::string number(int field, std::uint64_t value) {
  return varint(static_cast<std::uint64_t>(field) << 3U) + varint(value);
}
std::string bytes(int field, const std::string& value) {
  return varint(static_cast<std::uint64_t>(field) << 3U | 2U) + varint(value.size()) + value;
}

std::string tensor(const std::string& name, const std::vector<int>& sides,
                   const std::vector<float>& values) {
  std::string raw(values.size() * sizeof(float), '\0');
  std::memcpy(raw.data(), values.data(), raw.size());
  std::string all;
  for (const int side : sides) all += number(1, static_cast<std::uint64_t>(side));
  return all + number(2, 1) + bytes(8, name) + bytes(9, raw);  // FLOAT
}

std::string integers(const std::string& name, const std::vector<int>& values) {
  std::string all = bytes(1, name);
  for (const int value : values) all += number(8, static_cast<std::uint64_t>(value));
  return all + number(20, 7);  // INTS
}

/// A picture of any size, or what comes of it.
std::string value_info(const std::string& name, int planes) {
  std::string shape =
      bytes(1, number(1, 1)) + bytes(1, number(1, static_cast<std::uint64_t>(planes)));
  shape += bytes(1, bytes(2, "h")) + bytes(1, bytes(2, "w"));
  return bytes(1, name) + bytes(2, bytes(1, number(1, 1) + bytes(2, shape)));
}

}  // namespace

std::string onnx_of(const MeansOfCells& network) {
  const auto outputs = static_cast<int>(network.weight.size());
  const int side = network.stride_px;
  std::vector<float> kernel;
  for (const std::vector<float>& of_planes : network.weight)
    for (const float weight : of_planes)
      kernel.insert(kernel.end(), static_cast<std::size_t>(side * side),
                    weight / static_cast<float>(side * side));
  const std::string node = bytes(1, "picture") + bytes(1, "kernel") + bytes(1, "bias") +
                           bytes(2, network.output) + bytes(4, "Conv") +
                           bytes(5, integers("kernel_shape", {side, side})) +
                           bytes(5, integers("strides", {side, side}));
  const std::string graph = bytes(1, node) + bytes(2, "means") +
                            bytes(5, tensor("kernel", {outputs, 3, side, side}, kernel)) +
                            bytes(5, tensor("bias", {outputs}, network.bias)) +
                            bytes(11, value_info("picture", 3)) +
                            bytes(12, value_info(network.output, outputs));
  return number(1, 7) + bytes(7, graph) + bytes(8, number(2, 11));
}

}  // namespace slackwater::tests
