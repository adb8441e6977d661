#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ingest/grib/message.h"

namespace slackwater::ingest::grib {

/// Where one field stands in a file: a GRIB 2 message may repeat its sections and so hold several.
struct FieldPosition {
  std::uint64_t offset = 0;  ///< of the message, bytes
  std::uint64_t length = 0;  ///< of the message, bytes
  std::size_t field = 0;     ///< which field of the message, from 0
  std::size_t message = 0;   ///< number of the message in the file, from 1
};

/// A GRIB file (editions 1 and 2) walked message by message; holds one message in memory at a time.
///
/// The walk trusts nothing: each message must begin with "GRIB", end with "7777" where its length
/// says, and touch the next but for a frame: zero bytes (blocked archives) and the headings under
/// which bulletins travel (WMO Manual on the GTS, part II: "SOH CR CR LF 123 CR CR LF HUXA99 EGRR
/// 080000", "ETX"; NCEP's "****0000696252****"). Anything else is an Error that names the byte and
/// shows what is there: a truncated download, or a server's page behind the last message.
class MessageFile {
 public:
  /// Throws Error(not_found) if absent, Error(invalid_input) if empty.
  explicit MessageFile(const std::filesystem::path& path);

  /// The next message, or nothing at the end of the file. `bytes` receives it whole.
  [[nodiscard]] std::optional<FieldPosition> next(std::vector<std::byte>& bytes);
  /// A field that `next` and `split_fields` found before.
  [[nodiscard]] Message read(const FieldPosition& position);
  [[nodiscard]] std::uint64_t size() const noexcept { return size_; }
  [[nodiscard]] std::uint64_t offset() const noexcept { return offset_; }
  /// Bytes of headings passed over up to here, zeros not counted.
  [[nodiscard]] std::uint64_t frame_bytes() const noexcept { return frame_bytes_; }

 private:
  void pass_over_frame();
  void read_bytes(std::uint64_t offset, std::span<std::byte> into);

  std::filesystem::path path_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  std::uint64_t offset_ = 0;
  std::uint64_t frame_bytes_ = 0;
  std::size_t messages_ = 0;
};

/// Whether a file begins with a GRIB message, be it behind headings or other bytes (at most 4 KiB
/// of them): "GRIB", then edition 1 or 2. NetCDF and HDF5 files never do. False where it cannot be
/// read.
[[nodiscard]] bool begins_as_grib(const std::filesystem::path& file);

/// "message 7 at byte 1200", and "field 2 of message 7 at byte 1200" within a message of several
/// fields.
[[nodiscard]] std::string name_of(const FieldPosition& position);

/// Splits a message into messages of one field each. GRIB 1 and single GRIB 2 fields come back as
/// they are. A repeated section that a field lacks is the last one before it, and the bitmap
/// indicator 254 ("the bitmap defined before") is replaced by that bitmap (WMO Manual on Codes, FM
/// 92 GRIB, regulations 92.1.3 ff., code table 6.0).
[[nodiscard]] std::vector<std::vector<std::byte>> split_fields(std::vector<std::byte> message,
                                                               const std::string& name);

}  // namespace slackwater::ingest::grib
