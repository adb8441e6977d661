#include "api/door/http/request_lines.h"

#include <algorithm>

#include "api/door/http/letters.h"
#include "fields/base/encode/percent.h"
#include "fields/base/text.h"

namespace slackwater::api::http {
namespace {

constexpr std::size_t most_digits = 16;  ///< of the size of a chunk
constexpr std::size_t most_more = 8192;

/// Of a byte, for its sender.
std::string shown(char letter) {
  return formatted("the byte {:#04x}", static_cast<unsigned>(static_cast<unsigned char>(letter)));
}

Refusal half_an_end(const char* of, char letter) {
  return {400, formatted("Found {} at the end of a line of {}; lines end with CR LF.",
                         shown(letter), of)};
}

}  // namespace

std::optional<Refusal> HeaderLines::take(char letter) {
  const bool begins_line = last_ == '\n';
  if ((last_ == '\r') != (letter == '\n')) return half_an_end("the header", letter);
  if (begins_line && has_begun_ && letters::is_space(letter))
    return Refusal{400, "A line of the header begins with a space; each field is one line."};
  is_empty_ = (begins_line && letter == '\r') || (letter == '\n' && is_empty_);
  is_over_ = letter == '\n' && is_empty_ && has_begun_;
  if (is_in_first_ && has_begun_ && letter == '\n') is_in_first_ = false;
  if (is_in_first_ && !letters::is_end_of_line(letter) && letter != ' ' &&
      !letters::is_plain(letter))
    return Refusal{400,
                   formatted("The first line holds {}; write it percent-encoded.", shown(letter))};
  has_begun_ = has_begun_ || (letter != '\r' && letter != '\n');
  last_ = letter;
  return std::nullopt;
}

std::optional<Refusal> HeaderLines::take(std::string_view& bytes) {
  while (!bytes.empty() && !is_over_) {
    if (auto fault = take(bytes.front())) return fault;
    bytes.remove_prefix(1);
  }
  return std::nullopt;
}

std::optional<Refusal> ChunkLines::take_size(char letter) {
  const int digit = hexadecimal_digit(letter);
  if (digit >= 0) {
    if (++digits_ > most_digits)
      return Refusal{400, formatted("The size of a chunk has {} digits at most.", most_digits)};
    left_ = 16 * left_ + static_cast<std::uint64_t>(digit);
    return std::nullopt;
  }
  if (digits_ == 0 || (letter != ';' && letter != '\r'))
    return Refusal{400, formatted("Found {} in the size of a chunk; that is hexadecimal digits, "
                                  "and then ';' or CR LF.",
                                  shown(letter))};
  at_ = letter == ';' ? At::extension : At::size_end;
  return std::nullopt;
}

std::optional<Refusal> ChunkLines::take(char letter) {
  const auto wants = [&](char wanted, At next) -> std::optional<Refusal> {
    if (letter != wanted) return half_an_end("the body's chunks", letter);
    at_ = next;
    return std::nullopt;
  };
  switch (at_) {
    case At::size:
      return take_size(letter);
    case At::size_end:
      return wants('\n', left_ > 0 ? At::data : At::line);
    case At::data:
      if (--left_ == 0) at_ = At::data_cr;
      return std::nullopt;
    case At::data_cr:
      return wants('\r', At::data_lf);
    case At::data_lf:
      digits_ = 0;
      return wants('\n', At::size);
    case At::line_lf:
      return wants('\n', At::line);
    case At::last:
      is_over_ = letter == '\n';
      return wants('\n', At::last);
    default:
      return take_more(letter);
  }
}

/// Extensions and trailers: nobody here asks what they say.
std::optional<Refusal> ChunkLines::take_more(char letter) {
  if (++more_ > most_more)
    return Refusal{431,
                   formatted("Extensions and trailers of chunks are {} bytes at most.", most_more)};
  if (at_ == At::line && letter == '\r') {
    at_ = At::last;
  } else if (at_ == At::line || at_ == At::name) {
    const bool is_end = letter == ':' && at_ == At::name;
    if (!is_end && !letters::is_of_name(letter))
      return Refusal{400, formatted("Found {} in the name of a trailer; that is a name, ':' and a "
                                    "value, on one line.",
                                    shown(letter))};
    at_ = is_end ? At::value : At::name;
  } else if (letter == '\r') {
    at_ = at_ == At::extension ? At::size_end : At::line_lf;
  } else if (letter == '\n') {
    return half_an_end("the body's chunks", letter);
  }
  return std::nullopt;
}

std::optional<Refusal> ChunkLines::take(std::string_view& bytes) {
  while (!bytes.empty() && !is_over_) {
    if (at_ == At::data && left_ > 1) {  // all but the last at once
      const auto skipped = std::min<std::uint64_t>(left_ - 1, bytes.size());
      left_ -= skipped;
      bytes.remove_prefix(static_cast<std::size_t>(skipped));
      continue;
    }
    if (auto fault = take(bytes.front())) return fault;
    bytes.remove_prefix(1);
  }
  return std::nullopt;
}

}  // namespace slackwater::api::http
