#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace slackwater::tests {

/// A run that was refused: told in one line on stderr that holds the words; nothing is printed.
inline void expect_refusal(const ProgramResult& result, int exit_code,
                           const std::vector<std::string>& words) {
  SCOPED_TRACE(result.err);
  EXPECT_EQ(result.exit_code, exit_code) << result.out;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1);
  for (const std::string& word : words)
    EXPECT_NE(result.err.find(word), std::string::npos) << "does not say " << word;
}

}  // namespace slackwater::tests
