#include "api/door/people/wire/frame.h"

#include <cmath>

#include "session/session_generated.h"

namespace slackwater::people {
namespace {

/// Nothing that a station could see, and less than its screen shows.
constexpr float same_m = 0.005F, same_rad = 0.002F, same_m_s = 0.005F, same_share = 0.0005F;
/// Also when nothing moves, so that the age of what is seen is known.
constexpr std::uint64_t least_often_ms = 200;

bool near(float a, float b, float same) {
  return std::fabs(a - b) <= same || (std::isnan(a) && std::isnan(b));
}

bool looks_the_same(const Pose& a, const Pose& b) {
  return near(a.east_m, b.east_m, same_m) && near(a.north_m, b.north_m, same_m) &&
         near(a.up_m, b.up_m, same_m) && near(a.roll_rad, b.roll_rad, same_rad) &&
         near(a.pitch_rad, b.pitch_rad, same_rad) && near(a.heading_rad, b.heading_rad, same_rad) &&
         near(a.east_m_s, b.east_m_s, same_m_s) && near(a.north_m_s, b.north_m_s, same_m_s) &&
         near(a.up_m_s, b.up_m_s, same_m_s) &&
         near(a.current_east_m_s, b.current_east_m_s, same_m_s) &&
         near(a.current_north_m_s, b.current_north_m_s, same_m_s) &&
         near(a.bed_m, b.bed_m, 10 * same_m) && near(a.charge, b.charge, same_share) &&
         a.is_halted == b.is_halted;
}

}  // namespace

std::string encode_frame(const FrameHead& head, std::span<const Pose> poses,
                         std::span<const std::uint8_t> moved) {
  flatbuffers::FlatBufferBuilder builder(96 + moved.size() + sizeof(session::Pose) * poses.size());
  flatbuffers::Offset<flatbuffers::Vector<std::uint8_t>> bits;
  if (!moved.empty()) bits = builder.CreateVector(moved.data(), moved.size());
  session::Pose* all = nullptr;
  const auto vector = builder.CreateUninitializedVectorOfStructs(poses.size(), &all);
  for (const Pose& p : poses)
    *all++ = {p.east_m,           p.north_m,           p.up_m,
              p.roll_rad,         p.pitch_rad,         p.heading_rad,
              p.east_m_s,         p.north_m_s,         p.up_m_s,
              p.current_east_m_s, p.current_north_m_s, p.bed_m,
              p.charge,           p.vehicle,           p.is_halted,
              std::uint8_t{0}};
  session::FinishFrameBuffer(
      builder, session::CreateFrame(builder, head.number, head.step, head.time_s, head.clock_ms,
                                    head.is_whole, head.left_out, vector, bits));
  return {reinterpret_cast<const char*>(builder.GetBufferPointer()), builder.GetSize()};
}

std::string FrameFlow::next(std::span<const Pose> now, FrameHead head) {
  if (number_ - seen_ >= most_ahead) {
    ++left_out_;
    ++untold_;
    return {};
  }
  return is_brief_ ? next_moved(now, head) : next_changed(now, head);
}

bool FrameFlow::is_idle(std::uint64_t clock_ms) const noexcept {
  return !is_due_ && clock_ms < sent_ms_ + least_often_ms;
}

FrameHead FrameFlow::numbered(FrameHead head) noexcept {
  sent_ms_ = head.clock_ms;
  is_due_ = false;
  head.number = ++number_;
  head.left_out = left_out_;
  left_out_ = 0;
  return head;
}

std::string FrameFlow::next_changed(std::span<const Pose> now, FrameHead head) {
  head.is_whole = sent_.empty();
  changed_.clear();
  for (std::size_t i = 0; i < now.size(); ++i) {
    const bool is_new = i >= sent_.size();
    if (!is_new && looks_the_same(now[i], sent_[i])) continue;
    if (is_new)
      sent_.push_back(now[i]);
    else
      sent_[i] = now[i];
    changed_.push_back(now[i]);
  }
  if (changed_.empty() && is_idle(head.clock_ms)) return {};
  return encode_frame(numbered(head), changed_);
}

std::string FrameFlow::next_moved(std::span<const Pose> now, FrameHead head) {
  const bool is_news = moved_.look(now, head.time_s);
  if (!is_news && is_idle(head.clock_ms)) return {};
  head.is_whole = moved_.tell(now);
  return encode_frame(numbered(head), moved_.poses(), moved_.bits());
}

bool FrameFlow::saw(std::uint32_t frame) noexcept {
  if (frame > number_) return false;
  seen_ = std::max(seen_, frame);
  return true;
}

std::uint32_t FrameFlow::take_left_out() noexcept {
  const std::uint32_t untold = untold_;
  untold_ = 0;
  return untold;
}

}  // namespace slackwater::people
