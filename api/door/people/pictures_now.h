#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "api/door/live/topics/sensor_publisher.h"
#include "api/door/people/role.h"

namespace slackwater::people {

/// The last picture of a camera.
struct PictureNow {
  std::uint64_t number = 0;  ///< of this camera, from 1
  double time_s = 0;         ///< of the run: the moment
  Milliseconds at = 0;       ///< the same, on the clock of the session
  int wide = 0;
  int high = 0;
  std::shared_ptr<const std::vector<std::uint8_t>> jpeg;
};

/// The last one of each camera of a session. Not thread-safe.
class PicturesNow {
 public:
  using Camera = std::pair<std::size_t, std::string>;  ///< place of the vehicle, sensor

  /// @param at  of the moment, on the clock of the session
  const PictureNow& take(const live::SensorPicture& picture, Milliseconds at);
  /// Null: there is none yet.
  [[nodiscard]] const PictureNow* find(const Camera& camera) const noexcept;
  [[nodiscard]] const std::map<Camera, PictureNow>& all() const noexcept { return all_; }

 private:
  std::map<Camera, PictureNow> all_;
};

/// What stations are told of it; api/docs/session_wire.md.
[[nodiscard]] nlohmann::json picture_json(const PicturesNow::Camera& camera,
                                          const PictureNow& picture);

}  // namespace slackwater::people
