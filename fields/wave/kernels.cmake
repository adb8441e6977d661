# The batch kernel of fields/wave: one source, one object library per instruction set, as in fields/current/kernels.cmake
# (which see). The vectors of lanes.h are passed between inlined functions only, hence -Wno-psabi.
function(slackwater_wave_kernel name)
  add_library(slackwater_wave_${name} OBJECT ${CMAKE_CURRENT_LIST_DIR}/sea_kernel.cc)
  target_link_libraries(slackwater_wave_${name} PRIVATE slackwater_options)
  target_compile_definitions(slackwater_wave_${name} PRIVATE SLACKWATER_KERNEL=kernel_${name})
  target_compile_options(slackwater_wave_${name} PRIVATE -O3 -ffp-contract=off -fno-math-errno -fno-trapping-math -Wno-psabi ${ARGN})
  target_sources(slackwater_fields PRIVATE $<TARGET_OBJECTS:slackwater_wave_${name}>)
endfunction()

slackwater_wave_kernel(baseline)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  slackwater_wave_kernel(avx2 -mavx2)
  slackwater_wave_kernel(avx512 -mavx512f -mprefer-vector-width=512)
endif()
