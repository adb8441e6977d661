// read_requests: what our reader makes of bytes, a line of hexadecimal digits each: the requests
// that it takes, as METHOD TARGET BODY-IN-HEX, and how it ends: "more" or "refused STATUS". For a
// comparison with another reader (framing.mjs).
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>

#include "api/door/http/request_reader.h"

namespace {

using namespace slackwater::api::http;
using Progress = RequestReader::Progress;

std::string bytes_of(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return bytes;
}

void print_hex(const std::string& bytes) {
  for (const char byte : bytes) std::printf("%02x", static_cast<unsigned char>(byte));
}

/// All requests that are there. @return false: the rest is refused
bool take_all(RequestReader& reader) {
  for (;;) {
    const Progress progress = reader.advance();
    if (progress != Progress::complete) return progress != Progress::refused;
    const Arrival arrival = reader.take();
    const auto& request = arrival.request;
    std::printf("%s %s%s%s ", request.method.c_str(), request.path.c_str(),
                request.query.empty() ? "" : "?", request.query.c_str());
    print_hex(request.body);
    std::printf("\t");
  }
}

void tell(std::string_view bytes) {
  const Limits limits;
  RequestReader reader(limits);
  while (!bytes.empty()) {
    const auto room = reader.room();
    const std::size_t count = std::min(room.size(), bytes.size());
    std::copy_n(bytes.begin(), count, room.begin());
    reader.received(count);
    bytes.remove_prefix(count);
    if (!take_all(reader)) {
      std::printf("refused %d\n", reader.refusal().status);
      return;
    }
  }
  std::printf("more\n");
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) tell(bytes_of(line));
  return 0;
}
