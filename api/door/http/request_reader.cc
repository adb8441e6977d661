#include "api/door/http/request_reader.h"

#include <algorithm>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <iterator>
#include <optional>

#include "api/door/http/field_list.h"
#include "api/door/http/framing.h"
#include "api/door/http/request_lines.h"

namespace slackwater::api::http {
namespace {

namespace beast = boost::beast;
using beast::http::error;
using beast::http::field;
using ErrorCode = boost::system::error_code;
using Parser = beast::http::request_parser<beast::http::string_body>;

constexpr std::size_t read_bytes = std::size_t{16} * 1024;

std::string text_of(boost::string_view text) { return {text.data(), text.size()}; }

/// All fields of a name, joined as a list (RFC 9110 §5.3).
std::string list_of(const beast::http::fields& fields, field name) {
  std::string list;
  const auto range = fields.equal_range(name);
  for (auto one = range.first; one != range.second; ++one) {
    list += (list.empty() ? "" : ", ") + text_of(one->value());
  }
  return list;
}

bool has_item(const std::string& list, std::string_view name) {
  bool found = false;
  for_each_item(list, [&](std::string_view item) { found |= equal_ignoring_case(item, name); });
  return found;
}

UpgradeFields upgrade_of(const beast::http::fields& fields) {
  UpgradeFields upgrade;
  upgrade.is_to_websocket = has_item(list_of(fields, field::connection), "upgrade") &&
                            has_item(list_of(fields, field::upgrade), "websocket");
  if (!upgrade.is_to_websocket) return upgrade;
  upgrade.version = list_of(fields, field::sec_websocket_version);
  upgrade.key = list_of(fields, field::sec_websocket_key);
  return upgrade;
}

/// But for the body; what follows that as trailers is read over, and says nothing.
Arrival arrival_of(const Parser::value_type& message) {
  Arrival arrival;
  Request& request = arrival.request;
  request.method = text_of(message.method_string());
  const std::string target = text_of(message.target());
  const std::size_t question = target.find('?');
  request.path = target.substr(0, question);
  if (question != std::string::npos) request.query = target.substr(question + 1);
  request.host = text_of(message[field::host]);
  request.accept = list_of(message, field::accept);
  request.content_type = list_of(message, field::content_type);
  arrival.is_http_1_1 = message.version() >= 11;
  arrival.keep_alive = message.keep_alive();
  arrival.is_forwarded = message.count(field::forwarded) + message.count("X-Forwarded-For") > 0;
  arrival.host_fields = message.count(field::host);
  arrival.accept_encoding = list_of(message, field::accept_encoding);
  arrival.if_none_match = list_of(message, field::if_none_match);
  request.authorization = text_of(message[field::authorization]);
  request.origin = text_of(message[field::origin]);
  request.protocols = list_of(message, field::sec_websocket_protocol);
  if (arrival.is_http_1_1) arrival.upgrade = upgrade_of(message);
  return arrival;
}

}  // namespace

struct RequestReader::Parsing {
  explicit Parsing(const Limits& of)
      : limits(of), buffer(2 * read_bytes + of.url_bytes + of.header_bytes) {}

  void begin() {
    parser.emplace();
    parser->header_limit(static_cast<std::uint32_t>(limits.header_bytes + limits.url_bytes));
    parser->body_limit(limits.body_bytes);
    header_is_checked = false;
    header_lines = {};
    chunk_lines = {};
    is_chunked = false;
    looked_through = 0;
  }

  Progress refuse(int status, std::string detail) {
    refusal = {status, std::move(detail)};
    return Progress::refused;
  }

  Progress refuse_url() {
    return refuse(414, "The target of a request holds at most " + std::to_string(limits.url_bytes) +
                           " bytes.");
  }

  /// A header that is too long because its first line never ends is a URL that is too long.
  [[nodiscard]] bool first_line_never_ends() const {
    const auto* text = static_cast<const char*>(buffer.data().data());
    const auto* end = text + std::min(buffer.size(), limits.url_bytes + 64);
    return parser->get().target().empty() && std::find(text, end, '\n') == end;
  }

  Progress refuse_bytes(const ErrorCode& problem) {
    if (problem == error::header_limit) {
      if (first_line_never_ends()) return refuse_url();
      return refuse(431, "The header of a request holds at most " +
                             std::to_string(limits.header_bytes) + " bytes.");
    }
    if (problem == error::body_limit) {
      return refuse(413, "The body of a request holds at most " +
                             std::to_string(limits.body_bytes) + " bytes.");
    }
    if (problem == error::bad_version) {
      return refuse(505, "This server speaks HTTP/1.1 and HTTP/1.0.");
    }
    if (problem == error::bad_content_length) {
      return refuse(400,
                    "Content-Length is no number here, or is there twice; it is one whole "
                    "number.");
    }
    return refuse(400, "This is not an HTTP/1.1 request: " + problem.message() + ".");
  }

  /// What is too much, once the header has come and before the body is read.
  std::optional<Progress> check_header() {
    header_is_checked = true;
    const auto& header = parser->get();
    if (header.target().size() > limits.url_bytes) return refuse_url();
    const auto fields = static_cast<std::size_t>(std::distance(header.begin(), header.end()));
    if (fields > limits.header_fields) {
      return refuse(431, "A request has at most " + std::to_string(limits.header_fields) +
                             " header fields; found " + std::to_string(fields) + ".");
    }
    if (auto fault = framing_fault(header.base(), limits.field_bytes))
      return refuse(fault->status, std::move(fault->detail));
    expects_continue = !parser->is_done() && beast::iequals(header[field::expect], "100-continue");
    is_chunked = parser->chunked();
    arrival = arrival_of(header);
    parser->eager(true);
    return std::nullopt;
  }

  /// Of the lines of a header, or of chunks, before they are read.
  std::optional<Progress> check_lines() {
    if (header_is_checked && !is_chunked) return std::nullopt;
    const std::string_view bytes{static_cast<const char*>(buffer.data().data()), buffer.size()};
    std::string_view left = bytes.substr(looked_through);
    auto fault = header_is_checked ? chunk_lines.take(left) : header_lines.take(left);
    looked_through = bytes.size() - left.size();
    if (!fault) return std::nullopt;
    return refuse(fault->status, std::move(fault->detail));
  }

  /// Lets the parser read what there is.
  void read(ErrorCode& problem) {
    const std::size_t taken = parser->put(buffer.data(), problem);
    buffer.consume(taken);
    looked_through -= std::min(looked_through, taken);
  }

  const Limits& limits;
  beast::flat_buffer buffer;
  std::optional<Parser> parser;
  Arrival arrival;
  HeaderLines header_lines;
  ChunkLines chunk_lines;
  bool is_chunked = false;
  std::size_t looked_through = 0;  ///< for them, of the buffer
  bool header_is_checked = false;
  bool expects_continue = false;
  Refusal refusal;
};

RequestReader::RequestReader(const Limits& limits) : parsing_(std::make_unique<Parsing>(limits)) {}
RequestReader::~RequestReader() = default;

std::span<char> RequestReader::room() {
  auto& buffer = parsing_->buffer;
  if (buffer.size() == 0 && buffer.capacity() > 4 * read_bytes) buffer.shrink_to_fit();
  const auto space = buffer.prepare(std::min(read_bytes, buffer.max_size() - buffer.size()));
  return {static_cast<char*>(space.data()), space.size()};
}

void RequestReader::received(std::size_t bytes) { parsing_->buffer.commit(bytes); }

RequestReader::Progress RequestReader::advance() {
  Parsing& parsing = *parsing_;
  if (!parsing.parser) parsing.begin();
  while (parsing.buffer.size() > 0) {
    ErrorCode problem;
    if (const auto refused = parsing.check_lines()) return *refused;
    parsing.read(problem);
    if (problem && problem != error::need_more) return parsing.refuse_bytes(problem);
    if (!parsing.header_is_checked && parsing.parser->is_header_done()) {
      if (const auto refused = parsing.check_header()) return *refused;
    }
    if (parsing.parser->is_done()) return Progress::complete;
    if (problem) break;
  }
  return Progress::needs_more;
}

Arrival RequestReader::take() {
  Arrival arrival = std::move(parsing_->arrival);
  arrival.request.body = std::move(parsing_->parser->get().body());
  parsing_->parser.reset();
  return arrival;
}

const Refusal& RequestReader::refusal() const noexcept { return parsing_->refusal; }

bool RequestReader::has_bytes() const noexcept { return parsing_->buffer.size() > 0; }

bool RequestReader::wants_continue() { return std::exchange(parsing_->expects_continue, false); }

}  // namespace slackwater::api::http
