#include "api/door/edr/service.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/crs.h"
#include "api/door/edr/read/feature_filter.h"
#include "api/door/edr/sample/location.h"
#include "api/door/edr/sample/product_queries.h"
#include "api/door/edr/sample/queries.h"
#include "api/door/edr/sample/site_choice.h"
#include "api/door/edr/write/body.h"
#include "api/door/edr/write/describe.h"
#include "api/door/edr/write/features.h"
#include "api/door/edr/write/html_page.h"
#include "api/door/edr/write/metadata.h"
#include "api/door/edr/write/openapi.h"
#include "api/door/http/trust.h"
#include "fields/base/encode/percent.h"
#include "fields/base/error.h"

namespace slackwater::api::edr {
namespace {

using http::LongWork;
using http::Outcome;
using http::PathParameters;
using http::Request;
using http::Response;

/// A forecast in force may be replaced within seconds; what was issued never changes.
constexpr int in_force_max_age_s = 30;
constexpr int issued_max_age_s = 86400;
constexpr int metadata_max_age_s = 10;
/// Of a query that is planned while others wait.
constexpr std::size_t short_query_bytes = 2048;

constexpr std::array document_formats{Format::json, Format::html};
constexpr std::array feature_formats{Format::geojson, Format::json, Format::html};
constexpr const char* openapi_type = "application/vnd.oai.openapi+json;version=3.0";

/// What is negotiated by Accept must say so to caches.
const std::pair<std::string, std::string> varies{"Vary", "Accept"};

/// Headlines and names come from stored files: bytes that are not UTF-8 must
/// not take a document away.
std::string text_of(const nlohmann::json& document) {
  return document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// The format that f or, where it is absent, Accept asks for.
Format format_of(const Request& request, const QueryString& query,
                 std::span<const Format> offered) {
  const auto f = query.find("f");
  if (f && f->empty()) throw bad_parameter("f", *f, "a format, or no f at all");
  return choose_format(f.value_or(""), request.accept, offered);
}

/// It asks for a page, and for none of the formats by name.
bool is_browser(const Request& request) {
  const QueryString query = QueryString::parse(request.query);
  return query.all().empty() && format_of(request, query, document_formats) == Format::html;
}

/// Its style is inside; it runs nothing and asks for nothing.
Response page_response(std::string html) {
  return {200,
          "text/html; charset=utf-8",
          std::move(html),
          {varies,
           {"Content-Security-Policy",
            "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; "
            "frame-ancestors 'none'"}},
          metadata_max_age_s};
}

/// Only a host of its own is repeated in links: what a client writes there is no address of ours.
bool is_own_host(const std::string& host) {
  return http::is_loopback_host(host) || http::is_numeric_host(host);
}

/// Between two parts of long work: for who has left, no more is done.
void expect_awaited(const Request& request) {
  if (request.stop.stop_requested())
    throw Error(ErrorKind::unavailable, "nobody waits for this answer any more");
}

class Service {
 public:
  Service(std::shared_ptr<IssuedFields> forecasts, std::string base_url, nlohmann::json others)
      : forecasts_(std::move(forecasts)),
        base_url_(std::move(base_url)),
        others_(std::move(others)) {}

  [[nodiscard]] std::string base(const Request& request) const {
    if (!base_url_.empty()) return base_url_;
    return is_own_host(request.host) ? "http://" + request.host : std::string();
  }

  /// What the service says of itself, as JSON, GeoJSON or a page.
  /// @param others  query parameters that it takes beside f
  template <typename Make>
  Response document(const Request& request, std::span<const Format> formats,
                    std::span<const std::string_view> others, Make make) const {
    const QueryString query = QueryString::parse(request.query);
    std::vector<std::string_view> known{"f"};
    known.insert(known.end(), others.begin(), others.end());
    expect_known(query, known);
    const Format format = format_of(request, query, formats);
    const nlohmann::json made = make(base(request), *forecasts_->catalogue(), query);
    if (format == Format::html)
      return page_response(html_page("Slackwater " + request.path, base(request), made));
    return {200, std::string(media_type_of(format)), text_of(made), {varies}, metadata_max_age_s};
  }

  /// The OpenAPI document: under its own media type, as plain JSON for who
  /// asks for that, or as a page.
  [[nodiscard]] Response openapi(const Request& request) const {
    const QueryString query = QueryString::parse(request.query);
    constexpr std::array<std::string_view, 1> known{"f"};
    expect_known(query, known);
    const Format format = format_of(request, query, document_formats);
    nlohmann::json made = openapi_document(base(request), *forecasts_->catalogue());
    made.merge_patch(others_);
    if (format == Format::html) return page_response(html_of_interface(base(request), made));
    const bool is_plain = query.find("f") || request.accept.starts_with("application/json");
    return {200,
            is_plain ? "application/json" : openapi_type,
            text_of(made),
            {varies},
            metadata_max_age_s};
  }

  /// A data query that was read, and the format of its answer.
  struct Planned {
    QueryPoints plan;
    Format format;
  };

  Planned data(const Request& request, const QueryType& type, const PathParameters& path,
               bool of_instance) const {
    const QueryString query = QueryString::parse(request.query);
    const Collection& collection = collection_named(path.at("collectionId"));
    expect_known(query, type.parameters);
    const Format format = expect_format(request, query);
    for (std::size_t i = 0; i < type.needed; ++i) {
      const std::string_view name = type.parameters[i];
      // A collection without a vertical has no z; clients of EDR 1.0 know no height of a
      // corridor, see query_path.cc.
      const bool may_miss = name == "z" || name == "corridor-height" || name == "height-units";
      if (!may_miss && !query.find(name))
        throw bad_parameter(name, "nothing", "this parameter; see /api");
    }
    const std::shared_ptr<const ForecastCatalogue> catalogue = forecasts_->catalogue();
    Selection selection =
        of_instance ? of_named_instance(collection, *catalogue, path, query)
                    : in_force(collection, *catalogue, site_for(*catalogue, type, query), query);
    return {type.plan(std::move(selection), query), format};
  }

  /// The answer of a stored product, where the path names one; else nothing. All of it is long
  /// work: it reads files. The product is looked up again when its turn comes.
  std::optional<Outcome> product_answered(const Request& request, const QueryType* type,
                                          const PathParameters& path, bool of_instance) const {
    const std::string& id = path.at("collectionId");
    if (forecasts_->catalogue()->product(id) == nullptr) return std::nullopt;
    if (of_instance) throw no_instances(id);
    if (type != nullptr && !is_for_products(type->name)) {
      throw Error(ErrorKind::not_found, "found the query '" + std::string(type->name) +
                                            "' of a stored product, which is asked by position, "
                                            "radius, area, cube or locations");
    }
    const QueryString query = QueryString::parse(request.query);
    expect_known(query, type != nullptr ? type->parameters : location_parameters());
    const Format format = expect_format(request, query);
    return LongWork{[=, this]() -> Response {
      const std::shared_ptr<const ForecastCatalogue> catalogue = forecasts_->catalogue();
      const StoredProduct* product = catalogue->product(id);
      if (product == nullptr) {
        throw Error(ErrorKind::not_found,
                    "the product '" + id + "' was pruned from the store; see /collections");
      }
      const std::filesystem::path& store = forecasts_->folder();
      Answer answer =
          type != nullptr
              ? product_answer(store, *product, *type, query)
              : product_answer_at(store, *product, location_of(*catalogue, *product, path), query);
      expect_awaited(request);
      return told(request, std::move(answer), format, in_force_max_age_s);
    }};
  }

  /// What a stored product has none of.
  [[nodiscard]] static Error no_instances(const std::string& id) {
    return {ErrorKind::not_found,
            "found no issued forecasts in '" + id +
                "', which is stored and not issued: ask it by position, radius, area, cube or "
                "locations; runs of a product are told apart by forecast_period"};
  }

  Planned location(const Request& request, const PathParameters& path, bool of_instance) const {
    const QueryString query = QueryString::parse(request.query);
    const Collection& collection = collection_named(path.at("collectionId"));
    expect_known(query, location_parameters());
    const Format format = expect_format(request, query);
    const std::shared_ptr<const ForecastCatalogue> catalogue = forecasts_->catalogue();
    std::optional<Selection> selection;
    if (of_instance) selection = of_named_instance(collection, *catalogue, path, query);
    const std::optional<LocationName> name = location_named(
        path.at("locationId"), *catalogue, selection ? selection->field.get() : nullptr);
    if (!name) {
      throw Error(ErrorKind::not_found, "found no location '" + shown(path.at("locationId")) +
                                            "'; the collection's /locations lists what there is");
    }
    if (!selection) {
      const auto site = std::find_if(catalogue->sites.begin(), catalogue->sites.end(),
                                     [&](const auto& s) { return s.site_id == name->site_id; });
      selection = in_force(collection, *catalogue, {&*site, notes_on(*site)}, query);
    }
    return {location_plan(std::move(*selection), query, name->column), format};
  }

  /// The answer to a data query, or the work that leads to it where it takes long. That is planned
  /// anew when its turn comes: what waits keeps no forecast in memory.
  template <typename MakePlan>
  Outcome answered(const Request& request, const PathParameters& path, bool of_instance,
                   MakePlan make_plan) const {
    const auto answer = [this, of_instance](const Request& asked, const Planned& planned) {
      expect_awaited(asked);
      Answer found = planned.plan.answer();
      expect_awaited(asked);
      return told(asked, std::move(found), planned.format,
                  of_instance ? issued_max_age_s : in_force_max_age_s);
    };
    const auto all_of_it = [=]() -> Response { return answer(request, make_plan(request, path)); };
    // What is long to read (a polygon of a thousand corners) is long to plan.
    if (request.query.size() > short_query_bytes) return LongWork{all_of_it};
    const Planned planned = make_plan(request, path);
    if (!takes_long(planned.plan.work)) return answer(request, planned);
    return LongWork{all_of_it};
  }

  [[nodiscard]] std::shared_ptr<const Field> field(const std::string& instance) const {
    return forecasts_->field(instance);
  }
  [[nodiscard]] const IssuedForecast& instance(const ForecastCatalogue& catalogue,
                                               const std::string& name) const {
    if (const IssuedForecast* found = catalogue.find(name)) return *found;
    throw Error(ErrorKind::not_found,
                "found no instance '" + shown(name) + "'; /instances lists what there is");
  }

 private:
  /// Of a location by its name.
  static GeoPoint place_of(const ForecastCatalogue& catalogue, const PathParameters& path) {
    const std::string& text = path.at("locationId");
    if (const std::optional<LocationName> name = location_named(text, catalogue)) {
      for (const auto& site : catalogue.sites)
        if (site.site_id == name->site_id)
          return site.field->snapshot().columns.at(name->column).point;
    }
    throw Error(ErrorKind::not_found, "found no location '" + shown(text) +
                                          "'; the collection's /locations lists what there is");
  }

  /// Of a site's column, or of what measures itself.
  static GeoPoint location_of(const ForecastCatalogue& catalogue, const StoredProduct& product,
                              const PathParameters& path) {
    if (product.is_measured() && path.at("locationId") == own_location(product))
      return edr::place_of(product);
    return place_of(catalogue, path);
  }

  static Format expect_format(const Request& request, const QueryString& query) {
    if (const auto crs = query.find("crs")) expect_supported_crs(*crs);
    return format_of(request, query, answer_formats());
  }

  /// An answer as GeoJSON: itself, its other renditions, and the end point that gave it.
  static std::vector<Answer::Link> links_of(const std::string& endpoint, const std::string& query) {
    std::string asked = endpoint + "?";
    const QueryString parameters = QueryString::parse(query);
    for (const auto& [key, value] : parameters.all())
      if (key != "f") asked += percent_encoded(key) + "=" + percent_encoded(value) + "&";
    std::vector<Answer::Link> links;
    for (const Format format : answer_formats()) {
      links.push_back({format == Format::geojson ? "self" : "alternate",
                       std::string(media_type_of(format)),
                       asked + "f=" + std::string(name_of(format))});
    }
    links.push_back({"data", "application/prs.coverage+json", endpoint});
    return links;
  }

  Selection in_force(const Collection& collection, const ForecastCatalogue& catalogue,
                     SiteChoice choice, const QueryString& query) const {
    if (choice.site == nullptr) {
      throw Error(ErrorKind::not_found,
                  "found a place that no forecast reaches; " + reach_of(catalogue));
    }
    Selection selection =
        select(collection, instance(catalogue, choice.site->instance), choice.site->field, query);
    selection.answer.notes = std::move(choice.notes);
    return selection;
  }

  Selection of_named_instance(const Collection& collection, const ForecastCatalogue& catalogue,
                              const PathParameters& path, const QueryString& query) const {
    const std::string& name = path.at("instanceId");
    return select(collection, instance(catalogue, name), forecasts_->field(name), query);
  }

  Response told(const Request& request, Answer answer, Format format, int max_age_s) const {
    answer.query_url = base(request) + request.path;
    if (format == Format::geojson) answer.links = links_of(answer.query_url, request.query);
    Body body = write_answer(answer, format);
    body.headers.push_back(varies);
    return {200, std::move(body.media_type), std::move(body.bytes), std::move(body.headers),
            max_age_s};
  }

  std::shared_ptr<IssuedFields> forecasts_;
  std::string base_url_;
  nlohmann::json others_;  ///< of the interface, that are not ours
};

}  // namespace

std::vector<std::string> own_header_fields() { return provenance_fields(); }

void add_routes(http::Router& router, std::shared_ptr<IssuedFields> forecasts,
                const std::string& base_url, const Freshness& freshness) {
  add_routes(router, std::move(forecasts), base_url, freshness,
             Beside{nlohmann::json::object(), {}});
}

void add_routes(http::Router& router, std::shared_ptr<IssuedFields> forecasts,
                const std::string& base_url, const Freshness& freshness, const Beside& beside) {
  const auto service =
      std::make_shared<const Service>(std::move(forecasts), base_url, beside.interface);
  using Catalogue = ForecastCatalogue;
  const auto add = [&](const std::string& pattern, std::span<const Format> formats,
                       std::span<const std::string_view> others, auto make) {
    router.add("GET", pattern, [=](const Request& request, const PathParameters& path) {
      return service->document(
          request, formats, others,
          [&](const std::string& base, const Catalogue& catalogue, const QueryString& query) {
            return make(base, catalogue, path, query);
          });
    });
  };
  const auto document = [&](const std::string& pattern, auto make) {
    add(pattern, document_formats, {}, make);
  };
  const auto features = [&](const std::string& pattern, auto make) {
    add(pattern, feature_formats, FeatureFilter::parameters(), make);
  };
  const auto data_route = [&](auto make_plan, const QueryType* type, bool of_instance) {
    return [=](const Request& request, const PathParameters& path) -> Outcome {
      if (auto outcome = service->product_answered(request, type, path, of_instance))
        return *std::move(outcome);
      return service->answered(request, path, of_instance, make_plan);
    };
  };
  // Of what has issued forecasts.
  const auto collection_of = [](const Catalogue& catalogue,
                                const PathParameters& path) -> const Collection& {
    const std::string& id = path.at("collectionId");
    if (catalogue.product(id) != nullptr) throw Service::no_instances(id);
    return collection_named(id);
  };
  const std::string collection = "/collections/{collectionId}";
  const std::string instance = collection + "/instances/{instanceId}";

  router.add("GET", "/", [=, front_page = beside.front_page](const Request& request) -> Outcome {
    if (front_page && is_browser(request)) return front_page(request);
    return service->document(request, document_formats, {},
                             [&](const std::string& base, const Catalogue& catalogue, const auto&) {
                               return landing_page(base, catalogue, freshness);
                             });
  });
  document("/conformance", [](const std::string&, const Catalogue&, const auto&, const auto&) {
    return conformance();
  });
  router.add("GET", "/api",
             [=](const Request& request, const auto&) { return service->openapi(request); });
  document("/collections", [](const std::string& base, const Catalogue& catalogue, const auto&,
                              const auto&) { return collections_document(base, catalogue); });
  document(collection,
           [=](const std::string& base, const Catalogue& catalogue, const auto& path, const auto&) {
             if (const StoredProduct* product = catalogue.product(path.at("collectionId")))
               return product_document(base, *product, catalogue);
             return collection_document(base, collection_of(catalogue, path), catalogue);
           });
  document(collection + "/instances",
           [=](const std::string& base, const Catalogue& catalogue, const auto& path, const auto&) {
             return instances_document(base, collection_of(catalogue, path), catalogue);
           });
  document(instance,
           [=](const std::string& base, const Catalogue& catalogue, const auto& path, const auto&) {
             return instance_document(base, collection_of(catalogue, path), catalogue,
                                      service->instance(catalogue, path.at("instanceId")));
           });
  features(collection + "/items", [=](const std::string& base, const Catalogue& catalogue,
                                      const auto& path, const QueryString& query) {
    return items_document(base, collection_of(catalogue, path), catalogue, query);
  });
  add(collection + "/items/{itemId}", feature_formats, {},
      [=](const std::string& base, const Catalogue& catalogue, const auto& path, const auto&) {
        return item_document(base, collection_of(catalogue, path), catalogue,
                             service->instance(catalogue, path.at("itemId")));
      });
  features(collection + "/locations", [=](const std::string& base, const Catalogue& catalogue,
                                          const auto& path, const QueryString& query) {
    const std::string at = base + "/collections/" + path.at("collectionId");
    if (const StoredProduct* product = catalogue.product(path.at("collectionId")))
      return product_locations_document(at, *product, catalogue, query);
    std::vector<std::shared_ptr<const Field>> fields;
    for (const auto& site : catalogue.sites) fields.push_back(site.field);
    return locations_document(at, collection_of(catalogue, path), fields, query);
  });
  features(instance + "/locations", [=](const std::string& base, const Catalogue& catalogue,
                                        const auto& path, const QueryString& query) {
    const std::string& name = path.at("instanceId");
    static_cast<void>(service->instance(catalogue, name));
    return locations_document(
        base + "/collections/" + path.at("collectionId") + "/instances/" + name,
        collection_of(catalogue, path), {service->field(name)}, query);
  });
  for (const bool of_instance : {false, true}) {
    const std::string& at = of_instance ? instance : collection;
    for (const QueryType& type : query_types()) {
      router.add("GET", at + "/" + std::string(type.name),
                 data_route(
                     [=, type = &type](const Request& request, const PathParameters& path) {
                       return service->data(request, *type, path, of_instance);
                     },
                     &type, of_instance));
    }
    router.add("GET", at + "/locations/{locationId}",
               data_route(
                   [=](const Request& request, const PathParameters& path) {
                     return service->location(request, path, of_instance);
                   },
                   nullptr, of_instance));
  }
}

}  // namespace slackwater::api::edr
