#pragma once
#include <system_error>

#include "ingest/decoded/ingested.h"

namespace slackwater::ingest {

/// Removes the content files of `ingested` if the decoding does not come to its end: a refused file
/// leaves nothing in the staging folder. Call `keep()` last.
class StagedFiles {
 public:
  explicit StagedFiles(const Ingested& ingested) : ingested_(ingested) {}
  ~StagedFiles() {
    if (kept_) return;
    std::error_code ignored;
    for (const DecodedGranule& granule : ingested_.granules) {
      std::filesystem::remove(granule.content_file, ignored);
    }
  }
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;
  void keep() noexcept { kept_ = true; }

 private:
  const Ingested& ingested_;
  bool kept_ = false;
};

}  // namespace slackwater::ingest
