#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// What is known of a file of samples before the first of them.
struct PointSamplesHead {
  std::vector<GeoPoint> points;
  std::vector<UtcTime> time;    ///< ascending
  std::vector<double> depth_m;  ///< below mean sea level, ascending
  UtcTime reference;            ///< from which lead counts: the end of day D
  std::size_t members = 1;      ///< the central one among them
  std::vector<std::pair<std::string, std::string>> attributes;  ///< global, beside ours
  std::vector<std::string> names;  ///< of the points, as asked; empty: they have none
};

/// Currents at points x times x depths as a CF-1.8 NetCDF-4 file.
///
/// `eastward_` and `northward_sea_water_velocity` over (point, time, depth): the central forecast;
/// members 1, 2, … as `…_member` over (realization, point, time, depth);
/// `point_name` holds the names of the points where they have any;
/// `sea_water_velocity_status` says of each place why a value is, or is not, there. Single
/// precision, as sampled; a value that is not there is _FillValue, never NaN.
///
/// Points are written in blocks, so that memory does not grow with the file. Not fsynced: it can be
/// made again.
class PointSamplesWriter {
 public:
  /// @throws Error(unavailable) where the file cannot be made
  PointSamplesWriter(const std::filesystem::path& file, const PointSamplesHead& head);

  /// What the file holds where there is no value.
  static constexpr float fill = 9.9692099683868690e+36F;  // NC_FILL_FLOAT

  /// Currents of one member for the points from `first_point` on; whole points, depth fastest.
  void write(std::size_t member, std::size_t first_point, std::span<const float> east_m_s,
             std::span<const float> north_m_s);
  /// Their `SampleStatus`, the same for all members.
  void write_status(std::size_t first_point, std::span<const std::int8_t> status);
  /// Without it the file is discarded.
  void close();

 private:
  int define(const std::string& name, netcdf::Type type, const std::vector<int>& dimensions,
             const std::string& long_name);
  int define_axis(const std::string& name, int dimension,
                  const std::vector<std::pair<std::string, std::string>>& attributes);
  void define_currents();
  void write_axes(const PointSamplesHead& head);

  netcdf::Writer out_;
  std::size_t times_ = 0;
  std::size_t depths_ = 0;
  std::size_t members_ = 1;
  std::size_t letters_ = 0;  ///< of the longest name
  int point_ = 0, time_ = 0, depth_ = 0, realization_ = 0;
  int latitude_id_ = 0, longitude_id_ = 0, point_id_ = 0, time_id_ = 0, depth_id_ = 0,
      reference_id_ = 0, period_id_ = 0, realization_id_ = 0, east_id_ = 0, north_id_ = 0,
      east_member_id_ = 0, north_member_id_ = 0, status_id_ = 0, name_id_ = 0;
};

}  // namespace slackwater::ingest
