#pragma once
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "api/ask/render/render_view.h"
#include "ingest/netcdf/file.h"

namespace slackwater::api {

/// Variables of a view that share their dimensions: defined one after the other, and written once
/// all of the file is defined.
class ViewVariables {
 public:
  using Dimensions = std::initializer_list<std::pair<const char*, std::size_t>>;

  /// Makes the dimensions, slowest first.
  ViewVariables(ingest::netcdf::Writer& writer, Dimensions dimensions);
  /// A group over the dimensions of two others, the first's slower.
  ViewVariables(const ViewVariables& slow, const ViewVariables& fast);

  int add(const char* name, ingest::netcdf::Type type, const char* units, const char* words,
          std::vector<float> values);
  int add(const char* name, ingest::netcdf::Type type, const char* units, const char* words,
          std::vector<double> values);
  int add(const char* name, ingest::netcdf::Type type, const char* units, const char* words,
          std::vector<std::int64_t> values);
  /// Whole numbers of any type, and enumerators.
  template <typename Whole>
  int add(const char* name, ingest::netcdf::Type type, const char* units, const char* words,
          const std::vector<Whole>& values) {
    std::vector<std::int64_t> whole;
    whole.reserve(values.size());
    for (const Whole value : values) whole.push_back(static_cast<std::int64_t>(value));
    return add(name, type, units, words, std::move(whole));
  }
  void write();

 private:
  struct Pending {
    int id = 0;
    std::vector<float> numbers;
    std::vector<double> doubles;
    std::vector<std::int64_t> whole;
  };
  int define(const char* name, ingest::netcdf::Type type, const char* units, const char* words);

  ingest::netcdf::Writer* writer_;
  std::vector<std::size_t> counts_;
  std::vector<int> dimensions_;
  std::vector<Pending> pending_;
};

/// x east, y north, z up of NED.
[[nodiscard]] std::vector<double> enu_of(const twin::Triple<double>& ned);
/// What the numbers of `instance` stand for.
void say_names(ingest::netcdf::Writer& writer, std::span<const SeenName> things, int instance);
/// Of a sensor: its place, and the axes of what it sees, in the file's frame.
void say_where(ingest::netcdf::Writer& writer, const twin::Pose& pose);

}  // namespace slackwater::api
