#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Comma-separated values (RFC 4180), a line at a time.

namespace slackwater {

/// A cell as it stands in a file: in quotes where it holds a comma, a quote or the end of a line.
[[nodiscard]] std::string csv_cell(std::string_view text);
/// The same of what people wrote: no spreadsheet takes it for a formula.
[[nodiscard]] std::string csv_cell_of_people(const std::string& text);
/// A number that reads back as the same; nothing for one that is not finite.
[[nodiscard]] std::string csv_cell(double value);
/// Cells of a line, quotes taken off, blanks around a cell too; nothing where a quote stays open.
[[nodiscard]] std::optional<std::vector<std::string>> csv_cells(std::string_view line);

}  // namespace slackwater
