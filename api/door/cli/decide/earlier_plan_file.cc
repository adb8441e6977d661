#include "api/door/cli/decide/earlier_plan_file.h"

#include "api/door/cli/json_place.h"

namespace slackwater::api {
namespace {

EarlierPlan::Job read_job(const JsonPlace& place) {
  EarlierPlan::Job job;
  job.id = place.at("job").text();
  job.start = place.at("start").time();
  job.probability = place.at("probability").number(0, 1);
  job.vessel = place.at("vessel").text();
  job.crew = place.at("crew").text();
  const JsonPlace vehicles = place.at("vehicles");
  for (std::size_t k = 0; k < vehicles.size(); ++k) job.vehicles.push_back(vehicles.item(k).text());
  return job;
}

}  // namespace

EarlierPlan parse_earlier_plan(std::string_view json, std::string name) {
  const nlohmann::json document = parse_document(json, name);
  const JsonPlace root(document, name);
  EarlierPlan plan;
  plan.name = std::move(name);
  plan.site = root.at("site").text();
  plan.day = root.at("day").day();
  const JsonPlace jobs = root.at("jobs");
  for (std::size_t i = 0; i < jobs.size(); ++i) plan.jobs.push_back(read_job(jobs.item(i)));
  const JsonPlace left = root.at("left");
  for (std::size_t i = 0; i < left.size(); ++i)
    plan.left.push_back({left.item(i).at("job").text(), left.item(i).at("why").text()});
  return plan;
}

EarlierPlan load_earlier_plan(const std::filesystem::path& file) {
  return parse_earlier_plan(document_text(file.string()), file.string());
}

}  // namespace slackwater::api
