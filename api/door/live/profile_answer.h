#pragma once
#include "api/door/dds/message/services.h"
#include "fields/service/field.h"

namespace slackwater::live {

/// The answer of `/slackwater/query_profile`: the profile of a member, or why there is none.
/// @param field  null: no forecast reaches that place
[[nodiscard]] dds::Bytes profile_answer(const Field* field, std::size_t member,
                                        const dds::ProfileAsked& asked);
/// Whether it is a place at all, so that a field can be looked for.
[[nodiscard]] bool is_on_earth(const dds::ProfileAsked& asked) noexcept;

}  // namespace slackwater::live
