#include "api/perception/labelled_pictures.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::uintmax_t most_json_bytes = 512'000'000;

fs::path json_file_of(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw Error(ErrorKind::not_found, "found no folder " + folder.string());
  for (const fs::path& place : {folder, folder / "annotations"}) {
    std::vector<fs::path> files;
    if (!fs::is_directory(place)) continue;
    for (const auto& entry : fs::directory_iterator(place))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
    if (files.size() == 1) return files.front();
    if (files.size() > 1)
      refuse(formatted("found {} JSON files in {}, expected one: name it with --labels",
                       files.size(), place.string()));
  }
  throw Error(ErrorKind::not_found,
              "found no JSON file in " + folder.string() +
                  " nor in its annotations, expected the labels as COCO has them");
}

json parsed(const fs::path& file) {
  if (!fs::is_regular_file(file))
    throw Error(ErrorKind::not_found, "found no file " + file.string());
  if (const auto size = fs::file_size(file); size > most_json_bytes)
    refuse(formatted("found {} bytes, expected at most {}", size, most_json_bytes));
  std::ifstream stream(file);
  json read = json::parse(stream, nullptr, false);
  if (!read.is_object()) refuse("found no JSON object, expected the labels as COCO has them");
  return read;
}

const json& list_of(const json& set, const char* key) {
  const auto found = set.find(key);
  if (found == set.end() || !found->is_array())
    refuse(formatted("found no list {}, expected images, annotations and categories", key));
  return *found;
}

std::int64_t id_of(const json& one, const char* key, const std::string& what) {
  const auto found = one.is_object() ? one.find(key) : one.end();
  if (found == one.end() || !found->is_number_integer())
    refuse(formatted("{}: found no whole number {}", what, key));
  return found->get<std::int64_t>();
}

std::string text_of(const json& one, const char* key, const std::string& what) {
  const auto found = one.find(key);
  if (found == one.end() || !found->is_string() || found->get<std::string>().empty())
    refuse(formatted("{}: found no text {}", what, key));
  return found->get<std::string>();
}

/// Where a picture of the set lies, if anywhere.
fs::path picture_file(const fs::path& folder, const std::string& name, const std::string& what) {
  const fs::path relative = fs::path(name).lexically_normal();
  if (relative.is_absolute() || relative.begin() == relative.end() || *relative.begin() == "..")
    refuse(what + ": found the file_name " + name + ", expected one below the folder of the set");
  const fs::path in_images = folder / "images" / relative;
  return !fs::exists(folder / relative) && fs::exists(in_images) ? in_images : folder / relative;
}

double number_of(const json& one, const char* key, const std::string& what) {
  const auto found = one.is_object() ? one.find(key) : one.end();
  if (found == one.end() || !found->is_number())
    refuse(formatted("{}: found no number {}", what, key));
  return found->get<double>();
}

PlantedInLook planted_of(const json& one, const std::string& what) {
  PlantedInLook planted;
  planted.of = text_of(one, "kind", what);
  planted.size_m = number_of(one, "size_m", what);
  if (!(planted.size_m > 0))
    refuse(formatted("{}: found size_m {:g}, expected more than 0", what, planted.size_m));
  planted.ground_sampling_m = number_of(one, "ground_sampling_m", what);
  if (!(planted.ground_sampling_m >= 0))
    refuse(formatted("{}: found ground_sampling_m {:g}, expected 0 or more", what,
                     planted.ground_sampling_m));
  const auto detail = one.find("detail_m");
  planted.detail_m = detail != one.end() && detail->is_null()
                         ? std::numeric_limits<double>::infinity()
                         : number_of(one, "detail_m", what);
  if (!(planted.detail_m > 0))
    refuse(
        formatted("{}: found detail_m {:g}, expected more than 0, or null where the place is not "
                  "seen",
                  what, planted.detail_m));
  const auto centre = one.find("centre_px");
  if (centre == one.end() || !centre->is_array() || centre->size() != 2 ||
      !centre->at(0).is_number() || !centre->at(1).is_number())
    refuse(what + ": found no centre_px, expected [u, v] in pixels");
  planted.u = centre->at(0).get<double>();
  planted.v = centre->at(1).get<double>();
  return planted;
}

std::optional<LookFacts> look_of(const json& one, const std::string& what) {
  const auto found = one.find("look");
  if (found == one.end() || !found->is_object()) return std::nullopt;
  LookFacts look{number_of(*found, "range_m", what),
                 number_of(*found, "visibility_m", what),
                 number_of(*found, "seen_m2", what),
                 {}};
  if (!(look.seen_m2 >= 0))
    refuse(formatted("{}: found seen_m2 {:g}, expected 0 or more", what, look.seen_m2));
  for (const json& planted : list_of(*found, "planted"))
    look.planted.push_back(planted_of(planted, what + ", planted"));
  return look;
}

LabelledPicture picture_of(const json& one, const fs::path& folder, const std::string& what) {
  LabelledPicture picture;
  picture.id = id_of(one, "id", what);
  picture.file = picture_file(folder, text_of(one, "file_name", what), what);
  const std::int64_t wide = id_of(one, "width", what), high = id_of(one, "height", what);
  if (wide < 1 || high < 1 || wide > 1'000'000 || high > 1'000'000)
    refuse(formatted("{}: found {} x {} pixels", what, wide, high));
  picture.wide = static_cast<int>(wide);
  picture.high = static_cast<int>(high);
  picture.look = look_of(one, what);
  return picture;
}

PixelBox box_of(const json& one, const LabelledPicture& picture, const std::string& what) {
  const auto found = one.find("bbox");
  std::vector<double> sides;
  if (found != one.end() && found->is_array() && found->size() == 4)
    for (const json& side : *found)
      if (side.is_number()) sides.push_back(side.get<double>());
  if (sides.size() != 4 ||
      !std::all_of(sides.begin(), sides.end(), [](double side) { return std::isfinite(side); }))
    refuse(what + ": found no bbox, expected [left, top, width, height] in pixels");
  const PixelBox box{sides[0], sides[1], sides[0] + sides[2], sides[1] + sides[3]};
  // Labels are drawn by hand: a pixel over the edge is none too many.
  if (!(sides[2] > 0 && sides[3] > 0) || box.left < -1 || box.top < -1 ||
      box.right > picture.wide + 1 || box.bottom > picture.high + 1)
    refuse(
        formatted("{}: found the bbox {:g}, {:g}, {:g} wide, {:g} high, expected one in its "
                  "picture of {} x {} pixels",
                  what, sides[0], sides[1], sides[2], sides[3], picture.wide, picture.high));
  return box;
}

bool is_crowd(const json& one, const std::string& what) {
  const auto found = one.find("iscrowd");
  if (found == one.end()) return false;
  if (found->is_boolean()) return found->get<bool>();
  if (!found->is_number_integer()) refuse(what + ": found an iscrowd that is neither 0 nor 1");
  return found->get<std::int64_t>() != 0;
}

std::optional<std::size_t> planted_place(const json& one, const LabelledPicture& picture,
                                         const std::string& what) {
  if (!picture.look) return std::nullopt;
  const std::int64_t place = id_of(one, "planted_number", what);
  const auto many = static_cast<std::int64_t>(picture.look->planted.size());
  if (place < 0 || place >= many)
    refuse(formatted("{}: found planted_number {}, but the look planted {}", what, place, many));
  return static_cast<std::size_t>(place);
}

LabelledPictures set_of(const json& read, const fs::path& folder) {
  LabelledPictures set;
  std::map<std::int64_t, std::string> names;
  for (const json& one : list_of(read, "categories")) {
    const std::string what = formatted("categories, number {}", names.size() + 1);
    const std::int64_t id = id_of(one, "id", what);
    const std::string name = text_of(one, "name", what);
    if (!names.emplace(id, name).second || !set.categories.emplace(name, id).second)
      refuse(what + ": found " + name + " or its id a second time");
  }
  std::map<std::int64_t, std::size_t> places;
  for (const json& one : list_of(read, "images")) {
    const std::string what = formatted("images, number {}", set.pictures.size() + 1);
    set.pictures.push_back(picture_of(one, folder, what));
    if (!places.emplace(set.pictures.back().id, set.pictures.size() - 1).second)
      refuse(formatted("{}: found the id {} a second time", what, set.pictures.back().id));
  }
  std::size_t nth = 0;
  for (const json& one : list_of(read, "annotations")) {
    const std::string what = formatted("annotations, number {}", ++nth);
    const auto picture = places.find(id_of(one, "image_id", what));
    const auto name = names.find(id_of(one, "category_id", what));
    if (picture == places.end() || name == names.end())
      refuse(what + ": found a picture or category that is not listed");
    LabelledPicture& of = set.pictures[picture->second];
    of.labels.push_back(
        {name->second, box_of(one, of, what), is_crowd(one, what), planted_place(one, of, what)});
  }
  if (set.pictures.empty()) refuse("found no pictures in the list images");
  return set;
}

}  // namespace

LabelledPictures read_labelled_pictures(const fs::path& folder, const fs::path& labels) {
  const fs::path file = labels.empty() ? json_file_of(folder) : labels;
  return with_context("reading " + file.string(), [&] { return set_of(parsed(file), folder); });
}

}  // namespace slackwater::api
