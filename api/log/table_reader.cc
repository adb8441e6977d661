#include "api/log/table_reader.h"

#include <cmath>

#include "api/log/account_tables.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {

TableReader::TableReader(const ingest::TrajectoryFile& log, const char* table)
    : table_(log.find_table(table)), name_(table), vehicles_(log.names.size()) {}

void TableReader::refuse(const std::string& why) const {
  throw Error(ErrorKind::invalid_input,
              "the table " + name_ + " of the log " + why + "; the log is damaged, make it again");
}

void TableReader::refuse_word(const char* column, const std::string& found) const {
  throw Error(ErrorKind::invalid_input,
              "the table " + name_ + " of the log has '" + found + "' as " + column +
                  ", which this version does not know; read it with the version that wrote it");
}

void TableReader::for_each(
    const std::function<void(std::size_t vehicle, std::size_t row)>& read) const {
  if (table_ == nullptr) return;
  for (std::size_t row = 0; row < table_->rows(); ++row) {
    const std::size_t vehicle = whole("vehicle", row);
    if (vehicle >= vehicles_)
      refuse(formatted("is about vehicle {}, expected a number below {}", vehicle, vehicles_));
    read(vehicle, row);
  }
}

double TableReader::number(const char* column, std::size_t row) const {
  const std::vector<double>* values = table_->column(column);
  if (values == nullptr || row >= values->size())
    refuse(std::string("has no column ") + column + " of numbers");
  return (*values)[row];
}

const std::string& TableReader::text(const char* column, std::size_t row) const {
  const std::vector<std::string>* texts = table_->text(column);
  if (texts == nullptr || row >= texts->size())
    refuse(std::string("has no column ") + column + " of texts");
  return (*texts)[row];
}

std::string TableReader::word(const char* column, std::size_t row) const {
  const std::string& found = text(column, row);
  return found == no_word ? std::string() : found;
}

std::size_t TableReader::whole(const char* column, std::size_t row) const {
  constexpr double most = 9e15;  // below 2^53 each count is a number
  const double found = number(column, row);
  if (!(found >= 0 && found <= most) || found != std::floor(found))
    refuse(formatted("has {:g} as {}, expected a count", found, column));
  return static_cast<std::size_t>(found);
}

}  // namespace slackwater::api
