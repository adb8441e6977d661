#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "api/perception/detection.h"
#include "twin/render/lens/picture.h"

namespace slackwater::api {

/// Finds things in pictures. Not thread-safe: one for each thread.
class Detector {
 public:
  Detector() = default;
  virtual ~Detector() = default;
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;

  /// What it can find.
  [[nodiscard]] virtual const std::vector<std::string>& kinds() const noexcept = 0;
  /// Surest first; the same answer for the same picture.
  [[nodiscard]] virtual std::vector<Detection> find(const twin::Picture& picture) = 0;
  /// The same, and after them what it is not sure enough of to tell, down to a confidence of 0.05
  /// where it has one: what could be found at the price of more false alarms.
  [[nodiscard]] virtual std::vector<Detection> find_unsure_too(const twin::Picture& picture) {
    return find(picture);
  }
  /// `find` tells what it is so sure of.
  [[nodiscard]] virtual double least_confidence() const noexcept { return 0; }
};

/// One of data/detectors by its name, else a file of that form (network.h and those beside it).
/// @throws Error(not_found) that names those there are; Error(invalid_input) as `read_detector`
[[nodiscard]] std::unique_ptr<Detector> load_detector(const std::string& name_or_file);

}  // namespace slackwater::api
