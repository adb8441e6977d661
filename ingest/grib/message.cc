#include "ingest/grib/message.h"

#include <eccodes.h>

#include <cmath>
#include <limits>
#include <utility>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"

namespace slackwater::ingest::grib {
namespace {

/// Stands for a masked point while ecCodes packs or unpacks. No physical quantity comes near it.
constexpr double masked = -1.0e100;

/// ecCodes would print to stderr; its complaints come back as error codes too, and those we report.
void keep_quiet(const codes_context*, int, const char*) {}

/// ecCodes ends the process where a damaged message breaks an assumption of its own; this throws
/// instead, through its frames (they carry unwind tables), and what it was building is not freed.
[[noreturn]] void refuse_assertion(const char* message) {
  throw Error(ErrorKind::invalid_input, std::string("ecCodes says it is impossible (") + message +
                                            "); the file is damaged: download it again");
}

void silence_library() {
  static const bool silenced = [] {
    codes_set_codes_assertion_failed_proc(&refuse_assertion);
    codes_context_set_logging_proc(codes_context_get_default(), &keep_quiet);
    return true;
  }();
  static_cast<void>(silenced);
}

void check(int code, const std::string& message, const std::string& action) {
  if (code == GRIB_SUCCESS) return;
  const bool library_lacks_it = code == GRIB_FUNCTIONALITY_NOT_ENABLED;
  throw Error(library_lacks_it ? ErrorKind::unavailable : ErrorKind::invalid_input,
              message + ": " + action + " failed: " + codes_get_error_message(code) +
                  (library_lacks_it ? "; this build of ecCodes lacks that packing" : ""));
}

}  // namespace

Message::Message(std::vector<std::byte> bytes, std::string name)
    : bytes_(std::move(bytes)), name_(std::move(name)) {
  silence_library();
  handle_ = with_context(
      name_, [&] { return codes_handle_new_from_message(nullptr, bytes_.data(), bytes_.size()); });
  if (handle_ == nullptr) {
    throw Error(ErrorKind::invalid_input,
                name_ + ": ecCodes cannot read it; the file is damaged: download it again");
  }
}

Message Message::from_sample(const std::string& sample) {
  silence_library();
  Message message;
  message.name_ = "GRIB sample " + sample;
  message.handle_ = codes_grib_handle_new_from_samples(nullptr, sample.c_str());
  if (message.handle_ == nullptr) {
    throw Error(ErrorKind::unavailable,
                message.name_ + " is not there; install the data files of ecCodes");
  }
  return message;
}

Message::~Message() {
  if (handle_ != nullptr) codes_handle_delete(handle_);
}

Message::Message(Message&& other) noexcept
    : bytes_(std::move(other.bytes_)),
      name_(std::move(other.name_)),
      handle_(std::exchange(other.handle_, nullptr)) {}

Message& Message::operator=(Message&& other) noexcept {
  std::swap(bytes_, other.bytes_);
  std::swap(name_, other.name_);
  std::swap(handle_, other.handle_);
  return *this;
}

long Message::integer(const char* key) const {
  long value = 0;
  check(codes_get_long(handle_, key, &value), name_, std::string("reading ") + key);
  return value;
}

double Message::real(const char* key) const {
  double value = 0;
  check(codes_get_double(handle_, key, &value), name_, std::string("reading ") + key);
  return value;
}

std::string Message::text(const char* key) const {
  char buffer[1024] = {};
  std::size_t length = sizeof buffer - 1;
  check(codes_get_string(handle_, key, buffer, &length), name_, std::string("reading ") + key);
  return buffer;
}

std::optional<long> Message::integer_if_any(const char* key) const {
  long value = 0;
  if (codes_get_long(handle_, key, &value) != GRIB_SUCCESS) return std::nullopt;
  int error = 0;
  if (codes_is_missing(handle_, key, &error) != 0) return std::nullopt;
  return value;
}

std::optional<std::string> Message::text_if_any(const char* key) const {
  char buffer[1024] = {};
  std::size_t length = sizeof buffer - 1;
  if (codes_get_string(handle_, key, buffer, &length) != GRIB_SUCCESS) return std::nullopt;
  return std::string(buffer);
}

std::vector<long> Message::integers_if_any(const char* key) const {
  constexpr std::size_t most = 256;  // a count in one byte
  std::size_t count = 0;
  if (codes_get_size(handle_, key, &count) != GRIB_SUCCESS || count == 0 || count > most) return {};
  std::vector<long> found(count);
  if (codes_get_long_array(handle_, key, found.data(), &count) != GRIB_SUCCESS) return {};
  found.resize(count);
  return found;
}

std::vector<double> Message::values(std::size_t expected) {
  check(codes_set_double(handle_, "missingValue", masked), name_, "marking masked points");
  std::size_t count = 0;
  check(codes_get_size(handle_, "values", &count), name_, "counting the values");
  if (count != expected) {
    throw Error(ErrorKind::invalid_input, name_ + ": holds " + std::to_string(count) +
                                              " values for a grid of " + std::to_string(expected) +
                                              " points; the file is damaged");
  }
  // With a bitmap, the library takes memory for as many coded values as section 5 claims.
  const long coded = integer_if_any("numberOfCodedValues").value_or(0);
  constexpr long padding = 64;
  if (coded < 0 || coded > static_cast<long>(expected) + padding) {
    throw Error(ErrorKind::invalid_input,
                name_ + ": claims " + std::to_string(coded) + " coded values for a grid of " +
                    std::to_string(expected) + " points; the file is damaged");
  }
  std::vector<double> values(count);
  check(codes_get_double_array(handle_, "values", values.data(), &count), name_,
        "unpacking the values");
  for (double& value : values) {
    const bool storable = std::abs(value) <= std::numeric_limits<float>::max();
    if (value == masked || !storable) value = constants::nan;
  }
  return values;
}

void Message::set(const char* key, long value) {
  check(codes_set_long(handle_, key, value), name_, std::string("setting ") + key);
}

void Message::set(const char* key, double value) {
  check(codes_set_double(handle_, key, value), name_, std::string("setting ") + key);
}

void Message::set(const char* key, const std::string& value) {
  std::size_t length = value.size();
  check(codes_set_string(handle_, key, value.c_str(), &length), name_,
        std::string("setting ") + key + " to " + value);
}

void Message::set_values(std::span<const double> values) {
  std::vector<double> packed(values.begin(), values.end());
  bool any_masked = false;
  for (double& value : packed) {
    if (std::isnan(value)) {
      value = masked;
      any_masked = true;
    }
  }
  check(codes_set_double(handle_, "missingValue", masked), name_, "marking masked points");
  set("bitmapPresent", any_masked ? 1L : 0L);
  check(codes_set_double_array(handle_, "values", packed.data(), packed.size()), name_,
        "packing the values");
}

std::vector<std::byte> Message::bytes() const {
  const void* data = nullptr;
  std::size_t size = 0;
  check(codes_get_message(handle_, &data, &size), name_, "coding the message");
  const auto* first = static_cast<const std::byte*>(data);
  return {first, first + size};
}

}  // namespace slackwater::ingest::grib
