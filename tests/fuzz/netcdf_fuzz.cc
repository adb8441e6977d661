#include "tests/fuzz/fuzz_case.h"
#include "tests/fuzz/granule_oracle.h"
#include "tests/fuzz/scratch_folder.h"

/// Product files and observations: the bytes of a NetCDF file, decoded with the real descriptors
/// into canonical granules.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slackwater;
  const auto file = fuzz::scratch_folder().file_of(data, size, "product.nc");
  const auto staging = fuzz::scratch_folder().staging();
  ingest::Ingested ingested;
  const bool decoded =
      fuzz::accepts([&] { ingested = ingest::decode_file(file, fuzz::products(), {}, staging); });
  // What was decoded must read back: a refusal here would be a finding, so it is not allowed to be
  // an Error.
  if (decoded)
    fuzz::claim(fuzz::accepts([&] { fuzz::claim_sound(ingested, true); }),
                "what was decoded is refused");
  if (!decoded)
    fuzz::claim(std::filesystem::is_empty(staging), "a refused file leaves something behind");
  return 0;
}
