#include "ingest/grib/message_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "fields/base/error.h"

namespace slackwater::ingest::grib {
namespace {

/// A field of 16 million points packed in 32 bits; more would break the promise of bounded memory.
constexpr std::uint64_t longest_message_bytes = 64ULL << 20U;
constexpr std::size_t header_bytes = 16;

std::uint64_t big_endian(std::span<const std::byte> bytes) {
  std::uint64_t value = 0;
  for (const std::byte byte : bytes) value = (value << 8U) | std::to_integer<std::uint64_t>(byte);
  return value;
}

bool begins_with(std::span<const std::byte> bytes, const char* four) {
  return bytes.size() >= 4 && std::memcmp(bytes.data(), four, 4) == 0;
}

/// What stands in front of a message at most: headings of bulletins are shorter than 100 bytes.
constexpr std::size_t longest_frame = 4096;

bool is_message_head(std::span<const std::byte> bytes) {
  return bytes.size() >= 8 && begins_with(bytes, "GRIB") &&
         (bytes[7] == std::byte{1} || bytes[7] == std::byte{2});
}

/// Headings and ends of bulletins are capital letters, digits and signs of transmission.
bool may_frame(std::byte byte) {
  const auto c = std::to_integer<unsigned char>(byte);
  constexpr std::string_view signs = "\x01\x03\r\n *+-./:=#_";
  return c == 0 || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
         signs.find(static_cast<char>(c)) != std::string_view::npos;
}

std::string shown(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte byte : bytes.first(std::min<std::size_t>(bytes.size(), 24))) {
    const auto c = std::to_integer<unsigned char>(byte);
    text += c >= 32 && c < 127 ? static_cast<char>(c) : '.';
  }
  return text;
}

/// How many bytes stand before the message, or to the end of the file; nothing where they are no
/// frame: the end of a message among them, "7777", is what is left of one whose head is damaged.
std::optional<std::size_t> frame_length(std::span<const std::byte> bytes, bool is_all) {
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    if (begins_with(bytes.subspan(at), "GRIB") || begins_with(bytes.subspan(at), "7777")) {
      if (is_message_head(bytes.subspan(at))) return at;
      return std::nullopt;
    }
    if (!may_frame(bytes[at])) return std::nullopt;
  }
  // A message that is cut off after its first letters is no heading.
  for (const std::string_view cut : {"G", "GR", "GRI"}) {
    if (bytes.size() >= cut.size() &&
        std::memcmp(bytes.last(cut.size()).data(), cut.data(), cut.size()) == 0)
      return std::nullopt;
  }
  return is_all ? std::optional(bytes.size()) : std::nullopt;
}

}  // namespace

bool begins_as_grib(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::vector<std::byte> bytes(longest_frame + 8);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (begins_with(bytes, "GRIB")) return true;
  if (begins_with(bytes, "\x89HDF") ||
      (bytes.size() > 3 && std::memcmp(bytes.data(), "CDF", 3) == 0))
    return false;
  for (std::size_t at = 0; at + 8 <= bytes.size(); ++at) {
    if (is_message_head(std::span(bytes).subspan(at))) return true;
  }
  return false;
}

std::string name_of(const FieldPosition& position) {
  return (position.field == 0 ? std::string()
                              : "field " + std::to_string(position.field + 1) + " of ") +
         "message " + std::to_string(position.message) + " at byte " +
         std::to_string(position.offset);
}

MessageFile::MessageFile(const std::filesystem::path& path)
    : path_(path), stream_(path, std::ios::binary) {
  std::error_code failure;
  size_ = std::filesystem::file_size(path, failure);
  if (failure || !stream_) {
    throw Error(ErrorKind::not_found,
                "cannot open " + path.string() + "; check the path and its permissions");
  }
  if (size_ == 0) refuse("the file is empty; expected GRIB messages: download it again");
}

void MessageFile::read_bytes(std::uint64_t offset, std::span<std::byte> into) {
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(offset));
  stream_.read(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(into.size()));
  if (static_cast<std::size_t>(stream_.gcount()) != into.size()) {
    throw Error(ErrorKind::unavailable, "cannot read " + std::to_string(into.size()) +
                                            " bytes at byte " + std::to_string(offset) +
                                            "; the file changed or the disk failed");
  }
}

void MessageFile::pass_over_frame() {
  std::array<std::byte, longest_frame + 8> block{};
  while (offset_ < size_) {
    const auto piece = std::span(block).first(
        static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), size_ - offset_)));
    read_bytes(offset_, piece);
    if (begins_with(piece, "GRIB")) return;
    const auto zeros = static_cast<std::size_t>(
        std::find_if(piece.begin(), piece.end(), [](std::byte b) { return b != std::byte{0}; }) -
        piece.begin());
    if (zeros > 0) {  // padding, of any length
      offset_ += zeros;
      continue;
    }
    const auto frame = frame_length(piece, piece.size() == size_ - offset_);
    if (!frame || *frame == 0) return;
    offset_ += *frame;
    frame_bytes_ += *frame;
    return;
  }
}

std::optional<FieldPosition> MessageFile::next(std::vector<std::byte>& bytes) {
  pass_over_frame();
  if (offset_ >= size_) return std::nullopt;

  const std::string where =
      "message " + std::to_string(messages_ + 1) + " at byte " + std::to_string(offset_);
  const std::uint64_t left = size_ - offset_;
  std::array<std::byte, header_bytes> header{};
  const auto head = std::span(header).first(
      static_cast<std::size_t>(std::min<std::uint64_t>(header_bytes, left)));
  read_bytes(offset_, head);
  if (!begins_with(head, "GRIB")) {
    const bool cut = left < 4 && std::memcmp(head.data(), "GRIB", head.size()) == 0;
    if (cut)
      refuse(where + " is cut off after " + std::to_string(left) +
             " bytes; download the file again");
    std::vector<std::byte> there(static_cast<std::size_t>(std::min<std::uint64_t>(24, left)));
    read_bytes(offset_, there);
    refuse(std::to_string(left) + " bytes from byte " + std::to_string(offset_) + " on ('" +
           shown(there) + "') are no GRIB message (expected \"GRIB\"" +
           (messages_ == 0
                ? std::string(")")
                : " or the end of the file after message " + std::to_string(messages_) + ")") +
           "; the file is damaged or something was appended to it: download it again");
  }
  if (left < header_bytes) {
    refuse(where + " is cut off after " + std::to_string(left) + " bytes; download the file again");
  }

  const auto edition = std::to_integer<unsigned>(header[7]);
  std::uint64_t length = 0;
  if (edition == 1) {
    length = big_endian(std::span(header).subspan(4, 3));
    if (length >= 0x800000) {
      // ECMWF's convention for GRIB 1 beyond 8 MiB: the length counts blocks of 120 bytes and
      // section 4 holds the remainder. Walk the sections to find it (ecCodes: "large GRIB 1
      // messages").
      std::array<std::byte, 8> section{};
      std::uint64_t at = offset_ + 8;
      std::uint64_t length_of_4 = 0;
      read_bytes(at, section);
      const auto flags = std::to_integer<unsigned>(section[7]);
      at += big_endian(std::span(section).first(3));
      const int others = ((flags & 0x80U) != 0 ? 1 : 0) + ((flags & 0x40U) != 0 ? 1 : 0);
      for (int i = 0; i <= others; ++i) {
        if (at + 3 > size_) refuse(where + " is cut off; download the file again");
        read_bytes(at, std::span(section).first(3));
        length_of_4 = big_endian(std::span(section).first(3));
        at += length_of_4;
      }
      if (length_of_4 < 120) length = (length & 0x7fffff) * 120 - length_of_4 + 4;
    }
  } else if (edition == 2) {
    length = big_endian(std::span(header).subspan(8, 8));
  } else {
    refuse(where + " is GRIB edition " + std::to_string(edition) + "; expected edition 1 or 2");
  }

  if (length < header_bytes + 4)
    refuse(where + " says it is " + std::to_string(length) + " bytes long; the file is damaged");
  if (length > left) {
    refuse(where + " says it is " + std::to_string(length) +
           " bytes long but the file ends after " + std::to_string(left) +
           ": it is truncated; download it again");
  }
  if (length > longest_message_bytes) {
    refuse(where + " is " + std::to_string(length >> 20U) + " MiB long; at most " +
           std::to_string(longest_message_bytes >> 20U) +
           " MiB are read: request an area or a coarser grid");
  }
  bytes.resize(static_cast<std::size_t>(length));
  read_bytes(offset_, bytes);
  if (!begins_with(std::span(bytes).last(4), "7777")) {
    refuse(where +
           " does not end with \"7777\" where its length says; the file is damaged: download it "
           "again");
  }

  FieldPosition position{offset_, length, 0, messages_ + 1};
  offset_ += length;
  ++messages_;
  return position;
}

Message MessageFile::read(const FieldPosition& position) {
  std::vector<std::byte> bytes(static_cast<std::size_t>(position.length));
  read_bytes(position.offset, bytes);
  auto fields = split_fields(std::move(bytes), name_of(position));
  if (position.field >= fields.size()) {
    throw Error(ErrorKind::unavailable,
                name_of(position) + " is gone; the file changed while it was read");
  }
  return Message(std::move(fields[position.field]), name_of(position));
}

std::vector<std::vector<std::byte>> split_fields(std::vector<std::byte> message,
                                                 const std::string& name) {
  std::vector<std::vector<std::byte>> fields;
  if (message.size() < header_bytes + 4 || std::to_integer<unsigned>(message[7]) != 2) {
    fields.push_back(std::move(message));
    return fields;
  }
  const std::span<const std::byte> all(message);
  std::array<std::span<const std::byte>, 8> last{};  // the last section of each number, 1 to 7
  std::span<const std::byte> bitmap;                 // the last section 6 that holds a bitmap
  std::size_t at = header_bytes;
  while (at + 4 < all.size()) {
    if (at + 5 > all.size() - 4)
      refuse(name + ": a section header is cut off; the file is damaged");
    const std::uint64_t length = big_endian(all.subspan(at, 4));
    const auto number = std::to_integer<std::size_t>(all[at + 4]);
    if (length < 5 || length > all.size() - 4 - at || number < 1 || number > 7) {
      refuse(name + ": section " + std::to_string(number) + " of " + std::to_string(length) +
             " bytes at byte " + std::to_string(at) +
             " of the message does not fit; the file is damaged: download it again");
    }
    auto section = all.subspan(at, static_cast<std::size_t>(length));
    at += section.size();
    if (number == 6 && section.size() >= 6) {
      const auto indicator = std::to_integer<unsigned>(section[5]);
      if (indicator == 0) bitmap = section;
      if (indicator == 254) {
        if (bitmap.empty())
          refuse(name + ": refers to an earlier bitmap that is not there; the file is damaged");
        section = bitmap;
      }
    }
    last[number] = section;
    if (number != 7) continue;

    std::vector<std::byte> field(all.begin(), all.begin() + header_bytes);
    for (std::size_t i = 1; i < last.size(); ++i) {
      if (last[i].empty() && i != 2) {
        refuse(name + ": section " + std::to_string(i) + " is missing; the file is damaged");
      }
      field.insert(field.end(), last[i].begin(), last[i].end());
    }
    field.insert(field.end(), all.end() - 4, all.end());
    for (std::size_t i = 0; i < 8; ++i) {
      field[15 - i] = static_cast<std::byte>((field.size() >> (8 * i)) & 0xFFU);
    }
    fields.push_back(std::move(field));
  }
  if (fields.empty()) refuse(name + ": holds no field; the file is damaged: download it again");
  return fields;
}

}  // namespace slackwater::ingest::grib
