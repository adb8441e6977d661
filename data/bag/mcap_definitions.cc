#include "data/bag/mcap_definitions.h"

#include "data/bag/quality_yaml.h"
#include "fields/base/error.h"

namespace slackwater::bag {

void McapDefinitions::take_schema(ByteView content) {
  McapFields fields(content);
  const auto id = fields.number<std::uint16_t>();
  Schema schema{fields.text(), {}};
  const std::string encoding = fields.text();
  const ByteView data = fields.raw(fields.number<std::uint32_t>());
  if (encoding == "ros2msg") schema.definition.assign(data.begin(), data.end());
  if (id != 0) schemas_.try_emplace(id, std::move(schema));
}

void McapDefinitions::take_channel(ByteView content) {
  McapFields fields(content);
  const auto id = fields.number<std::uint16_t>();
  const auto schema = schemas_.find(fields.number<std::uint16_t>());
  Channel channel;
  channel.topic = fields.text();
  const std::string encoding = fields.text();
  if (const std::size_t* known = table_.find(id)) {
    if (table_.channels()[*known].topic == channel.topic) return;
    throw Error(ErrorKind::invalid_input, "channel " + std::to_string(id) + " is defined twice");
  }
  if (!not_cdr_ && encoding != "cdr") not_cdr_ = {channel.topic, encoding};
  if (schema != schemas_.end()) {
    channel.type = schema->second.name;
    channel.definition = schema->second.definition;
  }
  McapFields metadata(fields.raw(fields.number<std::uint32_t>()));
  while (metadata.left() > 0) {
    const std::string key = metadata.text();
    const std::string value = metadata.text();
    if (key == "offered_qos_profiles") channel.quality = quality_of(value);
  }
  table_.name(id, table_.add(channel));
}

void McapDefinitions::expect_all_cdr() const {
  if (not_cdr_) expect_cdr(not_cdr_->first, not_cdr_->second);
}

}  // namespace slackwater::bag
