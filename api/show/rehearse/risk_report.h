#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "twin/risk/risk_register.h"

namespace slackwater::api {

/// `risks` of a start in JSON: api/docs/rehearse.md has the schema.
[[nodiscard]] nlohmann::json risks_json(const std::vector<twin::RiskEntry>& risks);

/// For people, the gravest first: "the tether parts or is fouled: 2 of 24 (1 to 24 %), asset 4 of
/// 5: medium to high". What befell no flight is left out.
[[nodiscard]] std::vector<std::string> risk_texts(const std::vector<twin::RiskEntry>& risks);

/// What a table of risks says in its columns "Cause", "Befell", "Likelihood", "Worst harm", "Risk".
[[nodiscard]] std::vector<std::string> risk_cells(const twin::RiskEntry& risk);

/// The register as a table of a page; empty of none.
[[nodiscard]] std::string risk_table_html(const std::string& title,
                                          const std::vector<twin::RiskEntry>& risks);

}  // namespace slackwater::api
