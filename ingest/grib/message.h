#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

struct grib_handle;  // ecCodes' own; its members are known to message.cc alone

namespace slackwater::ingest::grib {

/// One GRIB message with one field, read or built through ecCodes. Every failure is an
/// Error(invalid_input) with the name of the message, the key and the library's own text. Not
/// thread-safe: one message, one thread.
class Message {
 public:
  /// Reads a message from its bytes, which it keeps. `name` appears in errors, e.g. "message 7 at
  /// byte 1200".
  Message(std::vector<std::byte> bytes, std::string name);
  /// A fresh message from a template of the library, e.g. "regular_ll_sfc_grib2".
  [[nodiscard]] static Message from_sample(const std::string& sample);
  ~Message();
  Message(Message&& other) noexcept;
  Message& operator=(Message&& other) noexcept;
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] long integer(const char* key) const;
  [[nodiscard]] double real(const char* key) const;
  [[nodiscard]] std::string text(const char* key) const;
  /// Nothing where the message does not have the key, or has it "missing".
  [[nodiscard]] std::optional<long> integer_if_any(const char* key) const;
  [[nodiscard]] std::optional<std::string> text_if_any(const char* key) const;
  /// All values of a key that may repeat; empty where the message does not have it.
  [[nodiscard]] std::vector<long> integers_if_any(const char* key) const;
  /// The `expected` values in the order of the message; NaN where the bitmap masks them. Refuses
  /// another count.
  [[nodiscard]] std::vector<double> values(std::size_t expected);

  void set(const char* key, long value);
  void set(const char* key, double value);
  void set(const char* key, const std::string& value);
  /// Packs the values; NaN becomes a masked point of the bitmap.
  void set_values(std::span<const double> values);
  [[nodiscard]] std::vector<std::byte> bytes() const;

 private:
  Message() = default;
  std::vector<std::byte> bytes_;  ///< ecCodes reads them in place
  std::string name_;
  grib_handle* handle_ = nullptr;
};

}  // namespace slackwater::ingest::grib
