#pragma once
#include <gtest/gtest.h>

#include <string>

#include "fields/base/error.h"
#include "fields/site/site.h"

namespace slackwater::tests {

/// A site at 54 N, 6.5 E with more keys.
inline Site site_with(const std::string& more) {
  return parse_site("id: here\nlatitude_deg: 54\nlongitude_deg: 6.5\n" + more, "here.yaml");
}

/// What is said against it.
inline std::string refusal(const std::string& more) {
  try {
    (void)site_with(more);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    return error.message();
  }
  return "accepted";
}

}  // namespace slackwater::tests
