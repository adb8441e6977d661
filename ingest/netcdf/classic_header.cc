#include "ingest/netcdf/classic_header.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "ingest/netcdf/refuse_file.h"

namespace slackwater::ingest::netcdf {
namespace {

constexpr std::uint64_t max_name = 256;  // NC_MAX_NAME
constexpr std::uint64_t max_list =
    1u << 16;  // entries in a list of dimensions, attributes or variables

[[noreturn]] void refuse_damaged(const std::filesystem::path& path, const std::string& why) {
  refuse_file(path, why + "; fetch it again");
}

std::uint64_t saturating_multiply(std::uint64_t a, std::uint64_t b) noexcept {
  std::uint64_t product = 0;
  return __builtin_mul_overflow(a, b, &product) ? std::numeric_limits<std::uint64_t>::max()
                                                : product;
}

std::uint64_t saturating_add(std::uint64_t a, std::uint64_t b) noexcept {
  std::uint64_t sum = 0;
  return __builtin_add_overflow(a, b, &sum) ? std::numeric_limits<std::uint64_t>::max() : sum;
}

std::uint64_t padded(std::uint64_t bytes) noexcept {
  return saturating_add(bytes, 3) & ~std::uint64_t{3};
}

/// Walks the big-endian header; a read past the end is a truncated header.
class Header {
 public:
  explicit Header(const std::filesystem::path& path)
      : path_(path), size_(std::filesystem::file_size(path)), stream_(path, std::ios::binary) {
    skip(3);
    version_ = static_cast<int>(big_endian(1));
  }

  [[nodiscard]] std::uint64_t size() const noexcept { return size_; }
  /// NON_NEG: 64 bits in CDF-5, 32 bits before.
  std::uint64_t count() { return big_endian(version_ == 5 ? 8 : 4); }
  std::uint64_t word() { return big_endian(4); }
  std::uint64_t offset() { return big_endian(version_ == 1 ? 4 : 8); }
  [[nodiscard]] bool is_streaming(std::uint64_t records) const noexcept {
    return records == (version_ == 5 ? ~std::uint64_t{0} : std::uint64_t{0xFFFFFFFF});
  }
  /// The number of entries of a list, after its tag.
  std::uint64_t list() {
    word();
    const std::uint64_t entries = count();
    if (entries > max_list)
      refuse_damaged(path_, "damaged header (a list of " + std::to_string(entries) + " entries)");
    return entries;
  }
  /// The library copies a name of any length into a buffer of NC_MAX_NAME + 1 bytes.
  void skip_name() {
    const std::uint64_t length = count();
    if (length > max_name)
      refuse_damaged(path_, "damaged header (a name of " + std::to_string(length) + " bytes)");
    skip(padded(length));
  }
  void skip_attributes() {
    for (std::uint64_t n = list(); n > 0; --n) {
      skip_name();
      const std::uint64_t bytes = bytes_of(word());
      skip(padded(saturating_multiply(count(), bytes)));
    }
  }
  [[nodiscard]] std::uint64_t bytes_of(std::uint64_t type) const {
    constexpr std::uint64_t bytes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    if (type == 0 || type >= std::size(bytes))
      refuse_damaged(path_, "damaged header (type " + std::to_string(type) + ")");
    return bytes[type];
  }

 private:
  void skip(std::uint64_t bytes) {
    if (bytes > size_ - at_)
      refuse_damaged(path_, "is truncated inside its header (" + std::to_string(size_) + " bytes)");
    at_ += bytes;
    stream_.seekg(static_cast<std::streamoff>(at_));
  }
  std::uint64_t big_endian(std::uint64_t bytes) {
    if (bytes > size_ - at_)
      refuse_damaged(path_, "is truncated inside its header (" + std::to_string(size_) + " bytes)");
    std::uint64_t value = 0;
    for (std::uint64_t i = 0; i < bytes; ++i)
      value = value << 8 | static_cast<std::uint64_t>(stream_.get() & 0xFF);
    at_ += bytes;
    return value;
  }

  const std::filesystem::path& path_;
  std::uint64_t size_;
  std::ifstream stream_;
  std::uint64_t at_ = 0;
  int version_ = 1;
};

struct Block {
  std::uint64_t begin = 0;
  std::uint64_t bytes = 0;  // of the variable, or of one of its records, without padding
  bool is_record = false;
};

}  // namespace

void expect_classic_file_is_whole(const std::filesystem::path& path) {
  Header header(path);
  const std::uint64_t records = header.count();
  std::vector<std::uint64_t> lengths;
  for (std::uint64_t n = header.list(); n > 0; --n) {
    header.skip_name();
    lengths.push_back(header.count());
  }
  header.skip_attributes();
  std::vector<Block> blocks;
  std::uint64_t record_bytes = 0;
  std::uint64_t record_variables = 0;
  for (std::uint64_t n = header.list(); n > 0; --n) {
    Block block;
    header.skip_name();
    const std::uint64_t rank = header.count();
    if (rank > max_list)
      refuse_damaged(path, "damaged header (a variable of rank " + std::to_string(rank) + ")");
    block.bytes = 1;
    for (std::uint64_t d = 0; d < rank; ++d) {
      const std::uint64_t dimension = header.count();
      if (dimension >= lengths.size())
        refuse_damaged(path, "damaged header (dimension " + std::to_string(dimension) + ")");
      const std::uint64_t length = lengths[dimension];
      if (length == 0 && d == 0) {
        block.is_record = true;
      } else {
        block.bytes = saturating_multiply(block.bytes, length);
      }
    }
    header.skip_attributes();
    block.bytes = saturating_multiply(block.bytes, header.bytes_of(header.word()));
    header.count();  // vsize: redundant, and wrong for large variables
    block.begin = header.offset();
    if (block.is_record) {
      record_bytes = saturating_add(record_bytes, padded(block.bytes));
      ++record_variables;
    }
    blocks.push_back(block);
  }
  // A lone record variable is not padded between its records.
  if (record_variables == 1) {
    for (const Block& block : blocks) {
      if (block.is_record) record_bytes = block.bytes;
    }
  }
  std::uint64_t end = 0;
  for (const Block& block : blocks) {
    if (block.bytes == 0 || (block.is_record && (records == 0 || header.is_streaming(records))))
      continue;
    const std::uint64_t before =
        block.is_record ? saturating_multiply(records - 1, record_bytes) : 0;
    end = std::max(end, saturating_add(saturating_add(block.begin, before), block.bytes));
  }
  if (end > header.size()) {
    refuse_damaged(path, "is truncated: it has " + std::to_string(header.size()) +
                             " bytes where its header announces " + std::to_string(end));
  }
}

}  // namespace slackwater::ingest::netcdf
