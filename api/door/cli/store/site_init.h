#pragma once

namespace CLI {
class App;
}

namespace slackwater::api {

struct Context;

/// `site init`: writes the file of a new site into the store's `sites/` folder.
void add_site_init(CLI::App& site, Context& context);

}  // namespace slackwater::api
