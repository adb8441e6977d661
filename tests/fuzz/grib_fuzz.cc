#include "ingest/grib/grib_file.h"
#include "tests/fuzz/fuzz_case.h"
#include "tests/fuzz/granule_oracle.h"
#include "tests/fuzz/scratch_folder.h"

/// GRIB messages, editions 1 and 2, decoded into canonical granules.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slackwater;
  const auto file = fuzz::scratch_folder().file_of(data, size, "nwp.grib");
  ingest::Ingested ingested;
  const auto staging = fuzz::scratch_folder().staging();
  const bool decoded =
      fuzz::accepts([&] { ingested = ingest::decode_grib(file, fuzz::products(), {}, staging); });
  if (decoded)
    fuzz::claim(fuzz::accepts([&] { fuzz::claim_sound(ingested, false); }),
                "what was decoded is refused");
  if (!decoded)
    fuzz::claim(std::filesystem::is_empty(staging), "a refused file leaves something behind");
  return 0;
}
