#include <algorithm>
#include <functional>

#include "fields/base/advice.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/inspection/defect/detection_method.h"

namespace slackwater::twin {
namespace {

constexpr int surface_kinds = static_cast<int>(SurfaceKind::water) + 1;
constexpr int instrument_kinds = static_cast<int>(InstrumentKind::ais) + 1;

/// The words of a list as the kinds they name.
template <typename Kind>
std::vector<Kind> read_kinds(const Config& c, std::string_view key, int count) {
  std::vector<std::string> known;
  known.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) known.emplace_back(name_of(static_cast<Kind>(i)));
  std::vector<Kind> kinds;
  for (const std::string& word : c.texts(key)) {
    const auto at = std::find(known.begin(), known.end(), word);
    if (at == known.end())
      c.refuse(key, "found " + word + did_you_mean(word, known) + ", expected of " +
                        joined(known, ", "));
    kinds.push_back(static_cast<Kind>(at - known.begin()));
  }
  return kinds;
}

std::string read_said(const Config& c, std::string_view key) {
  std::string said = c.text(key);
  if (said.find_first_not_of(" \t\n") == std::string::npos)
    c.refuse(key, "is empty; say where the figures are from, or that they are an estimate");
  return said;
}

PodOf read_of(const Config& c) {
  const std::string of = c.optional_text("of").value_or("size");
  if (of == "size") return PodOf::size;
  if (of == "severity") return PodOf::severity;
  c.refuse("of", "found " + of + ", expected size or severity");
}

/// Whether its curve is over shares, not lengths.
bool is_of_share(const Config& c, const DetectionMethod& method) {
  if (method.of == PodOf::size) return false;
  const auto is_share = [](DefectKind kind) {
    return severity_unit_of(kind) == SeverityUnit::share;
  };
  const auto shares = std::count_if(method.finds.begin(), method.finds.end(), is_share);
  if (shares != 0 && static_cast<std::size_t>(shares) != method.finds.size())
    c.refuse("finds", "the severities of these kinds have different units; make two files of it");
  return shares != 0;
}

LogLogisticPod read_log_logistic(const Config& c, bool is_share) {
  const char* key = is_share ? "x0_share" : "x0_mm";
  LogLogisticPod curve;
  curve.x0 = c.number(key, {-1e6, 1e6}) * (is_share ? 1 : 1e-3);
  if (!(curve.x0 > 0))
    c.refuse(key, formatted("found {:g}, expected more than 0: the size of which half are found",
                            curve.x0 * (is_share ? 1 : 1e3)));
  curve.b = c.number("b", {-100, 100});
  if (!(curve.b > 0))
    c.refuse("b", formatted("found {:g}, expected more than 0: larger defects are found more often",
                            curve.b));
  return curve;
}

PodTable read_table(const Config& c, bool is_share) {
  const char* key = is_share ? "share" : "size_mm";
  PodTable table;
  table.size = c.numbers(key, {0, is_share ? 1 : 1e6});
  table.pod = c.numbers("pod", {0, 1});
  if (table.size.empty()) c.refuse(key, "has no sizes; give at least one");
  if (table.size.size() != table.pod.size())
    c.refuse("pod", formatted("found {} probabilities for {} sizes; give one for each",
                              table.pod.size(), table.size.size()));
  if (std::adjacent_find(table.size.begin(), table.size.end(), std::greater_equal<>()) !=
      table.size.end())
    c.refuse(key, "give the sizes in rising order, each once");
  if (!std::is_sorted(table.pod.begin(), table.pod.end()))
    c.refuse("pod",
             "falls with the size; expected larger defects to be found as often or more often");
  if (!is_share)
    for (double& size : table.size) size *= 1e-3;
  return table;
}

NormalErrorPod read_normal_error(const Config& c, bool is_share) {
  const char* key = is_share ? "sd_share" : "sd_mm";
  const double unit = is_share ? 1 : 1e-3;
  NormalErrorPod curve;
  curve.called_from =
      unit * c.number(is_share ? "called_from_share" : "called_from_mm", {0, is_share ? 1 : 1e6});
  curve.sd = unit * c.number(key, {0, is_share ? 1 : 1e6});
  if (!(curve.sd > 0))
    c.refuse(key, formatted("found {:g}, expected more than 0: every measurement has an error",
                            curve.sd / unit));
  return curve;
}

PodCurve read_curve(const Config& c, bool is_share) {
  if (c.has("log_logistic") + c.has("table") + c.has("normal_error") != 1)
    c.refuse("log_logistic", "give one of log_logistic, table and normal_error");
  if (c.has("table")) return read_table(c.child("table"), is_share);
  if (c.has("normal_error")) return read_normal_error(c.child("normal_error"), is_share);
  return read_log_logistic(c.child("log_logistic"), is_share);
}

void read_size_error(const Config& c, DetectionMethod& method) {
  const auto error = c.optional_child("size_error");
  if (!error) return;
  method.size_sd = error->optional_number("relative_sd", {0, 2}).value_or(0);
  method.size_bias = error->optional_number("relative_bias", {-1, 2}).value_or(0);
}

}  // namespace

DetectionMethod read_detection_method(const Config& config) {
  DetectionMethod method;
  method.name = config.text("name");
  method.source = read_said(config, "source");
  method.status = read_said(config, "status");
  method.finds = read_kinds<DefectKind>(config, "finds", static_cast<int>(defect_kinds));
  method.by = read_kinds<InstrumentKind>(config, "by", instrument_kinds);
  method.on = read_kinds<SurfaceKind>(config, "on", surface_kinds);
  if (method.finds.empty()) config.refuse("finds", "says nothing; name the kinds of defect");
  if (method.by.empty()) config.refuse("by", "says nothing; name the kinds of instrument");
  method.of = read_of(config);
  method.curve = read_curve(config, is_of_share(config, method));
  method.at_detail_m = 1e-3 * config.number("at_detail_mm", {1e-3, 1e5});
  method.false_alarms_per_100_m2 = config.number("false_alarms_per_100_m2", {0, 1000});
  read_size_error(config, method);
  config.expect_all_read();
  return method;
}

std::vector<DetectionMethod> read_detection_methods(const std::vector<std::string>& names,
                                                    const std::filesystem::path& data_folder) {
  const std::filesystem::path folder = data_folder / "detection";
  std::vector<std::string> known;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (entry.path().extension() == ".yaml") known.push_back(entry.path().stem().string());
  std::sort(known.begin(), known.end());
  std::vector<DetectionMethod> methods;
  for (const std::string& name : names) {
    if (!std::binary_search(known.begin(), known.end(), name))
      throw Error(ErrorKind::invalid_input, "inspection: detection: found " + name +
                                                did_you_mean(name, known) +
                                                ", expected of those in " + folder.string() + ": " +
                                                (known.empty() ? "(none)" : joined(known, ", ")));
    methods.push_back(read_detection_method(Config::load(folder / (name + ".yaml"))));
  }
  expect_one_method_each(methods);
  return methods;
}

}  // namespace slackwater::twin
