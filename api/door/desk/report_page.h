#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "api/door/http/message.h"
#include "fields/base/time.h"

namespace slackwater::api::desk {

/// The page that `report` or the daily job wrote last, STORE/reports/SITE/DAY.html, of a day not
/// after tomorrow; nothing where there is none.
[[nodiscard]] std::optional<std::filesystem::path> report_page_of(
    const std::string& site, const std::filesystem::path& store_folder, UtcTime now);

/// That page: one file with style and script inside. `GET /sites/{site}/report.html`.
/// @throws Error(not_found) where there is none
[[nodiscard]] http::Response report_page(const std::string& site,
                                         const std::filesystem::path& store_folder, UtcTime now);

}  // namespace slackwater::api::desk
