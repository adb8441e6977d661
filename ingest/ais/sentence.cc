#include "ingest/ais/sentence.h"

#include <array>
#include <charconv>

#include "ingest/ais/logged_time.h"

namespace slackwater::ingest {
namespace {

/// A whole number that is the whole text.
std::optional<std::int64_t> number_in(std::string_view text, int base = 10) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value, base);
  if (text.empty() || problem != std::errc() || stop != end || value < 0) return std::nullopt;
  return value;
}

/// The next field up to `separator`; `rest` moves behind it.
std::string_view take_field(std::string_view& rest, char separator) {
  const std::size_t at = rest.find(separator);
  const std::string_view field = rest.substr(0, at);
  rest = at == std::string_view::npos ? std::string_view() : rest.substr(at + 1);
  return field;
}

/// A text with its checksum `*hh` behind it, and what follows.
struct Checked {
  std::string_view text;
  std::string_view rest;
  int checksum = 0;
  bool is_right = false;
};
std::optional<Checked> checked(std::string_view text) {
  const std::size_t star = text.find('*');
  if (star == std::string_view::npos || star + 3 > text.size()) return std::nullopt;
  const auto stated = number_in(text.substr(star + 1, 2), 16);
  if (!stated) return std::nullopt;
  Checked result{text.substr(0, star), text.substr(star + 3), static_cast<int>(*stated), false};
  result.is_right = nmea_checksum(result.text) == result.checksum;
  return result;
}

/// Seconds since 1970, or milliseconds where they are too many for seconds (NMEA 0183 4.0 allows
/// both).
std::optional<UtcTime> unix_time(std::string_view text) {
  const auto value = number_in(text);
  if (!value || *value > 4'102'444'800'000) return std::nullopt;
  return believable_time(
      UtcTime(*value >= 100'000'000'000 ? Duration(*value) : Duration(*value * 1000)));
}

struct TagBlock {
  std::optional<UtcTime> time;
  std::string group;  ///< of `g:1-2-3454`, 3454
};

/// Takes the tag blocks in front of a sentence; `line` moves behind them.
TagBlock take_tag_blocks(std::string_view& line) {
  TagBlock result;
  while (line.starts_with('\\')) {
    const std::size_t end = line.find('\\', 1);
    if (end == std::string_view::npos) break;
    const auto block = checked(line.substr(1, end - 1));
    line.remove_prefix(end + 1);
    if (!block || !block->is_right) continue;
    for (std::string_view rest = block->text; !rest.empty();) {
      std::string_view value = take_field(rest, ',');
      const std::string_view name = take_field(value, ':');
      if (name == "c") result.time = unix_time(value);
      if (name == "g") result.group = value.substr(value.rfind('-') + 1);
    }
  }
  return result;
}

bool is_armoured(std::string_view payload) noexcept {
  for (const char c : payload) {
    if (!((c >= '0' && c <= 'W') || (c >= '`' && c <= 'w'))) return false;
  }
  return !payload.empty();
}

/// Where `!AIVDM,` or `!AIVDO,` of any talker begins, from `from` on.
std::size_t sentence_at(std::string_view line, std::size_t from) noexcept {
  for (std::size_t at = line.find('!', from); at != std::string_view::npos;
       at = line.find('!', at + 1)) {
    const std::string_view formatter = line.substr(at, 7);
    if (formatter.ends_with("VDO,") || formatter.ends_with("VDM,")) {
      if (formatter.size() == 7) return at;
    }
  }
  return std::string_view::npos;
}

AisLine parse_stamp(std::string_view line) {
  const auto body = checked(line.substr(1));
  if (!body || !body->is_right) return MalformedLine{"a $PGHP line with a wrong checksum"};
  std::array<std::string_view, 14> field;
  std::string_view rest = body->text;
  for (std::string_view& f : field) f = take_field(rest, ',');
  std::array<int, 7> part{};
  for (std::size_t i = 0; i < part.size(); ++i) {
    const auto value = number_in(field[i + 2]);
    if (!value || *value > 9999) return MalformedLine{"a $PGHP line without a time"};
    part[i] = static_cast<int>(*value);
  }
  const auto date = std::chrono::year(part[0]) / part[1] / part[2];
  if (!date.ok() || part[3] > 23 || part[4] > 59 || part[5] > 59 || part[6] > 999) {
    return MalformedLine{"a $PGHP line with a time that does not exist"};
  }
  const auto time =
      believable_time(UtcDay(date) + std::chrono::hours(part[3]) + std::chrono::minutes(part[4]) +
                      std::chrono::seconds(part[5]) + Duration(part[6]));
  if (!time) return MalformedLine{"a $PGHP line of a clock that was not set"};
  return PghpStamp{*time, static_cast<int>(number_in(field[13], 16).value_or(0) & 0xff)};
}

}  // namespace

int nmea_checksum(std::string_view text) noexcept {
  int sum = 0;
  for (const char c : text) sum ^= static_cast<unsigned char>(c);
  return sum;
}

std::vector<std::string> split_sentences(std::string_view line) {
  std::vector<std::string> parts;
  const std::size_t first = sentence_at(line, 0);
  for (std::size_t at = first; at != std::string_view::npos;) {
    const std::size_t next = sentence_at(line, at + 1);
    parts.push_back(
        std::string(line.substr(0, first)) +
        std::string(line.substr(at, next == std::string_view::npos ? next : next - at)));
    at = next;
  }
  if (parts.size() < 2) return {std::string(line)};
  return parts;
}

AisLine parse_ais_line(std::string_view line) {
  if (line.starts_with("$PGHP,")) return parse_stamp(line);
  TagBlock tag = take_tag_blocks(line);
  const std::size_t at = sentence_at(line, 0);
  if (at == std::string_view::npos || line.front() == '#') return OtherLine{};
  if (sentence_at(line, at + 1) != std::string_view::npos)
    return MalformedLine{"several sentences in one line, expected one"};
  std::string_view before = line.substr(0, at);
  line.remove_prefix(at);
  if (const std::size_t slash = before.find('\\'); slash != std::string_view::npos) {
    std::string_view blocks = before.substr(slash);
    tag = take_tag_blocks(blocks);
    before = before.substr(0, slash);
  }
  const bool is_own_ship = line.substr(0, 7).ends_with("VDO,");
  const auto body = checked(line.substr(1));
  if (!body) return MalformedLine{"a sentence without a checksum"};
  if (!body->is_right) return MalformedLine{"a sentence with a wrong checksum"};

  std::array<std::string_view, 7> field;
  std::string_view rest = body->text;
  for (std::string_view& f : field) f = take_field(rest, ',');
  const auto total = number_in(field[1]);
  const auto number = number_in(field[2]);
  const auto fill_bits = number_in(field[6]);
  if (!total || !number || *total < 1 || *total > 9 || *number < 1 || *number > *total) {
    return MalformedLine{"a sentence whose fragment number makes no sense"};
  }
  if (!is_armoured(field[5])) return MalformedLine{"a sentence whose payload is not armoured"};
  if (!rest.empty() || !fill_bits || *fill_bits > 5 || (*number < *total && *fill_bits != 0)) {
    return MalformedLine{"a sentence whose fill bits make no sense"};
  }
  AisSentence sentence;
  sentence.total = static_cast<int>(*total);
  sentence.number = static_cast<int>(*number);
  sentence.payload = field[5];
  sentence.fill_bits = static_cast<int>(*fill_bits);
  sentence.checksum = body->checksum;
  sentence.is_own_ship = is_own_ship;
  sentence.time = tag.time;
  for (std::string_view suffix = body->rest; !suffix.empty();) {
    sentence.logged_time = unix_time(take_field(suffix, ','));
  }
  if (!sentence.logged_time) {
    auto logged = logged_time_in(before);
    if (!logged) logged = logged_time_in(body->rest);
    if (logged) {
      sentence.logged_time = logged->clock;
      sentence.logged_time_states_zone = logged->states_zone;
    }
  }
  // The group of a tag block names its message; else the talker, the sequence number and the
  // channel do.
  sentence.key = std::string(field[1]) + ',';
  if (!tag.group.empty()) {
    sentence.key += "g:" + tag.group;
  } else {
    for (const std::size_t part : {0U, 3U, 4U}) sentence.key.append(field[part]) += ',';
  }
  return sentence;
}

}  // namespace slackwater::ingest
