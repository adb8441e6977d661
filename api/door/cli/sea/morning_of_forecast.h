#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "api/door/cli/command.h"
#include "api/door/morning/make_morning.h"
#include "api/pipeline/issue_forecast.h"
#include "data/store/store.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// What `forecast` was asked for beside its forecast.
struct MorningAsked {
  std::string site;     ///< as it was named
  std::string fly;      ///< for how long; empty: nothing is flown
  bool is_pdf = false;  ///< beside the page
};
/// @throws Error(usage) for what cannot be read
void expect_readable(const MorningAsked& asked);

/// What became of the morning of a forecast, for people and for programs. Texts may be empty.
struct MorningDone {
  std::string text;   ///< the answer in at most ten lines
  std::string notes;  ///< what went wrong, or what the hook did; a line each
  nlohmann::json json;
};

/// The morning report of a forecast that was issued just now, where its site lists tasks: the page
/// in the store, its PDF where that was asked for, and the operator's hook, which hears too why
/// there is no report. There is none of a hindcast, nor where another forecast of the day is in
/// force. What goes wrong is told and takes nothing from the forecast.
[[nodiscard]] MorningDone morning_of_forecast(store::Store& store, const Site& site,
                                              const Issue& issue, const MorningAsked& asked,
                                              const Context& context);

}  // namespace slackwater::api
