#pragma once
#include <filesystem>
#include <string>

namespace slackwater::api {

/// What stands where a demonstration wants its store.
struct StoreInTheWay {
  bool is_there = false;  ///< something stands there that would go
  bool is_store = true;   ///< false: the folder holds files, but no catalogue of a store
  std::string holds;      ///< "17 forecasts of saint_brieuc, 40 granules of 12 product files"
  std::string not_demos;  ///< what no demonstration put there; empty: nothing
};

/// Looks at FOLDER/store by its content, not by a mark that could outlive it. A demonstration's
/// store holds files of the synthetic ocean or files that stand to the byte in FOLDER/products,
/// forecasts of its site that were issued at 05:00 after their day D, and its site's file; whatever
/// else is found is somebody's work.
[[nodiscard]] StoreInTheWay look_at_demo_store(const std::filesystem::path& folder);

/// Removes what stands there. Only a demonstration's own store goes unasked; with `force` any store
/// goes, but never a folder that is none. Error(usage) that names what would have gone.
void clear_demo_store(const std::filesystem::path& folder, const StoreInTheWay& found, bool force);

}  // namespace slackwater::api
