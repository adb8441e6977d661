#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fields/base/encode/html.h"

namespace slackwater::api {

/// A table; every cell is text as it should stand.
struct ReportTable {
  std::string title;
  std::string note;  ///< a sentence below; may be empty
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::optional<std::size_t> highlighted_row;
  std::vector<std::size_t> marked_rows = {};  ///< highlighted too
};

/// The parts of a page that opens with no network: styles, data, scripts and the plotting library
/// are inside it.
struct HtmlPage {
  std::string title;
  std::string site;      ///< below the title
  std::string headline;  ///< the sentence to read first; may be empty
  std::string alarm;     ///< in bold before the headline, which then is coloured; may be empty
  std::vector<std::pair<std::string, std::string>> facts;
  std::string first_html;         ///< what is read before all else; escaped already
  std::string plots_html;         ///< sections of plots, escaped already
  std::string tables_html;        ///< sections of tables, escaped already
  bool is_without_plots = false;  ///< it needs none, and no library for them
  /// What stands in the tables' place before them where there are no plots, escaped already.
  std::string instead_of_plots_html;
  std::vector<std::string> attributions;
  std::string generated;
  std::string data_json;    ///< read by the script; no '<' in it
  std::string_view script;  ///< draws the plots
};

/// The whole page. Without the plotting library it says so in a sentence, and carries no script.
[[nodiscard]] std::string page_html(const HtmlPage& page, std::string_view plotting_library);

/// One plot's section: its title, an element `id` to draw into, a note below.
[[nodiscard]] std::string plot_html(const std::string& id, const std::string& title,
                                    const std::string& note);
/// Throws ContractViolation where a row has not a cell for every column.
[[nodiscard]] std::string table_html(const ReportTable& table);

/// Writes a page (through a neighbouring temporary file, so that a reader never sees half of it).
/// Throws Error(unavailable) where it cannot be written.
void write_page(const std::string& html, const std::filesystem::path& file);

}  // namespace slackwater::api
