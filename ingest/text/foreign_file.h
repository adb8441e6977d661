#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace slackwater::ingest {

/// A file that none of our readers of data takes, by its first bytes: what it is and what to do.
struct ForeignFile {
  std::string what;    ///< "a web page"
  std::string advice;  ///< "the download failed or wants a login: open it in a browser and see"
  /// "found a web page, expected <expected>; the download ..."
  [[nodiscard]] std::string refusal(std::string_view expected) const;
};

/// Nothing for what may be data: NetCDF, GRIB, text that is no markup. Takes any file; one that
/// cannot be read is not known either.
[[nodiscard]] std::optional<ForeignFile> foreign_file(const std::filesystem::path& file);

/// The same, and text too: an AIS log, a table. For readers that take no text at all.
[[nodiscard]] std::optional<ForeignFile> foreign_file_or_text(const std::filesystem::path& file);

}  // namespace slackwater::ingest
