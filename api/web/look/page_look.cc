#include "api/web/look/page_look.h"

// The file as it is, by the assembler; page_look.cmake makes it.
// clang-format off
__asm__(".pushsection .rodata\n"
        ".global slackwater_page_look_begin\nslackwater_page_look_begin:\n"
        ".incbin \"" SLACKWATER_PAGE_LOOK "\"\n"
        ".global slackwater_page_look_end\nslackwater_page_look_end:\n"
        ".byte 0\n"
        ".popsection\n");
// clang-format on
extern "C" const char slackwater_page_look_begin[];
extern "C" const char slackwater_page_look_end[];

namespace slackwater::web {

std::string_view page_look() { return {slackwater_page_look_begin, slackwater_page_look_end}; }

}  // namespace slackwater::web
