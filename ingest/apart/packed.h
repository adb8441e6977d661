#pragma once
#include <cereal/cereal.hpp>
#include <cereal/types/chrono.hpp>
#include <cereal/types/common.hpp>
#include <cereal/types/complex.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/utility.hpp>
#include <cereal/types/vector.hpp>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "fields/base/error.h"

// Values as bytes, for the pipe between two processes of one program: no format for files.
// Only sources of this folder include this.
//
// What comes back may be of a process that was taken over: each length is held against what is
// there before anything is made of it. Structures are taken apart by structured bindings, so that
// a member that is added to one and not told is an error when this is compiled.

namespace slackwater::ingest {

class Packing : public cereal::OutputArchive<Packing> {
 public:
  explicit Packing(std::string& bytes) : OutputArchive(this), bytes_(bytes) {}
  void put(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }

 private:
  std::string& bytes_;
};

class Unpacking : public cereal::InputArchive<Unpacking> {
 public:
  explicit Unpacking(std::string_view bytes) : InputArchive(this), left_(bytes) {}
  void take(void* data, std::size_t size) {
    expect(size);
    if (size > 0) std::memcpy(data, left_.data(), size);
    left_.remove_prefix(size);
  }
  /// Of something that takes a byte each, at the least. @throws Error(invalid_input)
  void expect(std::uint64_t count) const {
    if (count > left_.size()) refuse("its reader told less than it said that it would");
  }
  [[nodiscard]] bool is_at_end() const noexcept { return left_.empty(); }

 private:
  std::string_view left_;
};

template <typename T>
std::enable_if_t<std::is_arithmetic_v<T>> CEREAL_SAVE_FUNCTION_NAME(Packing& to, const T& value) {
  to.put(&value, sizeof value);
}
template <typename T>
std::enable_if_t<std::is_arithmetic_v<T>> CEREAL_LOAD_FUNCTION_NAME(Unpacking& from, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    unsigned char byte = 0;
    from.take(&byte, 1);
    if (byte > 1) refuse("its reader told what is neither yes nor no");
    value = byte == 1;
  } else {
    from.take(&value, sizeof value);
  }
}
template <typename T>
void CEREAL_SAVE_FUNCTION_NAME(Packing& to, const cereal::BinaryData<T>& data) {
  to.put(data.data, static_cast<std::size_t>(data.size));
}
template <typename T>
void CEREAL_LOAD_FUNCTION_NAME(Unpacking& from, cereal::BinaryData<T>& data) {
  from.take(data.data, static_cast<std::size_t>(data.size));
}
template <typename T>
void CEREAL_SAVE_FUNCTION_NAME(Packing& to, const cereal::SizeTag<T>& size) {
  to(static_cast<std::uint64_t>(size.size));
}
template <typename T>
void CEREAL_LOAD_FUNCTION_NAME(Unpacking& from, cereal::SizeTag<T>& size) {
  std::uint64_t count = 0;
  from(count);
  from.expect(count);
  size.size = static_cast<std::remove_reference_t<T>>(count);
}
template <typename Archive, typename T>
std::enable_if_t<std::is_same_v<Archive, Packing> || std::is_same_v<Archive, Unpacking>>
CEREAL_SERIALIZE_FUNCTION_NAME(Archive& archive, cereal::NameValuePair<T>& pair) {
  archive(pair.value);
}

template <typename T>
[[nodiscard]] std::string packed(const T& value) {
  std::string bytes;
  Packing to(bytes);
  to(value);
  return bytes;
}

/// @throws Error(invalid_input) for bytes that are none of it
template <typename T>
[[nodiscard]] T unpacked(std::string_view bytes) {
  T value{};
  Unpacking from(bytes);
  from(value);
  if (!from.is_at_end()) refuse("its reader told more than it said that it would");
  return value;
}

}  // namespace slackwater::ingest

CEREAL_REGISTER_ARCHIVE(slackwater::ingest::Packing)
CEREAL_REGISTER_ARCHIVE(slackwater::ingest::Unpacking)
CEREAL_SETUP_ARCHIVE_TRAITS(slackwater::ingest::Unpacking, slackwater::ingest::Packing)
