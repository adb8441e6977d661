#pragma once
#include <span>
#include <string_view>

namespace slackwater::dds {

/// The sources of api/door/dds/idl, those that others include first. Embedded when it is
/// configured.
[[nodiscard]] std::span<const std::string_view> idl_texts() noexcept;

}  // namespace slackwater::dds
