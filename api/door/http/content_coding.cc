#include "api/door/http/content_coding.h"

#include <zlib.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "api/door/http/field_list.h"
#include "fields/base/check.h"

namespace slackwater::api::http {
namespace {

constexpr int level = 4;
constexpr int gzip_window = 15 + 16;
constexpr std::size_t smallest_coded_bytes = 1024;

/// The q of "gzip;q=0.5": 1 where it is not given, nothing where it makes no sense.
std::optional<double> quality_of(std::string_view parameters) {
  const std::size_t at = parameters.find("q=");
  if (at == std::string_view::npos) return 1.0;
  const std::string_view text = trimmed(parameters.substr(at + 2));
  double q = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), q);
  const bool whole = problem == std::errc() && end == text.data() + text.size();
  if (!whole || !(q >= 0 && q <= 1)) return std::nullopt;
  return q;
}

/// One compressor, reset between bodies: its 256 kB are allocated once a thread.
class Compressor {
 public:
  Compressor() {
    const int code = deflateInit2(&stream_, level, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY);
    expects(code == Z_OK, "zlib has memory for a compressor");
  }
  ~Compressor() { deflateEnd(&stream_); }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  std::string compress(std::string_view body) {
    deflateReset(&stream_);
    std::string coded(deflateBound(&stream_, body.size()), '\0');
    // zlib's input pointer is not const but is not written through.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(body.data()));
    stream_.avail_in = static_cast<uInt>(body.size());
    stream_.next_out = reinterpret_cast<Bytef*>(coded.data());
    stream_.avail_out = static_cast<uInt>(coded.size());
    expects(deflate(&stream_, Z_FINISH) == Z_STREAM_END, "deflateBound holds the coded body");
    return coded.substr(0, stream_.total_out);
  }

 private:
  z_stream stream_{};
};

}  // namespace

bool prefers_gzip(std::string_view accept_encoding) {
  std::optional<double> gzip_q;
  std::optional<double> any_q;
  double plain_q = 1e-3;  // acceptable unless refused, but a client that names gzip would have it
  for_each_item(accept_encoding, [&](std::string_view item) {
    const std::size_t semicolon = item.find(';');
    const std::string_view coding = trimmed(item.substr(0, semicolon));
    const auto q = quality_of(semicolon == std::string_view::npos ? "" : item.substr(semicolon));
    if (!q) return;
    if (equal_ignoring_case(coding, "gzip") || equal_ignoring_case(coding, "x-gzip")) gzip_q = *q;
    if (coding == "*") any_q = *q;
    if (equal_ignoring_case(coding, "identity")) plain_q = *q;
  });
  const double q = gzip_q.value_or(any_q.value_or(0));
  return q > 0 && q >= plain_q;
}

bool is_worth_coding(std::string_view media_type, std::size_t body_bytes) {
  if (body_bytes < smallest_coded_bytes) return false;
  const std::string_view type = trimmed(media_type.substr(0, media_type.find(';')));
  return type.starts_with("text/") || type.ends_with("json") || type.ends_with("xml") ||
         type.ends_with("javascript") || type.ends_with("yaml");
}

std::string gzip(std::string_view body) {
  expects(body.size() < (1ULL << 32U) - (1ULL << 20U), "a body of less than 4 GiB");
  thread_local Compressor compressor;
  return compressor.compress(body);
}

}  // namespace slackwater::api::http
