#include "api/perception/network_file.h"

#include "fields/base/text.h"

namespace slackwater::api {
namespace {

std::array<double, 3> three(const Config& config, const char* key, Range range) {
  const std::vector<double> numbers = config.numbers(key, range);
  if (numbers.size() != 3) config.refuse(key, "expected three numbers: of red, green and blue");
  return {numbers[0], numbers[1], numbers[2]};
}

NetworkInput read_input(const Config& config) {
  NetworkInput input{three(config, "mean", {-10, 10}), three(config, "sd", {1e-6, 1e3}), 0, {}};
  if (config.has("wide") || config.has("high")) {
    input.fitted = {config.integer("wide", 16, 4096), config.integer("high", 16, 4096)};
    if (config.has("multiple_of"))
      config.refuse("multiple_of", "expected either a size or a multiple of both sides");
  } else {
    input.multiple_of = config.integer("multiple_of", 1, 512);
  }
  return input;
}

NetworkProof read_proof(const Config& config) {
  NetworkProof proof{config.integer("seed", 0, 1'000'000),
                     config.integer("wide", 16, 1024),
                     config.integer("high", 16, 1024),
                     {}};
  for (const Config& head : config.children("heads")) {
    HeadSays said{head.text("output"), head.numbers("at", {0, 1e9}), head.numbers("is", {})};
    if (said.at.empty() || said.at.size() != said.is.size())
      head.refuse("is",
                  formatted("found {} numbers for {} places", said.is.size(), said.at.size()));
    proof.heads.push_back(std::move(said));
  }
  if (proof.heads.empty())
    config.refuse("heads", "found none, expected what each head says of the test's picture");
  return proof;
}

}  // namespace

NetworkFile read_network_file(const Config& config) {
  NetworkFile model;
  model.kinds = config.texts("kinds");
  if (model.kinds.empty()) config.refuse("kinds", "found none, expected what it can find");
  model.input = read_input(config.child("input"));
  for (const Config& grid : config.children("grids"))
    model.grids.push_back({grid.text("output"), grid.integer("stride_px", 1, 256)});
  if (const auto rows = config.optional_child("rows"))
    model.rows = {rows->text("output"), rows->optional_flag("has_objectness").value_or(false),
                  rows->optional_flag("is_transposed").value_or(false)};
  if (model.grids.empty() == !model.rows.has_value())
    config.refuse("grids", "expected either grids or rows: how its outputs are to be read");
  for (const HeadGrid& grid : model.grids)
    if (!model.input.fitted && model.input.multiple_of % grid.stride_px != 0)
      config.refuse("grids",
                    formatted("found a stride of {} px, which does not divide the sides of "
                              "the input, multiples of {}",
                              grid.stride_px, model.input.multiple_of));
  model.least_confidence =
      config.optional_number("least_confidence", {0.001, 0.999}).value_or(model.least_confidence);
  model.most_overlap =
      config.optional_number("most_overlap", {0.05, 1}).value_or(model.most_overlap);
  model.proof = read_proof(config.child("test"));
  return model;
}

}  // namespace slackwater::api
