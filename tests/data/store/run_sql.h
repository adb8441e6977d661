#pragma once
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <string>

namespace slackwater::store::tests {

/// Runs SQL past the Store; SQLite's complaint, or "".
inline std::string run_sql(const std::filesystem::path& store, const std::string& sql) {
  sqlite3* connection = nullptr;
  EXPECT_EQ(sqlite3_open((store / "catalogue.sqlite").c_str(), &connection), SQLITE_OK);
  char* message = nullptr;
  sqlite3_exec(connection, ("PRAGMA foreign_keys = ON; " + sql).c_str(), nullptr, nullptr,
               &message);
  const std::string said = message == nullptr ? "" : message;
  sqlite3_free(message);
  sqlite3_close(connection);
  return said;
}

}  // namespace slackwater::store::tests
