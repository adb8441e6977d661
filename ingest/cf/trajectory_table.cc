#include "ingest/cf/trajectory_table.h"

#include <algorithm>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "ingest/cf/trajectory_table_file.h"

namespace slackwater::ingest {
namespace {

using netcdf::Type;
using netcdf::Writer;

std::size_t longest_of(const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  return longest;
}

}  // namespace

std::size_t TrajectoryTable::rows() const noexcept {
  if (!columns.empty()) return columns.front().values.size();
  return texts.empty() ? 0 : texts.front().values.size();
}

const std::vector<double>* TrajectoryTable::column(std::string_view wanted) const noexcept {
  for (const Column& column : columns)
    if (column.name == wanted) return &column.values;
  return nullptr;
}

const std::vector<std::string>* TrajectoryTable::text(std::string_view wanted) const noexcept {
  for (const TextColumn& column : texts)
    if (column.name == wanted) return &column.values;
  return nullptr;
}

TableWriter::TableWriter(std::span<const TrajectoryTable> tables, Writer& out) : tables_(tables) {
  for (const TrajectoryTable& table : tables_) {
    const std::size_t rows = table.rows();
    if (rows == 0) continue;
    const int row = out.dimension(table.name, rows);
    for (const TrajectoryTable::Column& column : table.columns) {
      expects(column.values.size() == rows, "a value for each row of a table");
      Writer::Layout layout;
      layout.chunks = {rows};
      layout.deflate = 1;
      layout.fill_value = constants::nan;
      layout.is_prefilled = false;
      const int id = out.variable(table.name + "_" + column.name, Type::float64, {row}, layout);
      out.attribute(id, "long_name", column.long_name);
      out.attribute(id, "units", column.units);
      ids_.push_back(id);
    }
    for (const TrajectoryTable::TextColumn& column : table.texts) {
      expects(column.values.size() == rows, "a text for each row of a table");
      const std::string name = table.name + "_" + column.name;
      const int letters = out.dimension(name + "_length", longest_of(column.values));
      const int id = out.variable(name, Type::character, {row, letters});
      out.attribute(id, "long_name", column.long_name);
      ids_.push_back(id);
    }
  }
}

void TableWriter::write(Writer& out) const {
  auto id = ids_.begin();
  for (const TrajectoryTable& table : tables_) {
    if (table.rows() == 0) continue;
    for (const TrajectoryTable::Column& column : table.columns) out.write_all(*id++, column.values);
    for (const TrajectoryTable::TextColumn& column : table.texts) {
      const std::size_t longest = longest_of(column.values);
      std::string letters;
      letters.reserve(longest * column.values.size());
      for (const std::string& text : column.values) {
        letters += text;
        letters.append(longest - text.size(), '\0');
      }
      out.write_text(*id++, letters);
    }
  }
}

bool is_of_a_table(const netcdf::Variable& variable) noexcept {
  if (variable.shape.empty() || variable.dimensions[0] == "trajectory" ||
      variable.dimensions[0] == "time")
    return false;
  return variable.shape.size() == (variable.type == Type::character ? 2U : 1U) &&
         variable.name.starts_with(variable.dimensions[0] + "_");
}

void read_into(std::vector<TrajectoryTable>& tables, const netcdf::File& file,
               const netcdf::Variable& variable) {
  const std::string& of = variable.dimensions[0];
  auto table = std::find_if(tables.begin(), tables.end(),
                            [&](const TrajectoryTable& t) { return t.name == of; });
  if (table == tables.end()) {
    tables.emplace_back().name = of;
    table = tables.end() - 1;
  }
  const std::string name = variable.name.substr(of.size() + 1);
  const std::string long_name = variable.text("long_name").value_or("");
  if (variable.type != Type::character) {
    table->columns.push_back(
        {name, variable.text("units").value_or(""), long_name, file.read_all(variable)});
    return;
  }
  table->texts.push_back({name, long_name, file.read_texts(variable)});
}

}  // namespace slackwater::ingest
