#include "api/log/log_csv.h"

#include <algorithm>
#include <fstream>

#include "fields/base/encode/csv.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using ingest::TrajectoryTable;

template <typename Rows>
void write_file(const std::filesystem::path& file, const Rows& rows) {
  write_beside(file, [&](const std::filesystem::path& partial) {
    std::ofstream out(partial, std::ios::binary);
    rows(out);
    out.close();
    if (!out)
      throw Error(ErrorKind::unavailable,
                  "cannot write " + file.string() + "; check free space and permissions");
  });
}

std::string heading(const std::string& name, const std::string& units) {
  const std::string suffix = unit_suffix(units);
  return suffix.empty() || name.ends_with("_" + suffix) ? name : name + "_" + suffix;
}

void write_tracks(std::ostream& out, const TrajectoryFile& log) {
  out << "vehicle,time,t_s";
  for (const TrajectoryFile::Variable& v : log.variables) {
    for (std::size_t k = 0; k < v.per; ++k)
      out << ',' << heading(v.per == 1 ? v.name : v.name + "_" + std::to_string(k), v.units);
  }
  out << '\n';
  for (std::size_t i = 0; i < log.names.size(); ++i) {
    const std::string name = csv_cell(log.names[i]);
    for (std::size_t t = 0; t < log.t_s.size(); ++t) {
      out << name << ',' << format_utc(add_hours(log.epoch, log.t_s[t] / 3600)) << ','
          << csv_cell(log.t_s[t]);
      for (const TrajectoryFile::Variable& v : log.variables) {
        for (std::size_t k = 0; k < v.per; ++k)
          out << ',' << csv_cell(v.values[(i * log.t_s.size() + t) * v.per + k]);
      }
      out << '\n';
    }
  }
}

void write_table(std::ostream& out, const TrajectoryTable& table) {
  std::string line;
  for (const auto& text : table.texts) line += (line.empty() ? "" : ",") + text.name;
  for (const auto& column : table.columns)
    line += (line.empty() ? "" : ",") + heading(column.name, column.units);
  out << line << '\n';
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const char* separator = "";
    for (const auto& text : table.texts) {
      out << separator << csv_cell(text.values[row]);
      separator = ",";
    }
    for (const auto& column : table.columns) {
      out << separator << csv_cell(column.values[row]);
      separator = ",";
    }
    out << '\n';
  }
}

}  // namespace

std::string unit_suffix(std::string_view units) {
  if (units == "1") return {};
  if (units.starts_with("degree")) return "deg";
  std::string suffix;
  for (std::size_t from = 0; from < units.size();) {
    const std::size_t end = std::min(units.find(' ', from), units.size());
    std::string part = lower_case(units.substr(from, end - from));
    if (part.ends_with("-1")) part.erase(part.size() - 2);
    suffix += (suffix.empty() ? "" : "_") + part;
    from = end + 1;
  }
  return suffix;
}

std::vector<std::filesystem::path> write_log_csv(const TrajectoryFile& log,
                                                 const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files{file};
  write_file(file, [&](std::ostream& out) { write_tracks(out, log); });
  for (const TrajectoryTable& table : log.tables) {
    if (table.rows() == 0) continue;
    std::filesystem::path beside = file;
    beside.replace_filename(file.stem().string() + "-" + table.name + ".csv");
    write_file(beside, [&](std::ostream& out) { write_table(out, table); });
    files.push_back(std::move(beside));
  }
  return files;
}

}  // namespace slackwater::api
