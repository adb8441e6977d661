# What fastddsgen makes of idl/: code that encodes and decodes each message, and, for peers in
# tests, its type support. Others' code: without our warnings, and without sanitizers, which would
# take minutes over it.
find_package(fastcdr REQUIRED)
find_package(fastrtps 2.9 REQUIRED)
find_program(FASTDDSGEN fastddsgen REQUIRED)

add_library(slackwater_lib_fastdds INTERFACE)
target_link_libraries(slackwater_lib_fastdds INTERFACE fastrtps)

# Those that others include first.
set(idl_names builtin_interfaces std_msgs geometry_msgs nav_msgs sensor_msgs marine_acoustic_msgs
    vision_msgs rosgraph_msgs std_srvs rcl_interfaces rmw_dds_common action_msgs slackwater_msgs)
set(idl_folder ${CMAKE_CURRENT_LIST_DIR}/idl)
set(made_folder ${PROJECT_BINARY_DIR}/generated/dds_types)
set(idl_files "")
set(made_types "")
set(made_support "")
set(embedded "")
foreach(name ${idl_names})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${idl_folder}/${name}.idl)
  list(APPEND idl_files ${idl_folder}/${name}.idl)
  list(APPEND made_types ${made_folder}/${name}.cxx)
  list(APPEND made_support ${made_folder}/${name}PubSubTypes.cxx)
  list(APPEND made_headers ${made_folder}/${name}.h ${made_folder}/${name}PubSubTypes.h)
  file(READ ${idl_folder}/${name}.idl idl)
  string(APPEND embedded "    R\"idl(${idl})idl\",\n")
endforeach()
set_property(GLOBAL PROPERTY SLACKWATER_IDL_FILES ${idl_files})  # for peers in tests
add_custom_command(
  OUTPUT ${made_types} ${made_support} ${made_headers}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${made_folder}
  COMMAND ${FASTDDSGEN} -typeros2 -cs -replace -d ${made_folder} -I ${idl_folder} ${idl_files}
          > ${made_folder}/fastddsgen.log
  DEPENDS ${idl_files}
  COMMENT "Making DDS types"
  VERBATIM)

# For clang-tidy, which reads without building.
add_custom_target(slackwater_dds_headers DEPENDS ${made_headers})

add_library(slackwater_dds_types STATIC ${made_types} ${made_headers})
target_include_directories(slackwater_dds_types SYSTEM PUBLIC ${made_folder})
target_link_libraries(slackwater_dds_types PUBLIC fastcdr fastrtps)
add_library(slackwater_dds_type_support STATIC EXCLUDE_FROM_ALL ${made_support})
target_link_libraries(slackwater_dds_type_support PUBLIC slackwater_dds_types)
foreach(library slackwater_dds_types slackwater_dds_type_support)
  set_target_properties(${library} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${library} PRIVATE -w)
endforeach()

set(embedded_idl ${CMAKE_CURRENT_BINARY_DIR}/idl_text.cc)
file(CONFIGURE OUTPUT ${embedded_idl} @ONLY CONTENT [[
// Made from api/door/dds/idl/*.idl at configure time.
#include "api/door/dds/message/idl_text.h"

namespace slackwater::dds {
namespace {
constexpr std::string_view texts[] = {
@embedded@};
}  // namespace
std::span<const std::string_view> idl_texts() noexcept { return texts; }
}  // namespace slackwater::dds
]])
