#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "api/ask/detect/run_finds.h"
#include "api/show/detect/found_geojson.h"
#include "twin/render/lens/picture.h"

namespace slackwater::api {

/// A picture as a page shows it: small, and with a file of its own.
struct Thumbnail {
  std::vector<std::uint8_t> jpeg;
  int wide = 0;  ///< of the whole picture, which boxes are told in
  int high = 0;
};

/// Halved until it is no wider than 720 pixels, as JPEG.
[[nodiscard]] Thumbnail thumbnail_of(const twin::Picture& picture);

/// What a camera saw on a run and what a detector made of it, as one page that opens offline: the
/// findings, how much of what was planted was found, and a strip of the pictures with their boxes,
/// when, from how far, in what light. The truth is drawn when it is asked for, by a box to tick.
///
/// A page carries `most_on_page` pictures: first those with a find, then those that show a defect
/// which was not found, then the others, evenly; it says how many it leaves out.
///
/// @param thumbnails  one for each of the pictures
/// @param title       of the run
[[nodiscard]] std::string seen_page(const RunFinds& finds, const std::vector<Thumbnail>& thumbnails,
                                    const WhoLooked& who, const std::string& title);

}  // namespace slackwater::api
