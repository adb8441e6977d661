#include "ingest/ais/message.h"

#include <algorithm>
#include <utility>

#include "fields/base/text.h"

namespace slackwater::ingest {

int AisMessage::type() const noexcept {
  if (payload.empty()) return 0;
  const int value = payload.front() - '0';
  return value > 40 ? value - 8 : value;
}

std::vector<std::string> AisMessage::sentences() const {
  constexpr std::size_t characters = 56;  // of payload: 82 less "!AIVDM,1,1,0,A," and ",0*hh" CR LF
  const std::size_t total =
      std::max<std::size_t>(1, (payload.size() + characters - 1) / characters);
  std::vector<std::string> result;
  for (std::size_t i = 0; i < total; ++i) {
    std::string body = "AIVDM," + std::to_string(total) + ',' + std::to_string(i + 1) + ',';
    if (total > 1) body += '0';
    body += ",A," + payload.substr(i * characters, characters) + ',';
    body += std::to_string(i + 1 == total ? fill_bits : 0);
    result.push_back('!' + body + formatted("*{:02X}", nmea_checksum(body)));
  }
  return result;
}

void MessageAssembler::malformed(const std::string& reason) {
  if (counts_.malformed++ == 0) {
    counts_.first_malformed = "line " + std::to_string(counts_.lines) + ": " + reason;
  }
}

void MessageAssembler::lose(const std::deque<Open>::iterator& open) {
  counts_.lost_fragments += static_cast<std::size_t>(open->next - 1);
  open_.erase(open);
}

void MessageAssembler::finish() {
  while (!open_.empty()) lose(open_.begin());
}

std::optional<AisMessage> MessageAssembler::take_fragment(const AisSentence& sentence,
                                                          std::optional<UtcTime> time) {
  while (!open_.empty() && counts_.sentences - open_.front().since > reach) lose(open_.begin());
  const auto open = std::find_if(open_.begin(), open_.end(), [&](const Open& candidate) {
    return candidate.key == sentence.key;
  });
  if (sentence.number == 1) {
    if (open != open_.end()) lose(open);
    if (open_.size() == most_open) lose(open_.begin());
    open_.push_back({sentence.key,
                     2,
                     counts_.sentences,
                     {sentence.payload, sentence.fill_bits, sentence.is_own_ship, time}});
    return std::nullopt;
  }
  if (open == open_.end()) {
    ++counts_.lost_fragments;
    return std::nullopt;
  }
  if (open->next != sentence.number) {
    ++counts_.lost_fragments;
    lose(open);
    return std::nullopt;
  }
  AisMessage& message = open->message;
  message.payload += sentence.payload;
  message.fill_bits = sentence.fill_bits;
  if (!message.time) message.time = time;
  ++open->next;
  if (sentence.number < sentence.total) return std::nullopt;
  AisMessage whole = std::move(message);
  open_.erase(open);
  return whole;
}

std::optional<AisMessage> MessageAssembler::take(std::string_view line, bool is_too_long) {
  ++counts_.lines;
  if (is_too_long) {
    stamp_.reset();
    malformed("longer than any sentence");
    return std::nullopt;
  }
  if (line.find('!') == line.rfind('!')) return take_one(line);
  std::optional<AisMessage> found;
  for (const std::string& part : split_sentences(line)) {
    std::optional<AisMessage> message = take_one(part);
    if (message && found) malformed("several messages in one line, expected one");
    if (message && !found) found = std::move(message);
  }
  return found;
}

std::optional<AisMessage> MessageAssembler::take_one(std::string_view line) {
  const AisLine read = parse_ais_line(line);
  if (std::holds_alternative<OtherLine>(read)) return std::nullopt;
  if (const auto* stamp = std::get_if<PghpStamp>(&read)) {
    stamp_ = *stamp;
    return std::nullopt;
  }
  const std::optional<PghpStamp> stamp = std::exchange(stamp_, std::nullopt);
  if (const auto* problem = std::get_if<MalformedLine>(&read)) {
    malformed(problem->reason);
    return std::nullopt;
  }
  const auto& sentence = std::get<AisSentence>(read);
  ++counts_.sentences;
  std::optional<UtcTime> time = sentence.time;
  if (stamp && sentence.number == 1) {
    const bool is_of_another =
        sentence.total == 1 && stamp->checksum != 0 && stamp->checksum != sentence.checksum;
    counts_.mismatched_stamps += is_of_another ? 1U : 0U;
    if (!time && !is_of_another) time = stamp->time;
  }
  if (!time && sentence.logged_time) {
    if (sentence.logged_time_states_zone || assume_utc_) {
      time = sentence.logged_time;
    } else {
      ++counts_.zoneless_times;
    }
  }
  if (sentence.total == 1) {
    return AisMessage{sentence.payload, sentence.fill_bits, sentence.is_own_ship, time};
  }
  return take_fragment(sentence, time);
}

}  // namespace slackwater::ingest
