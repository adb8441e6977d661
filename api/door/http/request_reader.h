#pragma once
#include <cstddef>
#include <memory>
#include <span>

#include "api/door/http/exchange.h"
#include "api/door/http/refusal.h"
#include "api/door/http/server_options.h"

namespace slackwater::api::http {

/// Makes requests of the bytes of one connection, however they are cut. Knows no sockets; one
/// thread. Memory is bounded by the limits.
class RequestReader {
 public:
  explicit RequestReader(const Limits& limits);  ///< which outlive it
  ~RequestReader();
  RequestReader(const RequestReader&) = delete;
  RequestReader& operator=(const RequestReader&) = delete;

  /// Room for bytes to come; say with `received` how many did.
  [[nodiscard]] std::span<char> room();
  void received(std::size_t bytes);

  enum class Progress {
    needs_more,  ///< bytes
    complete,    ///< `take` the request
    refused,     ///< see `refusal`; nothing more can be read from this connection
  };
  Progress advance();

  [[nodiscard]] Arrival take();
  [[nodiscard]] const Refusal& refusal() const noexcept;
  /// Whether bytes of the next request are here already.
  [[nodiscard]] bool has_bytes() const noexcept;
  /// Whether the header has come and its sender waits for "100 Continue"; true once a request.
  [[nodiscard]] bool wants_continue();

 private:
  struct Parsing;
  std::unique_ptr<Parsing> parsing_;
};

}  // namespace slackwater::api::http
