#include "api/pipeline/ingest/read_history_apart.h"

#include <cstring>
#include <new>
#include <nlohmann/json.hpp>

#include "api/pipeline/ingest/ingest_apart.h"

// What the child says is CBOR: small things as values, times and values of series as their bytes.

namespace slackwater::api {
namespace {

using nlohmann::json;

template <typename T>
json bytes_of(const std::vector<T>& values) {
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return json::binary(std::move(bytes));
}

template <typename T>
std::vector<T> values_of(const json& bytes) {
  const std::vector<std::uint8_t>& from = bytes.get_binary();
  std::vector<T> values(from.size() / sizeof(T));
  if (!from.empty()) std::memcpy(values.data(), from.data(), values.size() * sizeof(T));
  return values;
}

json to_json(const HistorySeries& series) {
  std::vector<std::int64_t> ms;
  ms.reserve(series.time.size());
  for (const UtcTime time : series.time) ms.push_back(time.time_since_epoch().count());
  return {{"name", series.name},
          {"standard_name", series.standard_name},
          {"unit", series.unit},
          {"source", series.source},
          {"is_single_precision", series.is_single_precision},
          {"time", bytes_of(ms)},
          {"value", bytes_of(series.value)}};
}

HistorySeries series_of(const json& answer) {
  HistorySeries series;
  series.name = answer.at("name").get<std::string>();
  series.standard_name = answer.at("standard_name").get<std::string>();
  series.unit = answer.at("unit").get<std::string>();
  series.source = answer.at("source").get<std::string>();
  series.is_single_precision = answer.at("is_single_precision").get<bool>();
  for (const std::int64_t ms : values_of<std::int64_t>(answer.at("time")))
    series.time.emplace_back(Duration(ms));
  series.value = values_of<double>(answer.at("value"));
  return series;
}

json to_json(const ingest::HistoryOfFile& history) {
  json answer = {{"columns", history.columns},
                 {"offered", history.offered},
                 {"warnings", history.warnings},
                 {"series", json::array()}};
  for (const auto& series : history.series)
    answer["series"].push_back(series ? to_json(*series) : json(nullptr));
  return answer;
}

}  // namespace

ingest::HistoryOfFile read_history_apart(const std::filesystem::path& file,
                                         const std::vector<std::string>& wanted,
                                         const ingest::HistoryOptions& options,
                                         const ingest::Vocabulary& vocabulary) {
  const Allowance allowance = allowance_for(file);
  const auto read = [&](const TellShare&) {
    json answer;
    try {
      answer = to_json(ingest::read_history(file, wanted, options, vocabulary));
    } catch (const Error& error) {
      answer = problem_json(error.kind(), error.message());
    } catch (const std::bad_alloc&) {
      answer = problem_json(ErrorKind::invalid_input,
                            "reading " + file.string() + " wants too much memory: cut it");
    } catch (const std::exception& fault) {
      answer = problem_json(ErrorKind::internal, "reading " + file.string() + ": " + fault.what());
    }
    const std::vector<std::uint8_t> bytes = json::to_cbor(answer);
    return std::string(bytes.begin(), bytes.end());
  };
  const Apart apart = run_apart(allowance, read, {});
  if (apart.end != Apart::End::answered) throw error_of(apart, file, allowance);
  const json answer = json::from_cbor(apart.answer, true, true, json::cbor_tag_handler_t::error);
  if (answer.contains("problem"))
    throw Error(static_cast<ErrorKind>(answer.at("kind").get<int>()),
                answer.at("problem").get<std::string>());
  ingest::HistoryOfFile history;
  history.columns = answer.at("columns").get<std::vector<std::string>>();
  history.offered = answer.at("offered").get<std::vector<std::string>>();
  history.warnings = answer.at("warnings").get<std::vector<std::string>>();
  for (const json& series : answer.at("series")) {
    if (series.is_null())
      history.series.emplace_back();
    else
      history.series.push_back(series_of(series));
  }
  return history;
}

}  // namespace slackwater::api
