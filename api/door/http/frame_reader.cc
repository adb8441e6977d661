#include "api/door/http/frame_reader.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "fields/base/check.h"

namespace slackwater::api::http {
namespace {

constexpr std::size_t frame_bytes = std::size_t{16} * 1024;
constexpr std::size_t longest_control = 125;
constexpr std::size_t mask_bytes = 4;

std::uint8_t byte_of(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}

std::uint64_t number_of(std::string_view bytes, std::size_t from, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < count; ++i) number = (number << 8U) | byte_of(bytes, from + i);
  return number;
}

void append_number(std::string& bytes, std::uint64_t number, std::size_t count) {
  for (std::size_t i = count; i-- > 0;) bytes += static_cast<char>((number >> (8 * i)) & 0xffU);
}

bool is_control(Opcode opcode) { return static_cast<std::uint8_t>(opcode) >= 8; }

bool is_known(std::uint8_t opcode) { return opcode <= 2 || (opcode >= 8 && opcode <= 10); }

/// What a client may send (RFC 6455 §7.4.2 and the registry of it).
bool may_be_sent(std::uint16_t code) {
  return (code >= 1000 && code <= 1003) || (code >= 1007 && code <= 1014) ||
         (code >= 3000 && code <= 4999);
}

void unmask(char* bytes, std::size_t count, std::string_view mask) {
  for (std::size_t i = 0; i < count; ++i) {
    bytes[i] = static_cast<char>(bytes[i] ^ mask[i % mask_bytes]);
  }
}

}  // namespace

std::span<char> FrameReader::room() {
  if (begin_ == end_) begin_ = end_ = 0;
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= std::exchange(begin_, 0);
  }
  // A client that is silent, or says little at a time, holds little.
  if (end_ == 0 && buffer_.size() > frame_bytes) buffer_ = {};
  if (buffer_.size() < end_ + frame_bytes) buffer_.resize(end_ + frame_bytes);
  return {buffer_.data() + end_, frame_bytes};
}

void FrameReader::received(std::size_t bytes) {
  expects(end_ + bytes <= buffer_.size(), "no more came than there was room for");
  end_ += bytes;
}

void FrameReader::fail(std::uint16_t code, std::string why) {
  failure_ = Incoming{Incoming::Kind::failed, std::move(why), code};
}

std::optional<Incoming> FrameReader::failure() {
  begin_ = end_ = 0;
  message_ = {};
  return failure_;
}

std::optional<std::size_t> FrameReader::length_of(std::string_view bytes, std::size_t short_form) {
  if (short_form < 126) return short_form;
  const std::size_t width = short_form == 126 ? 2 : 8;
  if (bytes.size() < 2 + width) return std::nullopt;
  const std::uint64_t length = number_of(bytes, 2, width);
  if (length < (width == 2 ? 126U : 65536U) || (length >> 63U) != 0) {
    fail(close_code::protocol_error, "the length of a frame is not in its shortest form");
  }
  return static_cast<std::size_t>(length);
}

std::optional<FrameReader::Head> FrameReader::head_of(std::string_view bytes) {
  if (bytes.size() < 2) return std::nullopt;
  const std::uint8_t first = byte_of(bytes, 0);
  const std::uint8_t second = byte_of(bytes, 1);
  const auto opcode = static_cast<std::uint8_t>(first & 0x0fU);
  Head head{(first & 0x80U) != 0, static_cast<Opcode>(opcode), 0, second & 0x7fU};
  if ((first & 0x70U) != 0) {
    fail(close_code::protocol_error, "a reserved bit is set, and no extension was agreed on");
  } else if (!is_known(opcode)) {
    fail(close_code::protocol_error, "unknown opcode " + std::to_string(opcode));
  } else if ((second & 0x80U) == 0) {
    fail(close_code::protocol_error, "a frame from a client is masked");
  } else if (is_control(head.opcode) && (!head.is_final || head.payload > longest_control)) {
    fail(close_code::protocol_error, "a control frame is whole, of at most 125 bytes");
  } else if (head.opcode == Opcode::continuation && !message_opcode_) {
    fail(close_code::protocol_error, "there is no message to continue");
  } else if (!is_control(head.opcode) && head.opcode != Opcode::continuation && message_opcode_) {
    fail(close_code::protocol_error, "a message begins before the last one has ended");
  }
  if (failure_) return std::nullopt;
  const auto length = length_of(bytes, head.payload);
  if (!length || failure_) return std::nullopt;
  if (!is_control(head.opcode) && *length > message_bytes_ - message_.size()) {
    fail(close_code::too_big,
         "a message holds at most " + std::to_string(message_bytes_) + " bytes");
    return std::nullopt;
  }
  head.bytes = 2 + (head.payload < 126 ? 0 : head.payload == 126 ? 2 : 8) + mask_bytes;
  head.payload = *length;
  return head;
}

std::optional<Incoming> FrameReader::next() {
  while (!failure_) {
    const std::string_view bytes(buffer_.data() + begin_, end_ - begin_);
    const auto head = head_of(bytes);
    if (failure_) return failure();
    if (!head || bytes.size() < head->bytes + head->payload) return std::nullopt;
    std::string payload(bytes.substr(head->bytes, head->payload));
    unmask(payload.data(), payload.size(), bytes.substr(head->bytes - mask_bytes, mask_bytes));
    begin_ += head->bytes + head->payload;
    auto whole = taken(*head, std::move(payload));
    if (failure_) return failure();
    if (whole) return whole;
  }
  return std::nullopt;
}

std::optional<Incoming> FrameReader::taken(const Head& head, std::string payload) {
  if (head.opcode == Opcode::ping) return Incoming{Incoming::Kind::ping, std::move(payload), 0};
  if (head.opcode == Opcode::pong) return Incoming{Incoming::Kind::pong, std::move(payload), 0};
  if (head.opcode == Opcode::close) {
    if (payload.empty()) return Incoming{Incoming::Kind::close, {}, close_code::no_code};
    const auto code =
        static_cast<std::uint16_t>(payload.size() < 2 ? 0U : number_of(payload, 0, 2));
    if (!may_be_sent(code)) {
      fail(close_code::protocol_error, "the code of a farewell is none that may be sent");
    } else if (!is_utf8(std::string_view(payload).substr(2))) {
      fail(close_code::invalid_text, "the reason of a farewell is not UTF-8");
    }
    if (failure_) return std::nullopt;
    return Incoming{Incoming::Kind::close, payload.substr(2), code};
  }
  if (head.opcode != Opcode::continuation) message_opcode_ = head.opcode;
  message_ += payload;
  if (!head.is_final) return std::nullopt;
  const bool is_text = std::exchange(message_opcode_, std::nullopt) == Opcode::text;
  std::string message = std::exchange(message_, {});
  if (is_text && !is_utf8(message)) {
    fail(close_code::invalid_text, "a text is not UTF-8");
    return std::nullopt;
  }
  return Incoming{is_text ? Incoming::Kind::text : Incoming::Kind::binary, std::move(message), 0};
}

bool is_utf8(std::string_view text) noexcept {
  for (std::size_t i = 0; i < text.size();) {
    const std::uint8_t first = byte_of(text, i++);
    if (first < 0x80) continue;
    const std::size_t rest = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
    if (first < 0xc2 || first > 0xf4 || text.size() - i < rest) return false;
    // The second byte says what the first leaves open: overlong, surrogate, beyond U+10FFFF.
    const std::uint8_t second = byte_of(text, i);
    const std::uint8_t least = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
    const std::uint8_t most = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
    if (second < least || second > most) return false;
    for (std::size_t k = 1; k < rest; ++k) {
      if ((byte_of(text, i + k) & 0xc0U) != 0x80) return false;
    }
    i += rest;
  }
  return true;
}

std::string frame_head(Opcode opcode, std::size_t payload_bytes) {
  std::string head(1, static_cast<char>(0x80U | static_cast<std::uint8_t>(opcode)));
  if (payload_bytes < 126) {
    append_number(head, payload_bytes, 1);
  } else if (payload_bytes < 65536) {
    append_number(head, 126, 1);
    append_number(head, payload_bytes, 2);
  } else {
    append_number(head, 127, 1);
    append_number(head, payload_bytes, 8);
  }
  return head;
}

std::string control_frame(Opcode opcode, std::string_view payload) {
  payload = payload.substr(0, longest_control);
  return frame_head(opcode, payload.size()).append(payload);
}

std::string close_frame(std::uint16_t code, std::string_view reason) {
  std::string payload;
  if (code != close_code::no_code) {
    append_number(payload, code, 2);
    // A cut may not leave half a character behind.
    reason = reason.substr(0, longest_control - 2);
    while (!is_utf8(reason)) reason.remove_suffix(1);
    payload += reason;
  }
  return control_frame(Opcode::close, payload);
}

}  // namespace slackwater::api::http
