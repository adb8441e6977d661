# slackwater_doors(<room>)
#
# The linker as the doorman: a program of the whole room and of nothing but what the room says that
# it sees. A symbol of any other room is undefined there and ends the build. Static libraries alone
# do not tell: the last program that is linked has all of them.
#
# GNU ld and mold alike. The program is never run, and emptied as soon as it was linked: fifty of
# them would fill a disk.
file(WRITE ${PROJECT_BINARY_DIR}/emptied "")
file(WRITE ${PROJECT_BINARY_DIR}/doors.cc "int main() { return 0; }\n")
function(slackwater_doors room)
  add_executable(slackwater_${room}_doors ${PROJECT_BINARY_DIR}/doors.cc)
  target_link_libraries(slackwater_${room}_doors PRIVATE slackwater_options
                        $<LINK_LIBRARY:WHOLE_ARCHIVE,slackwater_${room}>)
  add_custom_command(TARGET slackwater_${room}_doors POST_BUILD
                     COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_BINARY_DIR}/emptied
                             $<TARGET_FILE:slackwater_${room}_doors>)
endfunction()
