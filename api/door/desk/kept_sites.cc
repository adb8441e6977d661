#include "api/door/desk/kept_sites.h"

#include <utility>

#include "api/program/paths.h"
#include "fields/base/error.h"

namespace slackwater::api::desk {

SiteText described_text(const std::string& id, const std::filesystem::path& store_folder) {
  if (!is_site_id(id))
    throw Error(ErrorKind::not_found, "found no site by that id; GET /sites lists what there is");
  return find_site_text(id, site_folders(store_folder));
}

KeptSites::KeptSites(std::filesystem::path store_folder, std::size_t most)
    : store_folder_(std::move(store_folder)), most_(most) {}

std::shared_ptr<const Site> KeptSites::site(const std::string& id) {
  const SiteText text = described_text(id, store_folder_);
  {
    const std::lock_guard lock(mutex_);
    const auto found = kept_.find(id);
    // A refusal names the file: the same text in another folder is read anew.
    if (found != kept_.end() && found->second.file == text.file &&
        found->second.site->yaml == text.yaml)
      return found->second.site;
  }
  auto site = std::make_shared<const Site>(parse_site(text.yaml, text.file));
  const std::lock_guard lock(mutex_);
  if (const auto before = kept_.find(id); before != kept_.end()) {
    bytes_ -= before->second.site->yaml.size();
    kept_.erase(before);
  }
  if (text.yaml.size() > most_) return site;
  if (bytes_ + text.yaml.size() > most_) {
    kept_.clear();
    bytes_ = 0;
  }
  bytes_ += text.yaml.size();
  kept_[id] = {text.file, site};
  return site;
}

std::size_t KeptSites::kept_bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

}  // namespace slackwater::api::desk
