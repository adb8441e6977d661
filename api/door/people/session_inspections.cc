#include "api/door/http/problem.h"
#include "api/door/people/answers.h"
#include "api/door/people/session.h"

// What the vehicles of a session inspect, and how far they have come.

namespace slackwater::people {
namespace {

using nlohmann::json;

ToldInspection told_of(const InspectedNow& now) {
  return {now.surfaces_json(), now.covered_json(), now.findings_json()};
}

}  // namespace

/// What is inspected is known before anybody has looked. With the lock held, and before the ticker
/// knows that there is a run.
void Session::begin_inspections() {
  const auto& agents = desk_->agents();
  for (std::size_t i = 0; i < agents.size(); ++i)
    if (agents[i]->inspection) {
      inspected_[i] = std::make_unique<InspectedNow>(i, agents[i]->inspection);
      inspections_[i] = told_of(*inspected_[i]);
    }
}

void Session::mind_inspections() {
  struct New {
    std::size_t vehicle;
    std::shared_ptr<const twin::Inspection> inspection;
    std::shared_ptr<const twin::InspectionState> looks;
  };
  std::vector<New> all;
  {
    const std::lock_guard lock(mutex_);
    if (!desk_) return;
    const auto& agents = desk_->agents();
    for (std::size_t i = 0; i < now_.vehicles.size() && i < agents.size(); ++i)
      if (const auto& looks = now_.vehicles[i].looks; looks && looks != looks_minded_[i]) {
        looks_minded_[i] = looks;
        all.push_back({i, agents[i]->inspection, looks});
      }
  }
  for (const New& one : all) {
    auto& now = inspected_[one.vehicle];
    if (!now) now = std::make_unique<InspectedNow>(one.vehicle, one.inspection);
    const std::vector<json> news = now->take(*one.looks);
    ToldInspection told = told_of(*now);
    const std::lock_guard lock(mutex_);
    inspections_[one.vehicle] = std::move(told);
    for (const json& message : news) tell_all(message);
  }
}

api::http::Response Session::surface(const std::string& vehicle, const std::string& surface,
                                     const std::string& path) const {
  const auto place = number_in_path(vehicle), which = number_in_path(surface);
  std::shared_ptr<const twin::Inspection> inspection;
  std::string there;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [inspecting, told] : inspections_)
      for (const json& one : told.surfaces)
        there +=
            (there.empty() ? "" : ", ") + std::to_string(inspecting) + "/" + one["surface"].dump();
    if (desk_ && place && *place < desk_->agents().size())
      inspection = desk_->agents()[*place]->inspection;
  }
  if (!inspection || !which || *which >= inspection->surfaces.size())
    return api::http::problem(404,
                              "Found no surface '" + surface + "' of vehicle '" + vehicle + "'; " +
                                  (there.empty() ? "no vehicle of this run inspects anything."
                                                 : "there are " + there + "."),
                              path);
  return json_response(surface_json(inspection->surfaces[*which]));
}

}  // namespace slackwater::people
