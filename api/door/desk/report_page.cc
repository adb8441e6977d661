#include "api/door/desk/report_page.h"

#include <fstream>
#include <iterator>
#include <system_error>

#include "api/door/morning/make_morning.h"
#include "fields/base/error.h"
#include "fields/site/site.h"

namespace slackwater::api::desk {
namespace {

/// A newer forecast of the day writes it anew.
constexpr int page_max_age_s = 10;

}  // namespace

std::optional<std::filesystem::path> report_page_of(const std::string& site,
                                                    const std::filesystem::path& store_folder,
                                                    UtcTime now) {
  if (!is_site_id(site)) return std::nullopt;
  // "2025-03-14.html", "2025-03-14_1200.html": the last name is the newest.
  const std::string too_late = format_day(day_of(now) + std::chrono::days(2));
  std::filesystem::path newest;
  std::error_code none;
  for (const auto& entry :
       std::filesystem::directory_iterator(reports_folder(store_folder, site), none)) {
    const std::filesystem::path name = entry.path().filename();
    if (name.extension() == ".html" && name < too_late && newest.filename() < name)
      newest = entry.path();
  }
  if (newest.empty()) return std::nullopt;
  return newest;
}

http::Response report_page(const std::string& site, const std::filesystem::path& store_folder,
                           UtcTime now) {
  const auto file = report_page_of(site, store_folder, now);
  std::ifstream stream(file.value_or(std::filesystem::path()), std::ios::binary);
  if (!file || !stream) {
    throw Error(ErrorKind::not_found,
                "found no page of a report of this site; `slackwater report "
                "--site SITE` writes one, as does `slackwater forecast` "
                "where the site lists tasks");
  }
  http::Response response;
  response.media_type = "text/html; charset=utf-8";
  response.body.assign(std::istreambuf_iterator<char>(stream), {});
  response.max_age_s = page_max_age_s;
  response.headers = {{"Content-Security-Policy",
                       "default-src 'none'; script-src 'unsafe-inline'; style-src "
                       "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'; "
                       "frame-ancestors 'none'"},
                      {"Referrer-Policy", "no-referrer"}};
  return response;
}

}  // namespace slackwater::api::desk
