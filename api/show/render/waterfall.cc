#include "api/show/render/waterfall.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "api/show/render/png_file.h"

namespace slackwater::api {
namespace {

constexpr float black = std::numeric_limits<float>::quiet_NaN();

std::vector<float> line_of(const CameraView&) { return {}; }
std::vector<float> line_of(const InfraredView&) { return {}; }
std::vector<float> line_of(const twin::LidarScan&) { return {}; }
std::vector<float> line_of(const twin::SonarImage&) { return {}; }

std::vector<float> line_of(const twin::SideScanPing& ping) {
  std::vector<float> line;
  const auto levelled = [&](twin::ScanSide side, int bin) {
    const double r = (bin + 0.5) * ping.bin_m;
    return static_cast<float>(static_cast<double>(ping.intensity[ping.place(side, bin)]) * r * r *
                              r * std::exp(ping.taken_per_m * r));
  };
  for (int bin = ping.bins - 1; bin >= 0; --bin)
    line.push_back(levelled(twin::ScanSide::port, bin));
  for (int bin = 0; bin < ping.bins; ++bin)
    line.push_back(levelled(twin::ScanSide::starboard, bin));
  return line;
}

std::vector<float> line_of(const MultibeamView& swath) {
  std::vector<float> line;
  for (const twin::Sounding& one : swath.soundings)
    line.push_back(std::isfinite(one.range_m) ? static_cast<float>(one.place_m.z) : black);
  return line;
}

std::vector<float> line_of(const twin::EchoSounding& sounding) {
  std::vector<float> line;
  for (std::size_t i = 0; i < sounding.intensity.size(); ++i) {
    const double r = (static_cast<double>(i) + 0.5) * sounding.bin_m;
    line.push_back(static_cast<float>(static_cast<double>(sounding.intensity[i]) * r * r));
  }
  return line;
}

std::vector<float> line_of(const twin::CurrentProfile& profile) {
  std::vector<float> line;
  for (const twin::ProfileBin& bin : profile.bins)
    line.push_back(static_cast<float>(length_of(bin.velocity_m_s)));
  return line;
}

/// From black, 0, to white, 255; what has a value is never black.
class Grey {
 public:
  explicit Grey(const std::vector<std::vector<float>>& lines) {
    for (const auto& line : lines)
      for (const float value : line)
        if (std::isfinite(value)) {
          least_ = std::min<double>(least_, value);
          most_ = std::max<double>(most_, value);
        }
  }
  /// Of 60 dB.
  [[nodiscard]] std::uint8_t of_echo(double value) const {
    constexpr double shown_db = 60;
    if (!(value > 0) || !(most_ > 0)) return 0;
    return of_share(std::clamp(1 + 10 * std::log10(value / most_) / shown_db, 0.0, 1.0), 0);
  }
  [[nodiscard]] std::uint8_t of_value(double value, bool is_far_bright) const {
    constexpr double darkest = 40;
    if (!std::isfinite(value)) return 0;
    const double share = most_ > least_ ? (value - least_) / (most_ - least_) : 0.5;
    return of_share(is_far_bright ? share : 1 - share, darkest);
  }

 private:
  static std::uint8_t of_share(double share, double darkest) {
    return static_cast<std::uint8_t>(darkest + (255 - darkest) * share);
  }
  double least_ = std::numeric_limits<double>::infinity();
  double most_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

bool Waterfall::has_line(const RenderView& view) noexcept {
  return std::holds_alternative<twin::SideScanPing>(view.seen) ||
         std::holds_alternative<MultibeamView>(view.seen) ||
         std::holds_alternative<twin::EchoSounding>(view.seen) ||
         std::holds_alternative<twin::CurrentProfile>(view.seen);
}

void Waterfall::add(const RenderView& view) {
  if (!has_line(view) || added_++ % stride_ != 0) return;
  newest_is_right_ = std::holds_alternative<twin::EchoSounding>(view.seen) ||
                     std::holds_alternative<twin::CurrentProfile>(view.seen);
  tone_ = std::holds_alternative<MultibeamView>(view.seen)          ? Tone::near_bright
          : std::holds_alternative<twin::CurrentProfile>(view.seen) ? Tone::far_bright
                                                                    : Tone::echo;
  lines_.push_back(std::visit([](const auto& seen) { return line_of(seen); }, view.seen));
  if (lines_.size() < most_lines) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < lines_.size(); i += 2) lines_[kept++] = std::move(lines_[i]);
  lines_.resize(kept);
  stride_ *= 2;
}

void Waterfall::write(const std::filesystem::path& file) const {
  const Grey grey(lines_);
  const std::size_t pings = lines_.size(), values = lines_.empty() ? 0 : lines_.front().size();
  const std::size_t wide = newest_is_right_ ? pings : values;
  std::vector<std::uint8_t> picture(pings * values, 0);
  for (std::size_t ping = 0; ping < pings; ++ping)
    for (std::size_t i = 0; i < values; ++i) {
      const auto value = static_cast<double>(lines_[ping][i]);
      picture[newest_is_right_ ? i * wide + ping : ping * wide + i] =
          tone_ == Tone::echo ? grey.of_echo(value)
                              : grey.of_value(value, tone_ == Tone::far_bright);
    }
  write_png(file, static_cast<int>(wide), static_cast<int>(newest_is_right_ ? values : pings), 1,
            picture);
}

}  // namespace slackwater::api
