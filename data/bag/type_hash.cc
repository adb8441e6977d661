#include "data/bag/type_hash.h"

#include <charconv>
#include <map>
#include <set>
#include <vector>

#include "fields/base/encode/sha256.h"
#include "fields/base/text.h"

namespace slackwater::bag {
namespace {

// type_description_interfaces/msg/FieldType: a nested type is 1; to arrays 48 is added, to bounded
// sequences 96, to unbounded ones 144.
constexpr int nested_type = 1;
constexpr int bounded_string = 21;
constexpr int array_offset = 48;
constexpr int bounded_sequence_offset = 96;
constexpr int sequence_offset = 144;

std::optional<int> id_of(std::string_view name) {
  static const std::map<std::string_view, int> ids{
      {"int8", 2},   {"uint8", 3}, {"int16", 4},   {"uint16", 5},   {"int32", 6},
      {"uint32", 7}, {"int64", 8}, {"uint64", 9},  {"float32", 10}, {"float64", 11},
      {"bool", 15},  {"byte", 16}, {"string", 17}, {"char", 3}};  // a char of ROS is an uint8
  const auto found = ids.find(name);
  return found == ids.end() ? std::nullopt : std::optional(found->second);
}

struct Field {
  std::string name;
  int type_id = 0;
  unsigned capacity = 0;
  unsigned string_capacity = 0;
  std::string nested;  ///< "package/msg/Name"
};

std::optional<unsigned> number_in(std::string_view text) {
  unsigned value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "package/Name" as "package/msg/Name"; a name alone is of the package of its owner.
std::string full_name(std::string_view name, std::string_view owner) {
  const auto first = name.find('/');
  const std::string package(first == std::string_view::npos ? owner.substr(0, owner.find('/'))
                                                            : name.substr(0, first));
  const auto last = name.rfind('/');
  if (last != first) return std::string(name);
  return package + "/msg/" +
         std::string(last == std::string_view::npos ? name : name.substr(last + 1));
}

/// A part of a service or action that was written like a message, whose name has no underscore.
bool is_part_in_disguise(const std::string& name) {
  const auto last = name.rfind("/msg/");
  return last != std::string::npos && name.find('_', last) != std::string::npos;
}

/// The type of a field as it is written, e.g. "string<=10[<=5]".
std::optional<Field> field_of(std::string_view type, std::string_view name,
                              std::string_view owner) {
  Field field{std::string(name), 0, 0, 0, {}};
  int offset = 0;
  if (type.ends_with(']')) {
    const auto open = type.rfind('[');
    if (open == std::string_view::npos) return std::nullopt;
    std::string_view size = type.substr(open + 1, type.size() - open - 2);
    type = type.substr(0, open);
    offset = size.empty() ? sequence_offset : array_offset;
    if (size.starts_with("<=")) {
      offset = bounded_sequence_offset;
      size.remove_prefix(2);
    }
    if (!size.empty() || offset == bounded_sequence_offset) {
      const auto capacity = number_in(size);
      if (!capacity) return std::nullopt;
      field.capacity = *capacity;
    }
  }
  if (type.substr(0, type.find('<')) == "wstring") return std::nullopt;
  if (type.starts_with("string<=")) {
    const auto capacity = number_in(type.substr(8));
    if (!capacity) return std::nullopt;
    field.string_capacity = *capacity;
    field.type_id = offset + bounded_string;
  } else if (const auto id = id_of(type)) {
    field.type_id = offset + *id;
  } else {
    field.type_id = offset + nested_type;
    field.nested = full_name(type, owner);
  }
  return field;
}

std::string_view without_comment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote != 0) {
      if (line[i] == quote) quote = 0;
    } else if (line[i] == '"' || line[i] == '\'') {
      quote = line[i];
    } else if (line[i] == '#') {
      return line.substr(0, i);
    }
  }
  return line;
}

using Types = std::map<std::string, std::vector<Field>>;

/// Each type of a definition with its fields.
std::optional<Types> types_of(std::string_view type, std::string_view definition) {
  Types types;
  std::string owner(type);
  types[owner];
  bool is_heading = false;
  while (!definition.empty()) {
    const auto end = definition.find('\n');
    const std::string_view line = trimmed(without_comment(definition.substr(0, end)));
    definition.remove_prefix(end == std::string_view::npos ? definition.size() : end + 1);
    if (line.empty()) continue;
    if (line.find_first_not_of('=') == std::string_view::npos) {
      is_heading = true;
      continue;
    }
    if (is_heading) {
      if (!line.starts_with("MSG: ")) return std::nullopt;
      owner = full_name(trimmed(line.substr(5)), type);
      if (!types.try_emplace(owner).second) return std::nullopt;
      is_heading = false;
      continue;
    }
    const auto space = line.find_first_of(" \t");
    if (space == std::string_view::npos) return std::nullopt;
    const std::string_view rest = trimmed(line.substr(space));
    const auto name_end = rest.find_first_of(" \t=");
    const std::string_view name = rest.substr(0, name_end);
    if (name_end != std::string_view::npos && trimmed(rest.substr(name_end)).starts_with('='))
      continue;  // a constant
    auto field = field_of(line.substr(0, space), name, owner);
    if (!field) return std::nullopt;
    types[owner].push_back(std::move(*field));
  }
  for (auto& [name, fields] : types) {
    // An IDL structure without members has one, which takes a byte on the wire.
    if (fields.empty()) fields.push_back({"structure_needs_at_least_one_member", 3, 0, 0, {}});
  }
  return types;
}

std::string json_of(const std::string& name, const std::vector<Field>& fields) {
  std::string json = R"({"type_name": ")" + name + R"(", "fields": [)";
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const Field& f = fields[i];
    json += std::string(i == 0 ? "" : ", ") + R"({"name": ")" + f.name +
            R"(", "type": {"type_id": )" + std::to_string(f.type_id) + R"(, "capacity": )" +
            std::to_string(f.capacity) + R"(, "string_capacity": )" +
            std::to_string(f.string_capacity) + R"(, "nested_type_name": ")" + f.nested + R"("}})";
  }
  return json + "]}";
}

/// The types that `name` holds, and those that they hold; false where one is not defined, or not
/// named in full.
bool gather(const Types& types, const std::string& name, std::set<std::string>& held) {
  const auto found = types.find(name);
  if (found == types.end()) return false;
  for (const Field& field : found->second) {
    if (field.nested.empty() || !held.insert(field.nested).second) continue;
    if (is_part_in_disguise(field.nested)) return false;
    if (!gather(types, field.nested, held)) return false;
  }
  return true;
}

std::optional<std::string> hash_of(const Types& types, const std::string& name) {
  std::set<std::string> held;
  if (!gather(types, name, held)) return std::nullopt;
  std::string json = R"({"type_description": )" + json_of(name, types.at(name)) +
                     R"(, "referenced_type_descriptions": [)";
  const char* comma = "";
  for (const std::string& nested : held) {
    json += comma + json_of(nested, types.at(nested));
    comma = ", ";
  }
  return "RIHS01_" + sha256_of_text(json + "]}");
}

bool is_of(std::string_view type, std::string_view kind) {
  return type.find(kind) != std::string_view::npos;
}

Field nested_field(const char* name, const std::string& type) {
  return {name, nested_type, 0, 0, type};
}
/// None or one of it.
Field optional_field(const char* name, const std::string& type) {
  return {name, bounded_sequence_offset + nested_type, 1, 0, type};
}

}  // namespace

std::optional<std::string> type_hash(std::string_view type, std::string_view definition) {
  if (!is_of(type, "/msg/") && !is_of(type, "/action/")) return std::nullopt;
  const auto types = types_of(type, definition);
  return types ? hash_of(*types, std::string(type)) : std::nullopt;
}

std::optional<std::string> service_type_hash(std::string_view type,
                                             std::string_view request_definition,
                                             std::string_view response_definition) {
  if (!is_of(type, "/srv/") && !is_of(type, "/action/")) return std::nullopt;
  const std::string name(type), request = name + "_Request", response = name + "_Response",
                                event = name + "_Event";
  const std::string time = "builtin_interfaces/msg/Time",
                    info = "service_msgs/msg/ServiceEventInfo";
  auto types = types_of(request, request_definition);
  const auto of_response = types_of(response, response_definition);
  if (!types || !of_response) return std::nullopt;
  types->insert(of_response->begin(), of_response->end());
  // What introspection tells of a call (REP-2012).
  (*types)[time] = {{"sec", 6, 0, 0, {}}, {"nanosec", 7, 0, 0, {}}};
  (*types)[info] = {{"event_type", 3, 0, 0, {}},
                    nested_field("stamp", time),
                    {"client_gid", array_offset + 3, 16, 0, {}},
                    {"sequence_number", 8, 0, 0, {}}};
  (*types)[event] = {nested_field("info", info), optional_field("request", request),
                     optional_field("response", response)};
  (*types)[name] = {nested_field("request_message", request),
                    nested_field("response_message", response),
                    nested_field("event_message", event)};
  return hash_of(*types, name);
}

}  // namespace slackwater::bag
