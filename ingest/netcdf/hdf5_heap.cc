#include "ingest/netcdf/hdf5_heap.h"

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/error.h"

namespace slackwater::ingest::netcdf {
namespace {

constexpr std::uintmax_t largest_searched = std::uintmax_t{512} << 20;
constexpr std::size_t piece_bytes = std::size_t{1} << 20;
// A collection: signature, version 1, three zeros, its size (8 bytes), then objects.
constexpr std::string_view signature("GCOL\x01\0\0\0", 8);
constexpr std::size_t header_bytes = 16;  // of a collection and of an object alike
// The library makes collections of 4 KiB, larger only for one long text.
constexpr std::uint64_t largest_heap = std::uint64_t{64} << 20;

std::uint64_t little_endian(const char* bytes, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// Whether the objects follow each other to the end without standing still or running over.
bool is_sound(const std::vector<char>& heap) {
  std::uint64_t at = header_bytes;
  while (at + header_bytes <= heap.size()) {
    const std::uint64_t index = little_endian(heap.data() + at, 2);
    const std::uint64_t size = little_endian(heap.data() + at + 8, 8);
    if (size > heap.size()) return false;
    // Index 0 is free space, whose size counts its own header.
    const std::uint64_t step = index == 0 ? size : header_bytes + (size + 7) / 8 * 8;
    if (step < header_bytes || step > heap.size() - at) return false;
    at += step;
  }
  return true;
}

}  // namespace

void expect_sound_global_heaps(const std::filesystem::path& path) {
  const std::uintmax_t bytes = std::filesystem::file_size(path);
  if (bytes > largest_searched) return;
  std::ifstream stream(path, std::ios::binary);
  std::ifstream heap_stream(path, std::ios::binary);
  std::string piece(piece_bytes + signature.size(), '\0');
  for (std::uintmax_t first = 0; first < bytes; first += piece_bytes) {
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(first));
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const std::string_view text(piece.data(), static_cast<std::size_t>(stream.gcount()));
    for (std::size_t found = text.find(signature); found != std::string_view::npos;
         found = text.find(signature, found + 1)) {
      char head[header_bytes] = {};
      heap_stream.clear();
      heap_stream.seekg(static_cast<std::streamoff>(first + found));
      heap_stream.read(head, header_bytes);
      const std::uint64_t size = little_endian(head + 8, 8);
      bool sound = size >= header_bytes && size <= largest_heap && size <= bytes - (first + found);
      if (sound) {
        std::vector<char> heap(size);
        heap_stream.seekg(static_cast<std::streamoff>(first + found));
        heap_stream.read(heap.data(), static_cast<std::streamsize>(size));
        sound = is_sound(heap);
      }
      if (!sound) {
        throw Error(ErrorKind::invalid_input,
                    path.string() + ": is damaged (a global heap of HDF5 at byte " +
                        std::to_string(first + found) + " does not hold together); fetch it again");
      }
    }
  }
}

}  // namespace slackwater::ingest::netcdf
