#include "fields/service/sample_points.h"

#include <algorithm>
#include <thread>

#include "fields/base/parallel.h"

namespace slackwater {
namespace {

/// Values of a block: with the status 2.3 MiB, which the cache holds until they are written.
constexpr std::size_t block_values = std::size_t{1} << 18;
/// Fewer are sampled sooner than a thread starts.
constexpr std::size_t values_worth_a_thread = std::size_t{1} << 16;

struct Buffers {
  std::vector<float> east;
  std::vector<float> north;
  std::vector<std::int8_t> status;
};

void sample_point(const Field& field, const SampleGrid& grid, const GeoPoint& point,
                  std::size_t member, float no_value, std::size_t offset, Buffers& out) {
  std::vector<CurrentSample> samples(grid.per_point());
  field.sample_profiles(point.longitude_deg(), point.latitude_deg(), grid.time, grid.depth_m,
                        samples, member);
  for (const CurrentSample& sample : samples) {
    const bool is_there = has_value(sample.status);
    out.east[offset] = is_there ? static_cast<float>(sample.velocity_m_s.real()) : no_value;
    out.north[offset] = is_there ? static_cast<float>(sample.velocity_m_s.imag()) : no_value;
    if (member == 0) out.status[offset] = static_cast<std::int8_t>(sample.status);
    ++offset;
  }
}

void count(std::span<const std::int8_t> status, StatusCounts& counts) {
  for (const std::int8_t s : status) ++counts[static_cast<std::size_t>(s)];
}

}  // namespace

StatusCounts sample_points(const Field& field, const SampleGrid& grid, std::size_t members,
                           float no_value, const std::function<void(const SampleBlock&)>& take) {
  StatusCounts counts{};
  const std::size_t per_point = grid.per_point();
  const std::size_t per_block =
      std::clamp<std::size_t>(block_values / per_point, 1, grid.points.size());
  Buffers out;
  out.east.resize(per_block * per_point);
  out.north.resize(out.east.size());
  out.status.resize(out.east.size());
  const auto cores = static_cast<std::size_t>(std::max(1U, std::thread::hardware_concurrency()));
  const std::size_t threads =
      std::clamp<std::size_t>(out.east.size() / values_worth_a_thread, 1, cores);
  for (std::size_t first = 0; first < grid.points.size(); first += per_block) {
    const std::size_t points = std::min(per_block, grid.points.size() - first);
    const std::size_t values = points * per_point;
    for (std::size_t member = 0; member < members; ++member) {
      for_all(points, static_cast<int>(threads), [&](std::size_t i) {
        sample_point(field, grid, grid.points[first + i], member, no_value, i * per_point, out);
      });
      take({first, member, std::span(out.east).first(values), std::span(out.north).first(values),
            std::span(out.status).first(values)});
    }
    count(std::span(out.status).first(values), counts);
  }
  return counts;
}

}  // namespace slackwater
