# The step of eight vehicles: one source, one object library per instruction set, as in fields/wave/kernels.cmake (which see).
function(slackwater_step_kernel name)
  add_library(slackwater_step_${name} OBJECT ${CMAKE_CURRENT_LIST_DIR}/step_kernel.cc)
  target_link_libraries(slackwater_step_${name} PRIVATE slackwater_options)
  target_compile_definitions(slackwater_step_${name} PRIVATE SLACKWATER_KERNEL=kernel_${name})
  target_compile_options(slackwater_step_${name} PRIVATE -O3 -ffp-contract=off -fno-math-errno -fno-trapping-math -Wno-psabi
                         ${ARGN})
  target_sources(slackwater_twin PRIVATE $<TARGET_OBJECTS:slackwater_step_${name}>)
endfunction()

slackwater_step_kernel(baseline)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  slackwater_step_kernel(avx2 -mavx2)
  slackwater_step_kernel(avx512 -mavx512f -mprefer-vector-width=512)
  target_compile_definitions(slackwater_twin PRIVATE SLACKWATER_X86_KERNELS)
endif()
