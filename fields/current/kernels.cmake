# The batch kernels of fields/current: one source, one object library per instruction set, chosen at run time by
# __builtin_cpu_supports. Contraction stays off everywhere, so that all paths give the same bits; -O3 in every
# build type, because the loops are written to be vectorised.
function(slackwater_steady_kernel name)
  add_library(slackwater_steady_${name} OBJECT ${CMAKE_CURRENT_LIST_DIR}/steady_column_kernel.cc)
  target_link_libraries(slackwater_steady_${name} PRIVATE slackwater_options)
  target_compile_definitions(slackwater_steady_${name} PRIVATE SLACKWATER_KERNEL=kernel_${name})
  target_compile_options(slackwater_steady_${name} PRIVATE -O3 -ffp-contract=off ${ARGN})
  target_sources(slackwater_fields PRIVATE $<TARGET_OBJECTS:slackwater_steady_${name}>)
endfunction()

slackwater_steady_kernel(baseline)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  slackwater_steady_kernel(avx2 -mavx2)
  slackwater_steady_kernel(avx512 -mavx512f -mprefer-vector-width=512)
  target_compile_definitions(slackwater_fields PRIVATE SLACKWATER_X86_KERNELS)
endif()
