/// HDF5 1.10, netCDF 4.9, ecCodes 2.28 and UDUNITS 2.2 forget blocks when they refuse damaged
/// input, as tests and fuzzing have shown. Leaks of our own are findings.
// NOLINTNEXTLINE(bugprone-reserved-identifier): the name that LeakSanitizer asks for
extern "C" const char* __lsan_default_suppressions();
// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libhdf5\nleak:libnetcdf\nleak:libeccodes\nleak:libudunits2\n";
}
