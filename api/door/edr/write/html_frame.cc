#include "api/door/edr/write/html_frame.h"

#include "fields/base/html.h"

namespace slackwater::api::edr {
namespace {

/// Below 40 em the cells of a table stand below each other, each with the name of its column.
constexpr const char* style =
    ":root{color-scheme:light dark}"
    "body{font:1em/1.5 system-ui,sans-serif;max-width:60em;margin:1em auto;padding:0 1em;"
    "overflow-wrap:anywhere}"
    "h1{font-size:1.5em}h2{font-size:1.2em;margin:1.5em 0 .3em}h3{font-size:1em;margin:1em 0 0}"
    "p,ul{margin:.3em 0}ul{padding-left:1.2em}li{margin:.25em 0}"
    "nav a,.links a{margin-right:1em}"
    "dl{margin:.3em 0}dt{font-weight:bold}dd{margin:0 0 .4em 1em}"
    "code{font-size:.9em}"
    "section{border:1px solid #8888;border-radius:.4em;padding:.2em 1em .8em;margin:1em 0}"
    ".word{border:1px solid;border-radius:.3em;padding:0 .4em;font-weight:bold}"
    ".stale,.unreadable{color:#b3261e}.degraded{color:#9a5b00}.ok{color:#1b6e3c}"
    "@media(prefers-color-scheme:dark){.stale,.unreadable{color:#ff8a80}.degraded{color:#ffb74d}"
    ".ok{color:#81c995}}"
    "table{border-collapse:collapse;width:100%}"
    "td,th{border-bottom:1px solid #8888;padding:.3em .6em .3em 0;text-align:left;"
    "vertical-align:top}"
    "@media(max-width:40em){tr:first-child:has(th){display:none}"
    "td{display:block;border:0;padding:0}tr{display:block;border-bottom:1px solid #8888;"
    "padding:.4em 0}td:empty{display:none}"
    "td[data-of]::before{content:attr(data-of) \": \";font-weight:bold}}";

}  // namespace

std::string html_frame(const std::string& title, const std::string& base, const std::string& body) {
  const std::string at = escaped_html(base);
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"><title>" +
         escaped_html(title) + "</title><style>" + style +
         "</style></head><body>\n<nav><a href=\"" + at + "/?f=html\">Sites</a><a href=\"" + at +
         "/collections?f=html\">Collections</a><a href=\"" + at +
         "/api?f=html\">Interface</a></nav>\n<h1>" + escaped_html(title) + "</h1>\n" + body +
         "</body></html>\n";
}

}  // namespace slackwater::api::edr
