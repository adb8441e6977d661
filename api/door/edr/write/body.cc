#include "api/door/edr/write/body.h"

#include "api/door/edr/write/describe.h"
#include "api/door/edr/write/format_coverage_json.h"
#include "api/door/edr/write/format_csv.h"
#include "api/door/edr/write/format_geojson.h"
#include "api/door/edr/write/format_netcdf.h"
#include "fields/base/check.h"

namespace slackwater::api::edr {

const std::vector<Format>& answer_formats() {
  static const std::vector<Format> formats{Format::coverage_json, Format::geojson, Format::csv,
                                           Format::netcdf, Format::json};
  return formats;
}

Body write_answer(const Answer& answer, Format format) {
  const std::string type(media_type_of(format));
  switch (format) {
    case Format::coverage_json:
    case Format::json:  // the same document, for who accepts no other name for it
      return {type, coverage_json(answer), {}};
    case Format::geojson:
      return {type, geojson(answer), {}};
    case Format::csv:
      return {type + "; charset=utf-8; header=present", csv(answer), provenance_headers(answer)};
    case Format::netcdf:
      return {type,
              netcdf(answer),
              {{"Content-Disposition", "attachment; filename=\"slackwater.nc\""}}};
    case Format::html:
      break;
  }
  expects(false, "write_answer: one of answer_formats");
  return {};
}

}  // namespace slackwater::api::edr
