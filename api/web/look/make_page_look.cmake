# Script: the look of pages that are one file, from palette.css and parts.css.
#
#   cmake -DLOOK=api/web/look -DOUT=page-look.css -P api/web/look/make_page_look.cmake
#
# The rules of dusk and night are for screens, so that paper has the day; and those of dusk hold
# where the system is dark and nobody chose, so that a page needs no script for it.
file(READ ${LOOK}/palette.css palette)
file(READ ${LOOK}/parts.css parts)
set(tokens "[^{}]*")
set(dusk ":root\\[data-palette='dusk'\\] {(${tokens})}")
set(night ":root\\[data-palette='night'\\] {${tokens}}")
if(NOT palette MATCHES "^(.*)(${dusk}\n${night})\n$")
  message(FATAL_ERROR "found no dusk followed by night at the end of ${LOOK}/palette.css; expected "
                      ":root[data-palette='dusk'] {...} and :root[data-palette='night'] {...}")
endif()
file(WRITE ${OUT} "${CMAKE_MATCH_1}@media screen {\n${CMAKE_MATCH_2}\n}
@media screen and (prefers-color-scheme: dark) {\n:root:not([data-palette]) {${CMAKE_MATCH_3}}\n}
${parts}")
