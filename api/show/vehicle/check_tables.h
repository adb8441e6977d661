#pragma once
#include <string>
#include <vector>

#include "api/ask/vehicle/vehicle_check.h"
#include "api/show/report/html_page.h"

namespace slackwater::api {

/// How a vehicle lies and goes, as tables of words: at rest, by speed, its modes.
[[nodiscard]] std::vector<ReportTable> check_tables(const VehicleCheck& check);
/// The figures of a manoeuvre, or why there are none.
[[nodiscard]] std::string figures_of(const FlownManoeuvre& manoeuvre);

/// The sentence to read first: "goes straight by itself and keeps its course", or what it does not.
[[nodiscard]] std::string check_verdict(const VehicleCheck& check);

/// Tables, each with its title, columns as wide as their cells.
[[nodiscard]] std::string tables_text(const std::vector<ReportTable>& tables);

}  // namespace slackwater::api
