#pragma once
#include <string>

#include "api/ask/decisions/decide.h"
#include "api/ask/decisions/decisions.h"

// Decisions as people say them.

namespace slackwater::api {

/// "go", "no-go".
[[nodiscard]] std::string word_of(store::Decided decided);

/// "scour_survey at T1"; of a sheet that is a file its name: "peek at T1".
[[nodiscard]] std::string task_and_place(const store::DecisionRow& row);

/// What was said then: "go, 93 %"; "nothing (why)".
[[nodiscard]] std::string said_text(const store::DecisionRow& row);

/// What came: "held", "did not hold: eye: wave height at most 1.5 m, exceeded at 09:10"; of a no-go
/// "would have held"; "not known yet: ..."; with how many limits nobody checked.
[[nodiscard]] std::string came_text(const DecisionAnswer& decision);

/// "of 40 goes 38 held; 6 workable days were lost; what came of 3 goes and 1 day with a no-go is
/// not known so far"; empty where nothing was decided.
[[nodiscard]] std::string record_text(const DecisionsRecord& record);

/// What is told at once of a decision that was filed, in lines: "decision 7 recorded: go for ...",
/// what the program says of the start, and what it replaces.
[[nodiscard]] std::string recorded_text(const DecisionMade& made);

/// All of an answer for people: a paragraph each, then the record.
[[nodiscard]] std::string decisions_text(const DecisionsAnswer& answer);

}  // namespace slackwater::api
