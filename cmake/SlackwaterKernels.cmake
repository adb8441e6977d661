# slackwater_kernels(<room> <name> <source> [OPTIONS <flags>])
#
# A batch kernel: one source, one object library per instruction set, chosen at run time by
# __builtin_cpu_supports. SLACKWATER_KERNEL names the namespace of each, so that the linker never
# takes a function from the wrong one. Contraction stays off everywhere, so that all give the same
# bits; -O3 in every build type, because the loops are written to be vectorised. Sanitizers see the
# baseline alone: the others are the same source, ten times as long to instrument, and call the
# library at each load of a register wider than 16 bytes, six times as long to fly.
#
# The flag is a library's, linked last: options of a target stand before those of its libraries, and
# the last word on sanitizers counts.
add_library(slackwater_unsanitized INTERFACE)
target_compile_options(slackwater_unsanitized INTERFACE -fno-sanitize=all)

function(slackwater_kernels room name source)
  cmake_parse_arguments(K "" "" "OPTIONS" ${ARGN})
  set_property(GLOBAL APPEND PROPERTY SLACKWATER_KERNELS ${name})
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
    target_compile_options(${library} PRIVATE -O3 -ffp-contract=off ${K_OPTIONS}
                           ${SLACKWATER_KERNEL_OPTIONS} ${flags_${set}})
    if(SLACKWATER_SANITIZE AND NOT set STREQUAL baseline)
      target_link_libraries(${library} PRIVATE slackwater_unsanitized)
    endif()
    target_sources(${room} PRIVATE $<TARGET_OBJECTS:${library}>)
  endforeach()
endfunction()
