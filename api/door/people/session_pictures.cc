#include "api/door/http/problem.h"
#include "api/door/people/answers.h"
#include "api/door/people/session.h"
#include "fields/base/error.h"

// What the cameras of a session's vehicles see.

namespace slackwater::people {

using nlohmann::json;

void Session::take_picture(const live::SensorPicture& picture) {
  const std::lock_guard lock(mutex_);
  if (is_over_) return;
  const auto at =
      std::chrono::duration_cast<std::chrono::milliseconds>(picture.at - began_).count();
  json told = picture_json({picture.vehicle, picture.sensor}, pictures_.take(picture, at));
  told["is"] = "picture";
  tell_all(told);
}

api::http::Response Session::picture(const std::string& vehicle, const std::string& sensor,
                                     const std::string& path) const {
  const std::lock_guard lock(mutex_);
  const auto place = number_in_path(vehicle);
  const PictureNow* const now = place ? pictures_.find({*place, sensor}) : nullptr;
  if (now == nullptr) {
    std::string there;
    for (const auto& [camera, picture] : pictures_.all())
      there += (there.empty() ? "" : ", ") + std::to_string(camera.first) + "/" + camera.second;
    return api::http::problem(404,
                              "Found no picture of vehicle '" + vehicle + "' by '" + sensor +
                                  "'; " +
                                  (there.empty() ? "no camera has seen anything yet (live --see)."
                                                 : "there are " + there + "."),
                              path);
  }
  api::http::Response response;
  response.media_type = "image/jpeg";
  response.body.assign(now->jpeg->begin(), now->jpeg->end());
  return response;
}

json Session::pictures_json() const {
  json pictures = json::array();
  for (const auto& [camera, now] : pictures_.all()) pictures.push_back(picture_json(camera, now));
  return pictures;
}

}  // namespace slackwater::people
