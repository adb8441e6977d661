#include "api/show/render/view_variables.h"

#include <algorithm>

#include "fields/base/text.h"

namespace slackwater::api {

using ingest::netcdf::Type;
using ingest::netcdf::Writer;

ViewVariables::ViewVariables(Writer& writer, Dimensions dimensions) : writer_(&writer) {
  for (const auto& [name, count] : dimensions) {
    counts_.push_back(count);
    dimensions_.push_back(writer.dimension(name, count));
  }
}

ViewVariables::ViewVariables(const ViewVariables& slow, const ViewVariables& fast)
    : writer_(slow.writer_), counts_(slow.counts_), dimensions_(slow.dimensions_) {
  counts_.insert(counts_.end(), fast.counts_.begin(), fast.counts_.end());
  dimensions_.insert(dimensions_.end(), fast.dimensions_.begin(), fast.dimensions_.end());
}

int ViewVariables::define(const char* name, Type type, const char* units, const char* words) {
  Writer::Layout layout;
  layout.chunks = counts_;
  if (counts_.size() > 1) layout.chunks.front() = std::min<std::size_t>(counts_.front(), 64);
  layout.deflate = 1;
  layout.is_prefilled = false;
  const int id = writer_->variable(name, type, dimensions_, layout);
  writer_->attribute(id, "units", units);
  writer_->attribute(id, "long_name", words);
  return id;
}

int ViewVariables::add(const char* name, Type type, const char* units, const char* words,
                       std::vector<float> values) {
  pending_.push_back({define(name, type, units, words), std::move(values), {}, {}});
  return pending_.back().id;
}

int ViewVariables::add(const char* name, Type type, const char* units, const char* words,
                       std::vector<double> values) {
  pending_.push_back({define(name, type, units, words), {}, std::move(values), {}});
  return pending_.back().id;
}

int ViewVariables::add(const char* name, Type type, const char* units, const char* words,
                       std::vector<std::int64_t> values) {
  pending_.push_back({define(name, type, units, words), {}, {}, std::move(values)});
  return pending_.back().id;
}

void ViewVariables::write() {
  const std::vector<std::size_t> start(counts_.size(), 0);
  for (const Pending& one : pending_) {
    if (!one.numbers.empty())
      writer_->write(one.id, start, counts_, one.numbers);
    else if (!one.doubles.empty())
      writer_->write(one.id, start, counts_, one.doubles);
    else
      writer_->write(one.id, start, counts_, one.whole);
  }
}

std::vector<double> enu_of(const twin::Triple<double>& ned) { return {ned.y, ned.x, -ned.z}; }

void say_names(Writer& writer, std::span<const SeenName> things, int instance) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < things.size(); ++i) {
    names.push_back(
        formatted("{} {} ({})", i + 1, things[i].name, twin::name_of(things[i].seen_class)));
  }
  writer.attribute(instance, "instances", joined(names, ", "));
}

void say_where(Writer& writer, const twin::Pose& pose) {
  const int of = Writer::global;
  writer.attribute(of, "frame", "x east, y north, z up of the origin at mean sea level, m");
  writer.attribute(of, "sensor_position", enu_of(pose.position_m), Type::float64);
  writer.attribute(of, "sensor_right", enu_of(pose.right), Type::float64);
  writer.attribute(of, "sensor_down", enu_of(cross(pose.axis, pose.right)), Type::float64);
  writer.attribute(of, "sensor_axis", enu_of(pose.axis), Type::float64);
}

}  // namespace slackwater::api
