#include "ingest/text/foreign_file.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "fields/base/text.h"
#include "ingest/text/packed.h"

namespace slackwater::ingest {
namespace {

struct Beginning {
  std::string_view bytes;  ///< in small letters
  const char* what;
  const char* advice;
};
constexpr const char* of_a_server =
    "it may be the message of a server where the download failed or wants a login: open it and see";
constexpr const char* of_a_bag =
    "a recording holds commands and vessels: `slackwater simulate --play-commands` plays it";
constexpr std::array beginnings{
    Beginning{"<!doctype html", "a web page", of_a_server},
    Beginning{"<html", "a web page", of_a_server},
    Beginning{"<?xml", "an XML document", of_a_server},
    Beginning{"{", "JSON", of_a_server},
    Beginning{"error {", "an OPeNDAP error", of_a_server},
    Beginning{"dataset {", "the list of variables of an OPeNDAP server",
              "fetch the data themselves, as NetCDF"},
    Beginning{"par1", "a Parquet file", "write it as CSV or NetCDF first"},
    Beginning{"%pdf", "a PDF document", "fetch the data themselves"},
    Beginning{"\x89mcap0", "an MCAP recording", of_a_bag},
    Beginning{"sqlite format 3", "an SQLite database (a ROS 2 recording, or a store)", of_a_bag},
    Beginning{"#rosbag v", "a ROS 1 recording",
              "ROS 1 is not read; convert it with rosbags-convert"},
};

/// The beginning of a file; shorter where the file is.
std::string first_bytes_of(const std::filesystem::path& file) {
  std::string bytes(512, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return bytes;
}

bool is_text(std::string_view bytes) {
  return !bytes.empty() && std::all_of(bytes.begin(), bytes.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= ' ' || c == '\t' || c == '\n' || c == '\r';
  });
}

std::optional<ForeignFile> foreign(std::string_view bytes) {
  if (const auto packing = packing_of(bytes))
    return ForeignFile{std::string(packing->name),
                       "unpack it with `" + std::string(packing->unpack) + "`"};
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::string lower = lower_case(trimmed(bytes, " \t\r\n"));
  for (const Beginning& beginning : beginnings) {
    if (lower.starts_with(beginning.bytes)) return ForeignFile{beginning.what, beginning.advice};
  }
  return std::nullopt;
}

}  // namespace

std::string ForeignFile::refusal(std::string_view expected) const {
  return "found " + what + ", expected " + std::string(expected) + "; " + advice;
}

std::optional<ForeignFile> foreign_file(const std::filesystem::path& file) {
  return foreign(first_bytes_of(file));
}

std::optional<ForeignFile> foreign_file_or_text(const std::filesystem::path& file) {
  const std::string bytes = first_bytes_of(file);
  if (auto found = foreign(bytes)) return found;
  if (!is_text(bytes)) return std::nullopt;
  if (contains_ignoring_case(bytes, "VDM,") || contains_ignoring_case(bytes, "VDO,") ||
      contains_ignoring_case(bytes, "mmsi"))
    return ForeignFile{"a log of AIS", "`slackwater ais` reads it, and a scenario's `traffic`"};
  return ForeignFile{
      "text",
      "a table of one place is read by `slackwater workability`; for the store fetch "
      "the same data as NetCDF or GRIB"};
}

}  // namespace slackwater::ingest
