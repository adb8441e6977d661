#pragma once

namespace CLI {
class App;
}

namespace slackwater::api {

struct Context;

/// `site sources`: whose values a forecast of a site would be made from, before it is made.
void add_site_sources(CLI::App& site, Context& context);

}  // namespace slackwater::api
