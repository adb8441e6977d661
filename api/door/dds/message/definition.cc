#include "api/door/dds/message/definition.h"

#include <cctype>
#include <map>
#include <set>
#include <vector>

#include "api/door/dds/message/idl_text.h"
#include "data/bag/type_hash.h"
#include "fields/base/check.h"

namespace slackwater::dds {
namespace {

struct Member {
  std::string type;    ///< of IDL: "double", "std_msgs::msg::Header"
  std::string bounds;  ///< of ROS: "[]", "[36]", "" where it is one
  std::string name;
};
using Struct = std::vector<Member>;

/// Words and signs, without comments, annotations and preprocessor lines.
std::vector<std::string> tokens_of(std::string_view idl) {
  std::vector<std::string> tokens;
  const auto is_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  for (std::size_t i = 0; i < idl.size();) {
    const char c = idl[i];
    if (c == '#' || c == '@' || idl.substr(i, 2) == "//") {
      // An annotation is a word, the others are lines.
      while (i < idl.size() && (c == '@' ? idl[i] != ' ' : idl[i] != '\n')) ++i;
    } else if (is_word(c)) {
      std::size_t end = i;
      while (end < idl.size() && (is_word(idl[end]) || idl.substr(end, 2) == "::" ||
                                  (idl[end] == ':' && idl[end - 1] == ':')))
        ++end;
      tokens.emplace_back(idl.substr(i, end - i));
      i = end;
    } else {
      if (!std::isspace(static_cast<unsigned char>(c))) tokens.emplace_back(1, c);
      ++i;
    }
  }
  return tokens;
}

/// Reads the structures of one source. The sources are our own: what else there were in them is a
/// bug.
class Parser {
 public:
  Parser(std::string_view idl, std::map<std::string, Struct>& structs)
      : tokens_(tokens_of(idl)), structs_(structs) {
    while (at_ < tokens_.size()) read_module({});
  }

 private:
  const std::string& take() {
    expects(at_ < tokens_.size(), "an IDL of ours is whole");
    return tokens_[at_++];
  }
  void take(std::string_view wanted) { expects(take() == wanted, "an IDL of ours is plain"); }

  void read_module(const std::string& scope) {
    take("module");
    const std::string name = (scope.empty() ? "" : scope + "::") + take();
    take("{");
    while (tokens_[at_] != "}") {
      if (tokens_[at_] == "module")
        read_module(name);
      else
        read_struct(name);
    }
    take("}");
    if (at_ < tokens_.size() && tokens_[at_] == ";") ++at_;
  }

  void read_struct(const std::string& scope) {
    take("struct");
    Struct& made = structs_[scope + "::" + take()];
    take("{");
    while (tokens_[at_] != "}") made.push_back(read_member(scope));
    take("}");
    take(";");
  }

  std::string read_type(const std::string& scope) {
    std::string type = take();
    while (type == "unsigned" || (type.ends_with("long") && tokens_[at_] == "long"))
      type += " " + take();
    if (structs_.contains(scope + "::" + type)) return scope + "::" + type;
    if (type == "string" && tokens_[at_] == "<") {
      take("<");
      type += "<=" + take();
      take(">");
    }
    return type;
  }

  Member read_member(const std::string& scope) {
    Member member;
    if (tokens_[at_] == "sequence") {
      take();
      take("<");
      member.type = read_type(scope);
      take(">");
      member.bounds = "[]";
    } else {
      member.type = read_type(scope);
    }
    member.name = take();
    if (tokens_[at_] == "[") {
      take("[");
      member.bounds = "[" + take() + "]";
      take("]");
    }
    take(";");
    return member;
  }

  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
  std::map<std::string, Struct>& structs_;
};

const std::map<std::string, Struct>& structs() {
  static const std::map<std::string, Struct> all = [] {
    std::map<std::string, Struct> made;
    for (const std::string_view idl : idl_texts()) Parser(idl, made);
    return made;
  }();
  return all;
}

/// "std_msgs/msg/Header" -> "std_msgs::msg::Header".
std::string idl_name(std::string_view ros_type) {
  std::string name(ros_type);
  for (std::size_t i = 0; (i = name.find('/')) != std::string::npos;) name.replace(i, 1, "::");
  return name;
}

/// "std_msgs::msg::Header" -> "std_msgs/Header".
std::string short_name(const std::string& idl_type) {
  return idl_type.substr(0, idl_type.find("::")) + "/" + idl_type.substr(idl_type.rfind("::") + 2);
}

/// "std_msgs::msg::Header" -> "std_msgs/msg/Header".
std::string full_name(const std::string& idl_type) {
  std::string name = idl_type;
  for (std::size_t i = 0; (i = name.find("::")) != std::string::npos;) name.replace(i, 2, "/");
  return name;
}

using Naming = std::string (*)(const std::string& idl_type);

std::string ros_type_of(const std::string& idl_type, Naming named) {
  static const std::map<std::string, std::string> simple{{"double", "float64"},
                                                         {"float", "float32"},
                                                         {"long", "int32"},
                                                         {"unsigned long", "uint32"},
                                                         {"int8", "int8"},
                                                         {"octet", "uint8"},
                                                         {"unsigned short", "uint16"},
                                                         {"unsigned long long", "uint64"},
                                                         {"boolean", "bool"},
                                                         {"char", "char"}};
  if (const auto found = simple.find(idl_type); found != simple.end()) return found->second;
  return idl_type.starts_with("string") ? idl_type : named(idl_type);
}

std::string fields_of(const Struct& type, Naming named) {
  std::string text;
  for (const Member& member : type) {
    if (member.name == "structure_needs_at_least_one_member") continue;
    text += ros_type_of(member.type, named) + member.bounds + " " + member.name + "\n";
  }
  return text;
}

void collect(const Struct& type, std::vector<std::string>& held, std::set<std::string>& known) {
  for (const Member& member : type) {
    const auto found = structs().find(member.type);
    if (found == structs().end() || !known.insert(member.type).second) continue;
    held.push_back(member.type);
    collect(found->second, held, known);
  }
}

std::string definition(std::string_view ros_type, Naming named) {
  const auto found = structs().find(idl_name(ros_type));
  expects(found != structs().end(), "a type of api/door/dds/idl");
  std::string text = fields_of(found->second, named);
  std::vector<std::string> held;
  std::set<std::string> known;
  collect(found->second, held, known);
  for (const std::string& type : held)
    text += std::string(80, '=') + "\nMSG: " + named(type) + "\n" +
            fields_of(structs().at(type), named);
  return text;
}

}  // namespace

std::string type_hash_of(std::string_view ros_type) {
  const std::string type(ros_type), request = type + "_Request", response = type + "_Response";
  const auto is_there = [](const std::string& name) { return structs().contains(idl_name(name)); };
  const auto full = [](const std::string& name) { return definition(name, full_name); };
  if (is_there(type)) return bag::type_hash(type, full(type)).value_or("");
  if (!is_there(request) || !is_there(response)) return {};
  return bag::service_type_hash(type, full(request), full(response)).value_or("");
}

std::string definition_of(std::string_view ros_type) { return definition(ros_type, short_name); }

}  // namespace slackwater::dds
