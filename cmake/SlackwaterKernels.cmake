# slackwater_kernels(<room> <name> <source> [OPTIONS <flags>])
#
# A batch kernel: one source, one object library per instruction set, chosen at run time by
# __builtin_cpu_supports. SLACKWATER_KERNEL names the namespace of each, so that the linker never
# takes a function from the wrong one. Contraction stays off everywhere, so that all give the same
# bits; -O3 in every build type, because the loops are written to be vectorised. Sanitizers see the
# baseline alone: the others are the same source, and ten times as long to instrument.
function(slackwater_kernels room name source)
  cmake_parse_arguments(K "" "" "OPTIONS" ${ARGN})
  set(sets baseline)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    set(flags_avx2 -mavx2)
    set(flags_avx512 -mavx512f -mprefer-vector-width=512)
    list(APPEND sets avx2 avx512)
    target_compile_definitions(${room} PRIVATE SLACKWATER_X86_KERNELS)
  endif()
  foreach(set ${sets})
    set(library slackwater_${name}_${set})
    add_library(${library} OBJECT ${source})
    target_link_libraries(${library} PRIVATE slackwater_options)
    target_compile_definitions(${library} PRIVATE SLACKWATER_KERNEL=kernel_${set})
    target_compile_options(${library} PRIVATE -O3 -ffp-contract=off ${K_OPTIONS} ${flags_${set}})
    if(SLACKWATER_SANITIZE AND NOT set STREQUAL baseline)
      target_compile_options(${library} PRIVATE -fno-sanitize=all)
    endif()
    target_sources(${room} PRIVATE $<TARGET_OBJECTS:${library}>)
  endforeach()
endfunction()
