#include "api/door/people/pictures_now.h"

#include <nlohmann/json.hpp>

namespace slackwater::people {

const PictureNow& PicturesNow::take(const live::SensorPicture& picture, Milliseconds at) {
  PictureNow& now = all_[{picture.vehicle, picture.sensor}];
  now = {now.number + 1, picture.t_s, at, picture.wide, picture.high, picture.jpeg};
  return now;
}

const PictureNow* PicturesNow::find(const Camera& camera) const noexcept {
  const auto found = all_.find(camera);
  return found == all_.end() ? nullptr : &found->second;
}

nlohmann::json picture_json(const PicturesNow::Camera& camera, const PictureNow& picture) {
  return {{"vehicle", camera.first},  {"sensor", camera.second}, {"number", picture.number},
          {"time_s", picture.time_s}, {"at", picture.at},        {"wide", picture.wide},
          {"high", picture.high}};
}

}  // namespace slackwater::people
