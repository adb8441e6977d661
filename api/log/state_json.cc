#include "api/log/state_json.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/run/command_numbers.h"
#include "twin/run/state_members.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

template <typename T>
std::span<const double> numbers_of(const T& value) {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
  return {reinterpret_cast<const double*>(&value), sizeof(T) / sizeof(double)};
}

template <typename T>
json written(const T& value) {
  if constexpr (std::is_same_v<T, double>) {
    return exact_text(value);
  } else if constexpr (std::is_enum_v<T>) {
    return static_cast<int>(value);
  } else if constexpr (std::is_integral_v<T>) {
    return value;
  } else if constexpr (twin::is_numbers<T>) {
    json list = json::array();
    for (const double number : numbers_of(value)) list.push_back(exact_text(number));
    return list;
  } else if constexpr (requires { value[0]; }) {
    json list = json::array();
    for (const auto& element : value) list.push_back(written(element));
    return list;
  } else {
    json object = json::object();
    twin::for_each_member(
        value, [&](const char* name, const auto& member) { object[name] = written(member); });
    return object;
  }
}

template <typename T>
void read(const json& from, T& value) {
  if constexpr (std::is_same_v<T, double>) {
    value = exact_number(from.get_ref<const std::string&>());
  } else if constexpr (std::is_enum_v<T>) {
    value = static_cast<T>(from.get<int>());
  } else if constexpr (std::is_integral_v<T>) {
    value = from.get<T>();
  } else if constexpr (twin::is_numbers<T>) {
    const std::size_t count = numbers_of(value).size();
    if (!from.is_array() || from.size() != count) refuse("not the numbers of this program's state");
    auto* number = reinterpret_cast<double*>(&value);
    for (std::size_t i = 0; i < count; ++i)
      number[i] = exact_number(from[i].get_ref<const std::string&>());
  } else if constexpr (std::is_array_v<T>) {
    if (!from.is_array() || from.size() != std::extent_v<T>) refuse("a list of another length");
    for (std::size_t i = 0; i < std::extent_v<T>; ++i) read(from[i], value[i]);
  } else if constexpr (requires { value.resize(1); }) {
    if (!from.is_array()) refuse("found no list where one belongs");
    value.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) read(from[i], value[i]);
  } else {
    twin::for_each_member(value,
                          [&](const char* name, auto& member) { read(from.at(name), member); });
  }
}

}  // namespace

std::string exact_text(double value) {
  return std::isnan(value) ? formatted("bits:{:016x}", std::bit_cast<std::uint64_t>(value))
                           : formatted("{:a}", value);
}

double exact_number(const std::string& text) {
  const bool is_bits = text.starts_with("bits:");
  const char* from = text.c_str() + (is_bits ? 5 : 0);
  char* end = nullptr;
  const double value = is_bits ? std::bit_cast<double>(std::uint64_t{std::strtoull(from, &end, 16)})
                               : std::strtod(from, &end);
  if (end == from || *end != '\0') refuse("found " + text + " where a number belongs");
  return value;
}

json state_json(const twin::AgentState& state) { return written(state); }

twin::AgentState state_of(const json& from) {
  twin::AgentState state;
  read(from, state);
  return state;
}

json commands_json(std::span<const twin::Command> commands) {
  json list = json::array();
  for (const twin::Command& command : commands)
    list.push_back({{"step", command.step},
                    {"agent", command.agent},
                    {"kind", twin::name_of(command.what)},
                    {"numbers", written(twin::numbers_of(command.what))},
                    {"source", command.source},
                    {"sequence", command.sequence},
                    {"received_s", written(command.received_s)}});
  return list;
}

std::vector<twin::Command> commands_of(const json& from) {
  std::vector<twin::Command> commands;
  for (const json& entry : from) {
    twin::Command command;
    read(entry.at("step"), command.step);
    read(entry.at("agent"), command.agent);
    std::vector<double> numbers;
    read(entry.at("numbers"), numbers);
    command.what = twin::what_of(entry.at("kind").get<std::string>(), numbers);
    command.source = entry.at("source").get<std::string>();
    read(entry.at("sequence"), command.sequence);
    read(entry.at("received_s"), command.received_s);
    commands.push_back(std::move(command));
  }
  return commands;
}

json refusals_json(std::span<const twin::RefusalCount> refusals) {
  json list = json::array();
  for (const twin::RefusalCount& refusal : refusals)
    list.push_back({{"source", refusal.source},
                    {"vehicle", refusal.vehicle},
                    {"reason", twin::name_of(refusal.reason)},
                    {"count", refusal.count},
                    {"last_s", written(refusal.last_s)},
                    {"last_text", refusal.last_text}});
  return list;
}

std::vector<twin::RefusalCount> refusals_of(const json& from) {
  std::vector<twin::RefusalCount> refusals;
  for (const json& entry : from) {
    const auto reason = twin::refusal_reason_of(entry.at("reason").get<std::string>());
    if (!reason) refuse("found a refusal for a reason that this version does not know");
    refusals.push_back(
        {entry.at("source").get<std::string>(), entry.at("vehicle").get<std::string>(), *reason,
         entry.at("count").get<std::uint64_t>(), 0, entry.at("last_text").get<std::string>()});
    read(entry.at("last_s"), refusals.back().last_s);
  }
  return refusals;
}

json watch_json(const twin::TrafficWatch::State& state) { return written(state); }

twin::TrafficWatch::State watch_of(const json& from) {
  twin::TrafficWatch::State state;
  read(from, state);
  return state;
}

}  // namespace slackwater::api
