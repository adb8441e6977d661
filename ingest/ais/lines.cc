#include "ingest/ais/lines.h"

#include "fields/base/error.h"

namespace slackwater::ingest {
namespace {
constexpr std::size_t block_bytes = 65536;
}

Lines::Lines(const std::filesystem::path& file) : stream_(file, std::ios::binary) {
  if (!stream_ || std::filesystem::is_directory(file)) {
    throw Error(ErrorKind::not_found, "cannot read " + file.string() + "; expected a file");
  }
}

std::optional<TextLine> Lines::next() {
  line_.clear();
  bool is_too_long = false;
  bool has_any = false;
  while (true) {
    if (at_ == block_.size()) {
      block_.resize(block_bytes);
      stream_.read(block_.data(), static_cast<std::streamsize>(block_bytes));
      block_.resize(static_cast<std::size_t>(stream_.gcount()));
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
