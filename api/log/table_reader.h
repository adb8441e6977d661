#pragma once
#include <functional>
#include <string>

#include "ingest/cf/trajectory_file.h"

namespace slackwater::api {

/// Reads a table of a log row by row. One that the log does not have has no rows.
class TableReader {
 public:
  TableReader(const ingest::TrajectoryFile& log, const char* table);
  /// Calls `read` with each row's vehicle, from 0, and number.
  /// @throws Error(invalid_input) for a vehicle that the log does not have
  void for_each(const std::function<void(std::size_t vehicle, std::size_t row)>& read) const;
  /// @throws Error(invalid_input) where the table has no such column
  [[nodiscard]] double number(const char* column, std::size_t row) const;
  [[nodiscard]] const std::string& text(const char* column, std::size_t row) const;
  /// The same; empty where it stands for no word.
  [[nodiscard]] std::string word(const char* column, std::size_t row) const;
  /// A count from 0. @throws Error(invalid_input) for another number
  [[nodiscard]] std::size_t whole(const char* column, std::size_t row) const;
  /// The value of an enumeration whose values from 0 to `last` have names (`name_of`).
  /// @throws Error(invalid_input) for another word
  template <typename Enum>
  [[nodiscard]] Enum named(const char* column, std::size_t row, Enum last) const {
    const std::string& found = text(column, row);
    for (int i = 0; i <= static_cast<int>(last); ++i)
      if (name_of(static_cast<Enum>(i)) == found) return static_cast<Enum>(i);
    refuse_word(column, found);
  }
  [[noreturn]] void refuse(const std::string& why) const;
  [[noreturn]] void refuse_word(const char* column, const std::string& found) const;

 private:
  const ingest::TrajectoryTable* table_;
  std::string name_;
  std::size_t vehicles_;
};

}  // namespace slackwater::api
