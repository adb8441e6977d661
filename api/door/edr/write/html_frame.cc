#include "api/door/edr/write/html_frame.h"

#include "api/web/look/page_look.h"
#include "fields/base/encode/html.h"

namespace slackwater::api::edr {
namespace {

/// What the pages have of their own beside api/web/look. On a telephone the cells of a table stand
/// below each other, each with the name of its column.
constexpr const char* style = R"css(
body { max-width: 1000px; margin: 0 auto; padding: 16px 20px 40px; overflow-wrap: anywhere; }
h2 { margin: 24px 0 8px; }
nav { margin: 0 0 16px; padding: 0 0 8px; border-bottom: 1px solid var(--rule); }
:is(nav, .links) a { display: inline-block; min-height: 24px; margin-right: 16px; }
ul { margin: 4px 0; }
dl { margin: 4px 0; }
dt { color: var(--quiet); }
dd { margin: 0 0 6px; }
code { font-size: var(--text-small); }
section {
  margin: 12px 0;
  padding: 10px 14px;
  background: var(--panel);
  border: 1px solid var(--rule);
  border-radius: 4px;
}
section :is(h2, h3) { margin: 0 0 4px; font-size: var(--text); }
th, td { vertical-align: top; white-space: normal; }
tr { break-inside: avoid; }
@media (max-width: 700px) {
  body { padding: 12px 12px 30px; }
  thead { display: none; }
  tr { display: block; padding: 6px 0; border-bottom: 1px solid var(--rule); }
  td { display: block; padding: 0; border: 0; }
  td:empty { display: none; }
  td[data-of]::before { content: attr(data-of) ": "; color: var(--quiet); }
}
@media print {
  @page { size: A4; margin: 14mm 12mm; }
  :root { --text-small: 10px; --text: 12px; --text-large: 15px; --text-title: 20px; }
  body { max-width: none; padding: 0; }
  nav, .links { display: none; }
  section, tr { break-inside: avoid; }
}
)css";

}  // namespace

std::string html_frame(const std::string& title, const std::string& base, const std::string& body) {
  const std::string at = escaped_html(base);
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"><title>" +
      escaped_html(title) + "</title><style>";
  out += web::page_look();
  out += style;
  return out + "</style></head><body>\n<nav aria-label=\"Pages\"><a href=\"" + at +
         "/\">The desk</a><a href=\"" + at + "/?f=html\">Sites</a><a href=\"" + at +
         "/collections?f=html\">Collections</a><a href=\"" + at +
         "/api?f=html\">Interface</a></nav>\n<main><h1>" + escaped_html(title) + "</h1>\n" + body +
         "</main></body></html>\n";
}

}  // namespace slackwater::api::edr
