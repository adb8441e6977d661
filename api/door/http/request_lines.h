#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "api/door/http/refusal.h"

namespace slackwater::api::http {

/// Looks through the bytes of a header as they come, to its empty line: for lines that are folded,
/// ends of lines that are half ones, and a first line that is not plain text.
class HeaderLines {
 public:
  /// Of the front of the bytes, those that are the header's are taken off.
  /// @return what is wrong with them; no bytes are to follow then
  [[nodiscard]] std::optional<Refusal> take(std::string_view& bytes);

 private:
  [[nodiscard]] std::optional<Refusal> take(char letter);
  char last_ = '\n';
  bool is_empty_ = false;    ///< the line so far
  bool has_begun_ = false;   ///< a line that is not empty has
  bool is_in_first_ = true;  ///< in that line
  bool is_over_ = false;
};

/// The same of a body in chunks (RFC 9112 §7.1), to the empty line behind its trailers: sizes in
/// hexadecimal digits alone, extensions and trailers of moderate length, whole ends of lines.
class ChunkLines {
 public:
  [[nodiscard]] std::optional<Refusal> take(std::string_view& bytes);

 private:
  enum class At {
    size,
    extension,
    size_end,
    data,
    data_cr,
    data_lf,
    line,
    name,
    value,
    line_lf,
    last
  };
  [[nodiscard]] std::optional<Refusal> take(char letter);
  [[nodiscard]] std::optional<Refusal> take_size(char letter);
  [[nodiscard]] std::optional<Refusal> take_more(char letter);
  At at_ = At::size;
  std::uint64_t left_ = 0;  ///< of the chunk
  std::size_t digits_ = 0;  ///< of its size
  std::size_t more_ = 0;    ///< bytes of extensions and trailers
  bool is_over_ = false;
};

}  // namespace slackwater::api::http
