#include "api/door/people/hands_routes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "api/door/http/page_part.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::hands_routes_test {
namespace {

using api::http::Request;
using api::http::Response;
using api::http::Router;

/// A folder that has every file of the detector but one, and a file that is nobody's.
struct HandsRoutes : testing::Test {
  HandsRoutes() {
    for (const std::string_view name : people::hand_detector_files)
      if (name != missing) std::ofstream(folder / name) << "bytes of " << name;
    std::ofstream(folder / "other.txt") << "nobody's";
    people::add_hands_routes(router, folder.path());
  }
  [[nodiscard]] Response get(const std::string& path) const {
    Request request;
    request.method = "GET";
    request.path = path;
    return api::http::completed(router(request));
  }
  static std::string header(const Response& response, const std::string& name) {
    for (const auto& [key, value] : response.headers)
      if (key == name) return value;
    return "";
  }

  static constexpr std::string_view missing = "hand_landmark_lite.tflite";
  TemporaryFolder folder;
  Router router;
};

// The list of what is installed is CMake's own.
TEST_F(HandsRoutes, WhatIsServedIsInstalled) {
  std::ifstream file(source_folder() / "cmake" / "SlackwaterInstall.cmake");
  const std::string install{std::istreambuf_iterator<char>(file), {}};
  for (const std::string_view name : people::hand_detector_files)
    EXPECT_TRUE(contains(install, std::string(name))) << name;
}

TEST_F(HandsRoutes, ServesEachFileOfTheDetectorAsItIs) {
  for (const std::string_view name : people::hand_detector_files) {
    if (name == missing) continue;
    const Response response = get("/session/hands/model/" + std::string(name));
    EXPECT_EQ(response.status, 200) << name;
    EXPECT_EQ(response.body, "bytes of " + std::string(name));
  }
  EXPECT_EQ(get("/session/hands/model/hands_solution_simd_wasm_bin.wasm").media_type,
            "application/wasm");
  EXPECT_EQ(get("/session/hands/model/hands.js").media_type, "text/javascript; charset=utf-8");
}

TEST_F(HandsRoutes, SaysWhichFileIsMissingAndNotWhere) {
  const Response response = get("/session/hands/model/" + std::string(missing));
  EXPECT_EQ(response.status, 404);
  EXPECT_TRUE(contains(response.body, missing)) << response.body;
  EXPECT_FALSE(contains(response.body, folder.path().string())) << response.body;
}

TEST_F(HandsRoutes, ServesNoOtherFile) {
  for (const char* path :
       {"/session/hands/model/other.txt", "/session/hands/model/", "/session/hands/model",
        "/session/hands/model/../model/other.txt", "/session/hands/model/%2e%2e/other.txt",
        "/session/hands/model/..%2fother.txt", "/session/hands/model/hands.js/other.txt",
        "/session/hands/other.txt"}) {
    const Response response = get(path);
    EXPECT_TRUE(response.status == 400 || response.status == 404) << path << response.status;
    EXPECT_FALSE(contains(response.body, "nobody's")) << path;
  }
}

TEST_F(HandsRoutes, LetsItsOwnScriptsAloneCompileWebAssembly) {
  const std::string policy = header(get("/session/hands"), "Content-Security-Policy");
  EXPECT_TRUE(contains(policy, "script-src 'self' 'wasm-unsafe-eval';")) << policy;
  for (const char* rule : {"default-src 'none'", "connect-src 'self'", "form-action 'none'",
                           "frame-ancestors 'none'", "base-uri 'none'"})
    EXPECT_TRUE(contains(policy, rule)) << policy;
  EXPECT_FALSE(contains(policy, "unsafe-inline") || contains(policy, "'unsafe-eval'")) << policy;
  const std::string other =
      header(api::http::page_part("text/html", "a page"), "Content-Security-Policy");
  EXPECT_TRUE(contains(other, "script-src 'self';")) << other;
}

}  // namespace
}  // namespace slackwater::tests::hands_routes_test
