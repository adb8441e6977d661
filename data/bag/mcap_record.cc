#include "data/bag/mcap_record.h"

#include <limits>

#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::bag {

void McapRecords::begin(McapOp op) {
  bytes_->push_back(static_cast<std::uint8_t>(op));
  record_ = bytes_->size();
  number(std::uint64_t{0});
}

void McapRecords::end() { store(record_, std::uint64_t{bytes_->size() - record_ - 8}); }

void McapRecords::text(std::string_view value) {
  expects(value.size() <= std::numeric_limits<std::uint32_t>::max(), "a text of less than 4 GiB");
  number(static_cast<std::uint32_t>(value.size()));
  bytes_->insert(bytes_->end(), value.begin(), value.end());
}

void McapRecords::begin_list() {
  list_ = bytes_->size();
  number(std::uint32_t{0});
}

void McapRecords::end_list() {
  store(list_, static_cast<std::uint32_t>(bytes_->size() - list_ - 4));
}

std::string McapFields::text() {
  const ByteView bytes = raw(number<std::uint32_t>());
  return {bytes.begin(), bytes.end()};
}

ByteView McapFields::raw(std::uint64_t length) {
  if (length > bytes_.size()) {
    throw Error(ErrorKind::invalid_input, "a field of " + std::to_string(length) +
                                              " bytes where the record has only " +
                                              std::to_string(bytes_.size()) + " left");
  }
  const ByteView field = bytes_.first(static_cast<std::size_t>(length));
  bytes_ = bytes_.subspan(field.size());
  return field;
}

std::int64_t McapFields::time_ns() {
  const auto time = number<std::uint64_t>();
  if (time > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    throw Error(ErrorKind::invalid_input, "a time of " + std::to_string(time) + " ns");
  }
  return static_cast<std::int64_t>(time);
}

McapRecord take_record(ByteView& bytes) {
  McapFields fields(bytes);
  const auto op = static_cast<McapOp>(fields.number<std::uint8_t>());
  const ByteView content = fields.raw(fields.number<std::uint64_t>());
  bytes = bytes.last(fields.left());
  return {op, content};
}

}  // namespace slackwater::bag
