# Flags that every target of ours shares.
#
# Arithmetic is deterministic: no contraction into fused multiply-adds, never fast-math, so that the
# same inputs give the same bits on every instruction set.
add_library(slackwater_options INTERFACE)
target_include_directories(slackwater_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
  $<INSTALL_INTERFACE:include/slackwater>)
target_compile_features(slackwater_options INTERFACE cxx_std_20)
# Warnings are for our own sources, not for the programs of others that find_package(Slackwater).
target_compile_options(slackwater_options INTERFACE
  "$<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wconversion;-Wshadow;-Wnon-virtual-dtor>"
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC 12 warns of overlaps in std::string::insert that cannot be (GCC bug 105651).
  target_compile_options(slackwater_options
                         INTERFACE "$<BUILD_INTERFACE:-Wno-restrict;-fpch-preprocess>")
else()
  # Clang counts changes of sign among conversions, GCC does not; `&` of two conditions is meant
  # where it stands: it asks both without a branch.
  target_compile_options(slackwater_options INTERFACE
    "$<BUILD_INTERFACE:-Wno-sign-conversion;-Wno-bitwise-instead-of-logical>")
  if(SLACKWATER_UNITY)  # where a constant of the file beside it shadows, too
    target_compile_options(slackwater_options INTERFACE "$<BUILD_INTERFACE:-Wno-shadow>")
  endif()
endif()
# GCC 12's flow warnings follow its optimiser, and see in inlined library code what is not there
# (GCC bugs 105562, 105329, 105651): where warnings are errors they warn, but do not end a build;
# who only builds to run is not shown them.
set(flow_warnings maybe-uninitialized stringop-overflow stringop-overread array-bounds
    null-dereference free-nonheap-object)
if(SLACKWATER_WERROR)
  target_compile_options(slackwater_options INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  foreach(flow ${flow_warnings})
    if(SLACKWATER_WERROR)
      target_compile_options(slackwater_options INTERFACE $<BUILD_INTERFACE:-Wno-error=${flow}>)
    else()
      target_compile_options(slackwater_options INTERFACE $<BUILD_INTERFACE:-Wno-${flow}>)
    endif()
  endforeach()
endif()
# Under ASan Eigen would align by hand, unlike the Ceres library of the system: memory that crosses
# between them must be allocated one way. glibc's malloc is aligned to 16 bytes, which is all that
# either asks for.
target_compile_definitions(slackwater_options INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
if(SLACKWATER_SANITIZE)
  target_compile_options(slackwater_options INTERFACE -fsanitize=${SLACKWATER_SANITIZE}
                         -fno-omit-frame-pointer
                         -fno-sanitize-recover=all)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU AND SLACKWATER_SANITIZE MATCHES address)
    # GCC says so itself, clang in a way of its own; the code asks as GCC says it.
    target_compile_definitions(slackwater_options INTERFACE __SANITIZE_ADDRESS__=1)
  endif()
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU AND SLACKWATER_SANITIZE MATCHES thread)
    target_compile_definitions(slackwater_options INTERFACE __SANITIZE_THREAD__=1)
  endif()
  target_link_options(slackwater_options INTERFACE -fsanitize=${SLACKWATER_SANITIZE})
  if(SLACKWATER_SANITIZE MATCHES undefined)
    # What ASan or the machine sees anyway. These checks stand before every dereference and double
    # the time to build.
    target_compile_options(slackwater_options INTERFACE
      -fno-sanitize=null,alignment,object-size,vptr,pointer-overflow
      -fno-sanitize=nonnull-attribute,returns-nonnull-attribute)
  endif()
endif()
if(SLACKWATER_COVERAGE)
  target_compile_options(slackwater_options INTERFACE --coverage)
  target_link_options(slackwater_options INTERFACE --coverage)
endif()

# What users run ends at once, rather than go on wrongly, where a bound of the standard library, the
# stack, a return address or a buffer of the C library is overrun; its tables of calls are
# read-only. Sanitizers watch the same in their own ways.
if(CMAKE_BUILD_TYPE STREQUAL Release AND NOT SLACKWATER_SANITIZE AND NOT SLACKWATER_COVERAGE)
  add_compile_options(-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2 -D_GLIBCXX_ASSERTIONS
                      -fstack-protector -fstack-clash-protection)
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
    add_compile_options(-fcf-protection=full)
  endif()
  add_link_options(-Wl,-z,relro -Wl,-z,now)
  # Steps of the twin take up to 7 % longer by it (an x500 in a batch of slackwater_twin_bench; 1 to
  # 2 % in the median of its figures). The kernels, and the folders that a room says only calculate,
  # do without: they are given numbers of ours, no bytes of others. Guards on every stack with an
  # array (-strong) would be another 1 %.
  set(SLACKWATER_KERNEL_OPTIONS -U_GLIBCXX_ASSERTIONS -fno-stack-protector
      -fno-stack-clash-protection -fcf-protection=none)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  # Precompiled headers are cached too when ccache may ignore their time stamps; clones in other
  # folders share the cache.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
endif()

# Forty programs that each hold most of the library: mold links them in half the time of GNU ld.
find_program(MOLD mold)
if(MOLD)
  add_link_options(-fuse-ld=mold)
endif()
# A program loads the libraries that it calls, and not all that those of Ceres, OpenCV or Fast DDS
# were built with. Debian's GCC asks for that itself, but not clang, nor GCC with a sanitizer.
add_link_options(-Wl,--as-needed)

# What nearly every source reads, once for all rooms instead of once per source: a third of the
# build's time.
set(SLACKWATER_PRECOMPILED <algorithm> <array> <chrono> <cmath> <complex> <filesystem> <functional>
    <map> <memory> <optional> <span> <string> <string_view> <vector> <Eigen/Core>)
add_library(slackwater_precompiled OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cc)
target_link_libraries(slackwater_precompiled PRIVATE slackwater_options slackwater_lib_eigen)
target_precompile_headers(slackwater_precompiled PRIVATE ${SLACKWATER_PRECOMPILED})
if(SLACKWATER_KERNEL_OPTIONS)
  # GCC takes a precompiled header for the same flags alone.
  add_library(slackwater_precompiled_unguarded OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cc)
  target_link_libraries(slackwater_precompiled_unguarded
                        PRIVATE slackwater_options slackwater_lib_eigen)
  target_compile_options(slackwater_precompiled_unguarded PRIVATE ${SLACKWATER_KERNEL_OPTIONS})
  target_precompile_headers(slackwater_precompiled_unguarded PRIVATE ${SLACKWATER_PRECOMPILED})
endif()

# slackwater_unity(<target> <sources>)
#
# Sources of one folder are compiled together, twelve at a time: half the time of a build, for most
# of what a source costs is reading the same headers. So a name in an unnamed namespace is one of
# its folder's. With SLACKWATER_UNITY=OFF each source is a unit of its own, as for clang-tidy.
function(slackwater_unity target)
  if(NOT SLACKWATER_UNITY)
    return()
  endif()
  foreach(source ${ARGN})
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER ${folder} folder)
    list(APPEND of_${folder} ${source})
    list(LENGTH of_${folder} count)
    math(EXPR batch "(${count} - 1) / 12")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${batch})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # GCC takes what is included for a header, whose types should not use an unnamed namespace.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# slackwater_room(<name> [FOLDER <folder>] [LINK <public targets>] [PRIVATE <private targets>]
#                 [PRECOMPILE <headers> | REUSE <room>] [CALCULATES <folders>])
#
# One static library per room, from every .cc below the folder, under the name slackwater::<name>.
# REUSE takes the precompiled headers of another room, PRECOMPILE makes its own with more in them.
# Folders that calculate are compiled as kernels are: see SLACKWATER_KERNEL_OPTIONS.
function(slackwater_room name)
  cmake_parse_arguments(ROOM "" "FOLDER;REUSE" "LINK;PRIVATE;EXCLUDE;PRECOMPILE;CALCULATES" ${ARGN})
  set(ROOM_FOLDER ${CMAKE_CURRENT_SOURCE_DIR}/${ROOM_FOLDER})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${ROOM_FOLDER}/*.cc)
  foreach(pattern ${ROOM_EXCLUDE})
    list(FILTER sources EXCLUDE REGEX ${pattern})
  endforeach()
  set(objects)
  if(SLACKWATER_KERNEL_OPTIONS AND ROOM_CALCULATES)
    list(JOIN ROOM_CALCULATES "|" folders)
    set(calculating ${sources})
    list(FILTER calculating INCLUDE REGEX "^${ROOM_FOLDER}/(${folders})/")
    list(REMOVE_ITEM sources ${calculating})
    add_library(slackwater_${name}_calculating OBJECT ${calculating})
    target_link_libraries(slackwater_${name}_calculating
                          PRIVATE slackwater_options ${ROOM_LINK} ${ROOM_PRIVATE})
    target_compile_options(slackwater_${name}_calculating PRIVATE ${SLACKWATER_KERNEL_OPTIONS})
    target_precompile_headers(slackwater_${name}_calculating
                              REUSE_FROM slackwater_precompiled_unguarded)
    slackwater_unity(slackwater_${name}_calculating ${calculating})
    set(objects $<TARGET_OBJECTS:slackwater_${name}_calculating>)
  endif()
  add_library(slackwater_${name} STATIC ${sources} ${objects})
  add_library(slackwater::${name} ALIAS slackwater_${name})
  target_link_libraries(slackwater_${name} PUBLIC slackwater_options ${ROOM_LINK}
                        PRIVATE ${ROOM_PRIVATE})
  if(ROOM_REUSE)
    target_precompile_headers(slackwater_${name} REUSE_FROM ${ROOM_REUSE})
  elseif(ROOM_PRECOMPILE)
    target_precompile_headers(slackwater_${name} PRIVATE ${SLACKWATER_PRECOMPILED}
                              ${ROOM_PRECOMPILE})
  else()
    target_precompile_headers(slackwater_${name} REUSE_FROM slackwater_precompiled)
  endif()
  slackwater_unity(slackwater_${name} ${sources})
  slackwater_doors(${name})
endfunction()
