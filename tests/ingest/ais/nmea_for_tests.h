#pragma once
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "ingest/ais/sentence.h"

namespace slackwater::tests {

/// "*2B": the checksum of a sentence's or tag block's text.
inline std::string checksum_of(std::string_view text) {
  char checksum[8];
  std::snprintf(checksum, sizeof checksum, "*%02X",
                static_cast<unsigned>(ingest::nmea_checksum(text)));
  return checksum;
}

/// "!AIVDM,...*2B" of "AIVDM,...".
inline std::string sentence_of(const std::string& body) { return '!' + body + checksum_of(body); }

/// "\c:1635731889*52\" of "c:1635731889".
inline std::string tag_of(const std::string& body) {
  return '\\' + body + checksum_of(body) + '\\';
}

/// "$PGHP,...*5B"; `sentence` is the checksum of the one that follows.
inline std::string stamp_of(const std::string& time, const std::string& sentence) {
  const std::string body = "PGHP,1," + time + ",219,,2190047,1," + sentence;
  return '$' + body + checksum_of(body);
}

inline std::filesystem::path write_text(const std::filesystem::path& file, std::string_view text) {
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

}  // namespace slackwater::tests
