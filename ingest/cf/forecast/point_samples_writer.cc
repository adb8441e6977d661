#include "ingest/cf/forecast/point_samples_writer.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "fields/base/check.h"
#include "ingest/cf/forecast/forecast_names.h"

namespace slackwater::ingest {
namespace {

using netcdf::Type;
using netcdf::Writer;

constexpr const char* seconds = "seconds since 1970-01-01 00:00:00";

}  // namespace

PointSamplesWriter::PointSamplesWriter(const std::filesystem::path& file,
                                       const PointSamplesHead& head)
    : out_(Writer::create(file)),
      times_(head.time.size()),
      depths_(head.depth_m.size()),
      members_(head.members) {
  expects(!head.points.empty() && times_ > 0 && depths_ > 0 && members_ > 0,
          "samples are of points, times, depths and a member");
  expects(head.names.empty() || head.names.size() == head.points.size(), "a name for each point");
  // CF wants an added dimension before those of time and place.
  if (members_ > 1) realization_ = out_.dimension("realization", members_ - 1);
  point_ = out_.dimension("point", head.points.size());
  time_ = out_.dimension("time", times_);
  depth_ = out_.dimension("depth", depths_);
  point_id_ = out_.variable("point", Type::int32, {point_});
  out_.attribute(point_id_, "long_name", "number of the point as asked, from 1");
  out_.attribute(point_id_, "cf_role", "timeseries_id");
  for (const std::string& name : head.names) letters_ = std::max(letters_, name.size());
  if (letters_ > 0) {
    const int letters = out_.dimension("name_length", letters_);
    name_id_ = out_.variable("point_name", Type::character, {point_, letters});
    out_.attribute(name_id_, "long_name", "name of the point as asked");
  }
  latitude_id_ =
      define_axis("latitude", point_, {{"standard_name", "latitude"}, {"units", "degrees_north"}});
  longitude_id_ =
      define_axis("longitude", point_, {{"standard_name", "longitude"}, {"units", "degrees_east"}});
  time_id_ = define_axis("time", time_,
                         {{"standard_name", "time"},
                          {"long_name", "valid time"},
                          {"units", seconds},
                          {"calendar", "standard"},
                          {"axis", "T"}});
  depth_id_ = define_axis("depth", depth_,
                          {{"standard_name", "depth"},
                           {"long_name", "depth below mean sea level"},
                           {"units", "m"},
                           {"positive", "down"},
                           {"axis", "Z"}});
  reference_id_ = out_.variable("forecast_reference_time", Type::float64, {});
  out_.attribute(reference_id_, "standard_name", "forecast_reference_time");
  out_.attribute(reference_id_, "long_name", "end of the last calibrated day");
  out_.attribute(reference_id_, "units", seconds);
  out_.attribute(reference_id_, "calendar", "standard");
  period_id_ = define_axis("forecast_period", time_,
                           {{"standard_name", "forecast_period"},
                            {"long_name", "lead since the end of the last calibrated day"},
                            {"units", "hours"}});
  define_currents();
  out_.attribute(Writer::global, "Conventions", "CF-1.8");
  out_.attribute(Writer::global, "featureType", "timeSeriesProfile");
  for (const auto& [name, text] : head.attributes) out_.attribute(Writer::global, name, text);
  out_.end_definitions();
  write_axes(head);
}

int PointSamplesWriter::define_axis(
    const std::string& name, int dimension,
    const std::vector<std::pair<std::string, std::string>>& attributes) {
  const int id = out_.variable(name, Type::float64, {dimension});
  for (const auto& [key, text] : attributes) out_.attribute(id, key, text);
  return id;
}

int PointSamplesWriter::define(const std::string& name, Type type,
                               const std::vector<int>& dimensions, const std::string& long_name) {
  Writer::Layout layout;
  layout.is_prefilled = false;
  if (type == Type::float32) layout.fill_value = static_cast<double>(fill);
  const int id = out_.variable(name, type, dimensions, layout);
  out_.attribute(id, "long_name", long_name);
  out_.attribute(id, "coordinates",
                 letters_ > 0 ? "time depth latitude longitude point point_name"
                              : "time depth latitude longitude point");
  if (type == Type::float32) out_.attribute(id, "units", "m s-1");
  return id;
}

void PointSamplesWriter::define_currents() {
  const std::vector<int> central{point_, time_, depth_};
  const auto component = [&](const std::string& standard_name, const std::string& long_name,
                             const std::string& suffix, const std::vector<int>& dimensions) {
    const int id = define(standard_name + suffix, Type::float32, dimensions, long_name);
    out_.attribute(id, "standard_name", standard_name);
    out_.attribute(id, "ancillary_variables", forecast_names::status);
    return id;
  };
  east_id_ = component(forecast_names::east, "eastward current, Eulerian", "", central);
  north_id_ = component(forecast_names::north, "northward current, Eulerian", "", central);
  status_id_ =
      define(forecast_names::status, Type::int8, central, "why a current is, or is not, there");
  const std::vector<double> flags{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  out_.attribute(status_id_, "flag_values", flags, Type::int8);
  out_.attribute(
      status_id_, "flag_meanings",
      "ok missing land below_bed outside_area outside_time above_surface not_checked suspect "
      "carried");
  if (members_ < 2) return;
  const std::vector<int> members{realization_, point_, time_, depth_};
  realization_id_ = out_.variable("realization", Type::int32, {realization_});
  out_.attribute(realization_id_, "standard_name", "realization");
  out_.attribute(realization_id_, "long_name", "number of the member; 0 is the central forecast");
  out_.attribute(realization_id_, "units", "1");
  east_member_id_ =
      component(forecast_names::east, "eastward current of a member", "_member", members);
  north_member_id_ =
      component(forecast_names::north, "northward current of a member", "_member", members);
}

void PointSamplesWriter::write_axes(const PointSamplesHead& head) {
  std::vector<double> latitude;
  std::vector<double> longitude;
  for (const GeoPoint& point : head.points) {
    latitude.push_back(point.latitude_deg());
    longitude.push_back(point.longitude_deg());
  }
  std::vector<double> number(head.points.size());
  std::iota(number.begin(), number.end(), 1.0);
  out_.write_all(point_id_, number);
  std::string letters;
  for (std::string name : head.names) {
    name.resize(letters_, '\0');
    letters += name;
  }
  if (letters_ > 0) out_.write_text(name_id_, letters);
  out_.write_all(latitude_id_, latitude);
  out_.write_all(longitude_id_, longitude);
  std::vector<double> time;
  std::vector<double> lead;
  for (const UtcTime stamp : head.time) {
    time.push_back(seconds_between(UtcTime{}, stamp));
    lead.push_back(hours_between(head.reference, stamp));
  }
  out_.write_all(time_id_, time);
  out_.write_all(period_id_, lead);
  out_.write_all(reference_id_, std::vector{seconds_between(UtcTime{}, head.reference)});
  out_.write_all(depth_id_, head.depth_m);
  if (members_ < 2) return;
  std::vector<double> member(members_ - 1);
  std::iota(member.begin(), member.end(), 1.0);
  out_.write_all(realization_id_, member);
}

void PointSamplesWriter::write(std::size_t member, std::size_t first_point,
                               std::span<const float> east_m_s, std::span<const float> north_m_s) {
  expects(member < members_, "a member that the file was made for");
  expects(east_m_s.size() == north_m_s.size() && east_m_s.size() % (times_ * depths_) == 0,
          "both components of whole points");
  const std::size_t points = east_m_s.size() / (times_ * depths_);
  const bool is_central = member == 0;
  // Of a member, with `realization` in front.
  const std::array<std::size_t, 4> start{is_central ? 0 : member - 1, first_point, 0, 0};
  const std::array<std::size_t, 4> count{1, points, times_, depths_};
  const std::size_t skipped = is_central ? 1 : 0;
  const auto from = std::span(start).subspan(skipped);
  const auto extent = std::span(count).subspan(skipped);
  out_.write(is_central ? east_id_ : east_member_id_, from, extent, east_m_s);
  out_.write(is_central ? north_id_ : north_member_id_, from, extent, north_m_s);
}

void PointSamplesWriter::write_status(std::size_t first_point,
                                      std::span<const std::int8_t> status) {
  expects(status.size() % (times_ * depths_) == 0, "statuses of whole points");
  out_.write(status_id_, std::vector<std::size_t>{first_point, 0, 0},
             std::vector{status.size() / (times_ * depths_), times_, depths_}, status);
}

void PointSamplesWriter::close() { out_.close(Writer::Durable::no); }

}  // namespace slackwater::ingest
