#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "fields/base/time.h"

namespace slackwater::api {

/// A value of a JSON document that somebody else wrote, and where it stands there:
/// "tasks[2].starts[0].probability". All that it refuses is an Error(invalid_input) that begins
/// with the document's name and the place.
class JsonPlace {
 public:
  JsonPlace(const nlohmann::json& value, std::string name)
      : value_(&value), name_(std::move(name)) {}

  [[nodiscard]] bool has(const char* key) const;
  /// The value of a key of an object. @throws where there is none
  [[nodiscard]] JsonPlace at(const char* key) const;
  [[nodiscard]] bool is_object() const { return value_->is_object(); }
  [[nodiscard]] std::size_t size() const;  ///< of a list
  [[nodiscard]] JsonPlace item(std::size_t i) const;
  [[nodiscard]] double number(double least, double most) const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] UtcTime time() const;  ///< of a text as `format_utc` writes it
  [[nodiscard]] UtcDay day() const;
  [[noreturn]] void refuse(const std::string& why) const;

 private:
  JsonPlace(const nlohmann::json& value, std::string name, std::string path)
      : value_(&value), name_(std::move(name)), path_(std::move(path)) {}
  template <typename Parse>
  [[nodiscard]] auto parsed(Parse parse) const;
  [[nodiscard]] std::string found() const;
  const nlohmann::json* value_;
  std::string name_;
  std::string path_;
};

/// The text of a file, "-" being standard input. @throws Error(not_found), Error(invalid_input) of
/// more than 256 MiB
[[nodiscard]] std::string document_text(const std::string& file);
/// @throws Error(invalid_input) for what is not JSON, with the place
[[nodiscard]] nlohmann::json parse_document(std::string_view text, const std::string& name);

}  // namespace slackwater::api
