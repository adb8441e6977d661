#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "api/ask/render/rendered_run.h"

namespace slackwater::api {

/// The pings of a sonar that tells a line at a time, one beside the other, as operators see them:
///
/// - side-scan: the newest below, port to the left, far off outside; 60 dB of echo, each brought to
///   the level that it would have 1 m off (r^3 for a grazed bed, and what the water took).
/// - multibeam: the newest below, port to the left: depths told, shallow bright, none black.
/// - echo sounder: the newest on the right, near above: 60 dB of echo, brought to the level of r^2.
/// - ADCP: the newest on the right, near above: speed of the water over ground told, fast bright,
///   none black.
///
/// Of more than 8192 pings every second one is drawn, or every fourth, and so on.
class Waterfall {
 public:
  /// Whether a view is a line, and no picture by itself.
  [[nodiscard]] static bool has_line(const RenderView& view) noexcept;

  /// The next ping of the same sensor; no line: adds nothing.
  void add(const RenderView& view);
  [[nodiscard]] bool is_empty() const noexcept { return lines_.empty(); }
  /// As a grey PNG. @throws Error(unavailable)
  void write(const std::filesystem::path& file) const;

 private:
  static constexpr std::size_t most_lines = 8192;
  enum class Tone { none, echo, near_bright, far_bright };

  std::vector<std::vector<float>> lines_;  ///< NaN: black
  Tone tone_ = Tone::none;
  bool newest_is_right_ = false;
  std::size_t added_ = 0;
  std::size_t stride_ = 1;
};

}  // namespace slackwater::api
