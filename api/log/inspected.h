#pragma once
#include <memory>

#include "twin/inspection/inspection_outcome.h"

namespace slackwater::api {

/// An inspection of a run, with all that pictures and files are made from.
struct Inspected {
  std::shared_ptr<const twin::Inspection> what;
  twin::InspectionState state;  ///< at the end
  twin::InspectionOutcome outcome;
  twin::Findings findings;
};

}  // namespace slackwater::api
