#include "api/door/people/token_book.h"

#include <unistd.h>

#include <algorithm>
#include <array>

#include "api/door/http/trust.h"
#include "api/program/secret_file.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::people {
namespace {

constexpr std::size_t least_letters = 16;
constexpr int most_seats = 1000;

/// Of a sub-protocol's name (RFC 9110 §5.6.2), as browsers send it.
bool is_token_letter(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
         c == '_';
}

Grant read_grant(const Config& entry) {
  Grant grant;
  grant.name = entry.optional_text("name").value_or("");
  const std::string role = entry.text("role");
  const auto known = role_of(role);
  if (!known)
    entry.refuse("role", "found '" + role + "', expected spectator, operator or supervisor");
  grant.role = *known;
  grant.token = entry.text("token");
  if (grant.token.size() < least_letters ||
      !std::all_of(grant.token.begin(), grant.token.end(), is_token_letter))
    entry.refuse("token", formatted("found {} letters, expected {} or more of a-z, A-Z, 0-9, '-' "
                                    "and '_'; make one with: openssl rand -hex 16",
                                    grant.token.size(), least_letters));
  const std::string until = entry.text("until");
  try {
    grant.until = parse_utc(until);
  } catch (const Error& e) {
    entry.refuse("until", e.message());
  }
  grant.seats = entry.optional_integer("seats", 1, most_seats).value_or(1);
  if (!grant.name.empty() && grant.seats != 1)
    entry.refuse("seats", "found several seats for one name; leave out the name or the seats");
  return grant;
}

}  // namespace

std::string new_token() {
  std::array<unsigned char, 16> bits{};
  if (getentropy(bits.data(), bits.size()) != 0)
    throw Error(ErrorKind::unavailable, "the system gives no random bits for a token");
  std::string token;
  for (const unsigned char byte : bits) token += formatted("{:02x}", byte);
  return token;
}

TokenBook TokenBook::drawn(UtcTime until) {
  TokenBook book;
  book.grants_ = {{"", Role::supervises, new_token(), until, 1},
                  {"", Role::drives, new_token(), until, 4},
                  {"", Role::looks_on, new_token(), until, 60}};
  return book;
}

TokenBook TokenBook::read(const std::filesystem::path& file) {
  api::expect_secret(file);
  const Config config = Config::load(file);
  TokenBook book = read(config);
  config.expect_all_read();
  return book;
}

TokenBook TokenBook::read(const Config& config) {
  TokenBook book;
  for (const Config& entry : config.children("people")) {
    Grant grant = read_grant(entry);
    if (book.find(grant.token)) entry.refuse("token", "stands twice; each line needs its own");
    book.grants_.push_back(std::move(grant));
  }
  if (book.grants_.empty())
    config.refuse("people", "found nobody, expected a list of {role, token, until}");
  return book;
}

std::optional<std::size_t> TokenBook::find(std::string_view token) const noexcept {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < grants_.size(); ++i)
    if (api::http::equal_in_constant_time(grants_[i].token, token)) found = i;
  return found;
}

}  // namespace slackwater::people
