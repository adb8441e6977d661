#include "ingest/ais/lines.h"

#include <algorithm>

namespace slackwater::ingest {

Lines::Lines(const std::filesystem::path& file) : bytes_(file) {}

void Lines::go_to(std::uint64_t offset, std::uint64_t end) {
  bytes_.go_to(offset > 0 ? offset - 1 : 0, end);
  block_.clear();
  at_ = 0;
  if (offset > 0) (void)next();  // the rest of the line before
  number_ = 0;
}

std::optional<TextLine> Lines::next() {
  line_.clear();
  bool is_too_long = false;
  bool has_any = false;
  while (true) {
    if (at_ == block_.size()) {
      bytes_.next(block_);
      at_ = 0;
      if (block_.empty()) break;
    }
    has_any = true;
    const std::size_t end = block_.find('\n', at_);
    const std::size_t stop = end == std::string::npos ? block_.size() : end;
    const std::size_t room = most_characters - line_.size();
    is_too_long = is_too_long || stop - at_ > room;
    line_.append(block_, at_, std::min(stop - at_, room));
    at_ = stop;
    if (end != std::string::npos) {
      ++at_;
      break;
    }
  }
  if (!has_any) return std::nullopt;
  if (!line_.empty() && line_.back() == '\r') line_.pop_back();
  return TextLine{++number_, line_, is_too_long};
}

}  // namespace slackwater::ingest
