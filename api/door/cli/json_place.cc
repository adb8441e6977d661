#include "api/door/cli/json_place.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

constexpr std::size_t largest = 256U << 20U;

/// A document nested deeper than that is no answer of ours.
constexpr int deepest_nesting = 32;

}  // namespace

void JsonPlace::refuse(const std::string& why) const {
  throw Error(ErrorKind::invalid_input, name_ + ": " + (path_.empty() ? "" : path_ + ": ") + why);
}

std::string JsonPlace::found() const {
  std::string text = value_->dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}

bool JsonPlace::has(const char* key) const {
  if (!value_->is_object()) refuse("found " + found() + " where an object was expected");
  return value_->contains(key) && !(*value_)[key].is_null();
}

JsonPlace JsonPlace::at(const char* key) const {
  if (!has(key)) refuse(std::string("found no '") + key + "', expected one");
  return {(*value_)[key], name_, path_.empty() ? key : path_ + "." + key};
}

std::size_t JsonPlace::size() const {
  if (!value_->is_array()) refuse("found " + found() + " where a list was expected");
  return value_->size();
}

JsonPlace JsonPlace::item(std::size_t i) const {
  return {(*value_)[i], name_, path_ + "[" + std::to_string(i) + "]"};
}

double JsonPlace::number(double least, double most) const {
  if (!value_->is_number()) refuse("found " + found() + " where a number was expected");
  const double number = value_->get<double>();
  if (!(number >= least && number <= most))
    refuse(formatted("found {:g}, expected {:g} to {:g}", number, least, most));
  return number;
}

std::string JsonPlace::text() const {
  if (!value_->is_string()) refuse("found " + found() + " where a text was expected");
  return value_->get<std::string>();
}

template <typename Parse>
auto JsonPlace::parsed(Parse parse) const {
  try {
    return parse(text());
  } catch (const Error& problem) {
    refuse(problem.message());
  }
}

UtcTime JsonPlace::time() const {
  return parsed([](const std::string& text) { return parse_utc(text); });
}

UtcDay JsonPlace::day() const {
  return parsed([](const std::string& text) { return parse_day(text); });
}

std::string document_text(const std::string& file) {
  std::ostringstream text;
  if (file == "-") {
    text << std::cin.rdbuf();
    return text.str();
  }
  return text_of_given_file(file, "a JSON file", largest);
}

nlohmann::json parse_document(std::string_view text, const std::string& name) {
  const auto shallow = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    if (depth > deepest_nesting)
      throw Error(ErrorKind::invalid_input,
                  name + ": nested deeper than 32 levels; this is none of ours");
    return true;
  };
  try {
    return nlohmann::json::parse(text, shallow);
  } catch (const nlohmann::json::parse_error& problem) {
    throw Error(ErrorKind::invalid_input,
                formatted("{}: not valid JSON at byte {} of {}; was it written to the end?", name,
                          problem.byte, text.size()));
  }
}

}  // namespace slackwater::api
