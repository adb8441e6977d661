#include "api/door/people/hands_routes.h"

#include <fstream>
#include <iterator>
#include <string>

#include "api/door/http/page_part.h"
#include "api/web/assets.h"
#include "fields/base/error.h"

namespace slackwater::people {
namespace {

using api::http::PageMay;
using api::http::Request;
using api::http::Response;

std::string_view media_type_of(std::string_view name) {
  if (name.ends_with(".js")) return "text/javascript; charset=utf-8";
  return name.ends_with(".wasm") ? "application/wasm" : "application/octet-stream";
}

std::string bytes_of(const std::filesystem::path& folder, std::string_view name) {
  std::ifstream file(folder / name, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || bytes.empty())
    throw Error(ErrorKind::not_found,
                "found no file '" + std::string(name) +
                    "' of the detector of hands, expected those of @mediapipe/hands 0.4 in the "
                    "folder 'hands' of the data folder");
  return bytes;
}

}  // namespace

void add_hands_routes(api::http::Router& router, const std::filesystem::path& detector_folder) {
  const auto add = [&router](const std::string& path, std::string_view media_type,
                             std::function<std::string()> body) {
    router.add("GET", path, [media_type, body = std::move(body)](const Request&) {
      return page_part(media_type, body(), PageMay::compile_wasm);
    });
  };
  add("/session/hands", "text/html; charset=utf-8",
      [] { return std::string(web::hands_page().html); });
  add("/session/hands/page.js", "text/javascript; charset=utf-8",
      [] { return std::string(web::hands_page().script); });
  add("/session/hands/page.css", "text/css; charset=utf-8",
      [] { return std::string(web::hands_page().style); });
  for (const std::string_view name : hand_detector_files)
    add("/session/hands/model/" + std::string(name), media_type_of(name),
        [detector_folder, name] { return bytes_of(detector_folder, name); });
}

}  // namespace slackwater::people
