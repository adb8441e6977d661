#pragma once
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/http_client.h"
#include "tests/support/keep_secret.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests {

/// Names and tokens of an operator's file.
inline const std::map<std::string, std::string>& tokens_for_tests() {
  static const std::map<std::string, std::string> tokens{{"Ann", "ann-0123456789abcdef"},
                                                         {"Bob", "bob-0123456789abcdef"},
                                                         {"Sue", "sue-0123456789abcdef"},
                                                         {"Gus", "gus-0123456789abcdef"},
                                                         {"Old", "old-0123456789abcdef"}};
  return tokens;
}

/// Ann and Bob drive, Sue supervises, Gus looks on; Old was a supervisor once.
inline std::string people_yaml() {
  const std::string until = ", until: 2100-01-01T00:00:00Z}\n";
  const auto line = [](const std::string& name, const std::string& role) {
    return "  - {name: " + name + ", role: " + role + ", token: " + tokens_for_tests().at(name);
  };
  return "people:\n" + line("Ann", "operator") + until + line("Bob", "operator") + until +
         line("Sue", "supervisor") + until + line("Gus", "spectator") + until +
         line("Old", "supervisor") + ", until: 2020-01-01T00:00:00Z}\n";
}

/// A calm run with vehicles of these names.
inline std::string rovs_yaml(const std::string& name, const std::vector<std::string>& vehicles) {
  std::string yaml = calm_head(0.05);
  yaml.replace(yaml.find("test"), 4, name);
  for (std::size_t i = 0; i < vehicles.size(); ++i)
    yaml += "  - {name: " + vehicles[i] +
            ", model: bluerov2_heavy, start: {north_m: " + std::to_string(30 * i) +
            ", east_m: 0, depth_m: 10}, tasks: [{do: hold}]}\n";
  return yaml;
}

inline void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
  keep_secret(file);
}

/// POST of a JSON text, on a connection of its own.
inline HttpReply post(std::uint16_t port, const std::string& path, const std::string& token,
                      const std::string& body = {},
                      const std::string& field_lines = "Content-Type: application/json\r\n") {
  HttpClient client(port);
  const std::string bearer = token.empty() ? "" : "Authorization: Bearer " + token + "\r\n";
  (void)client.send("POST " + path + " HTTP/1.1\r\nHost: 127.0.0.1\r\n" + bearer + field_lines +
                    "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
  return client.receive().value_or(HttpReply{});
}

inline HttpReply begin_session(std::uint16_t port, const std::string& id,
                               const std::string& token = tokens_for_tests().at("Sue")) {
  return post(port, "/sessions", token, nlohmann::json{{"begin", id}}.dump());
}

inline nlohmann::json listed_sessions(std::uint16_t port) {
  return nlohmann::json::parse(HttpClient(port).get("/sessions").value_or(HttpReply{}).body);
}

/// A session of the list; null: it is not there.
inline nlohmann::json listed_session(std::uint16_t port, const std::string& id) {
  const nlohmann::json listed = listed_sessions(port);
  for (const auto& one : listed["sessions"])
    if (one["id"] == id) return one;
  return nullptr;
}

}  // namespace slackwater::tests
