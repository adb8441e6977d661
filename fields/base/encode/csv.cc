#include "fields/base/encode/csv.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"

namespace slackwater {
namespace {

/// Takes one cell and the comma behind it from `rest`; nothing where its quote stays open.
std::optional<std::string> take_cell(std::string_view& rest) {
  const std::size_t start = rest.find_first_not_of(" \t");
  if (start == std::string_view::npos || rest[start] != '"') {
    const std::size_t end = std::min(rest.find(','), rest.size());
    std::string cell(trimmed(rest.substr(0, end)));
    rest.remove_prefix(end);
    return cell;
  }
  std::string cell;
  for (std::size_t i = start + 1; i < rest.size(); ++i) {
    if (rest[i] != '"') {
      cell += rest[i];
    } else if (i + 1 < rest.size() && rest[i + 1] == '"') {
      cell += rest[i++];
    } else {
      rest.remove_prefix(std::min(rest.find(',', i), rest.size()));
      return cell;
    }
  }
  return std::nullopt;
}

}  // namespace

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

/// Source of the four characters: OWASP, "CSV Injection".
std::string csv_cell_of_people(const std::string& text) {
  const bool is_formula =
      !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos;
  return csv_cell(is_formula ? "'" + text : text);
}

std::string csv_cell(double value) {
  return std::isfinite(value) ? formatted("{}", value) : std::string();
}

std::optional<std::vector<std::string>> csv_cells(std::string_view line) {
  std::vector<std::string> cells;
  for (;;) {
    std::optional<std::string> cell = take_cell(line);
    if (!cell) return std::nullopt;
    cells.push_back(std::move(*cell));
    if (line.empty()) return cells;
    line.remove_prefix(1);
  }
}

}  // namespace slackwater
