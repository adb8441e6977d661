#include "ingest/cf/attribution.h"

#include <initializer_list>

namespace slackwater::ingest {
namespace {

constexpr std::size_t longest_credit = 1000;

/// The first of these global attributes that says something and is no longer than a sentence.
std::string said_in(const netcdf::File& file, std::initializer_list<const char*> attributes) {
  for (const char* attribute : attributes) {
    const std::string text = file.text(attribute).value_or("");
    const std::size_t first = text.find_first_not_of(" \t\n");
    if (first == std::string::npos || text.size() > longest_credit) continue;
    const std::size_t last = text.find_last_not_of(" \t\n");
    return text.substr(first, last - first + 1);
  }
  return {};
}

}  // namespace

std::string attribution_of(const netcdf::File& file, const Product& product,
                           std::string_view made_by) {
  if (!product.attribution.empty()) return product.attribution;
  std::string asked = said_in(file, {"acknowledgement", "acknowledgment", "citation", "credit"});
  if (!asked.empty()) return asked;
  const std::string maker =
      said_in(file, {"institution", "Institution", "agency", "creator_institution", "centre"});
  if (!maker.empty()) return std::string(made_by) + " " + maker;
  const std::string name = said_in(file, {"title", "source"});
  if (!name.empty()) return "Maker not named in the file; it calls itself: " + name;
  return "Source not named in the file";
}

}  // namespace slackwater::ingest
