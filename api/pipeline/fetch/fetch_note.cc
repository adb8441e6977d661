#include "api/pipeline/fetch/fetch_note.h"

#include <nlohmann/json.hpp>

#include "api/pipeline/fetch/gfs_run.h"
#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

std::filesystem::path note_file(const std::filesystem::path& file) {
  return file.string() + ".fetched.json";
}

}  // namespace

std::string asked_text(const WantedFile& wanted) {
  const auto time = [](const std::optional<UtcTime>& at) { return at ? format_utc(*at) : ""; };
  return formatted("{}|{}|{}|{:.3f} {:.3f} {:.3f} {:.3f}|{}|{}|{}|{}", wanted.dataset_id,
                   wanted.part.value_or(""), joined(wanted.variables, ","), wanted.box.west_deg,
                   wanted.box.east_deg, wanted.box.south_deg, wanted.box.north_deg,
                   wanted.deepest_m.value_or(0), time(wanted.from), time(wanted.to),
                   time(wanted.run));
}

std::optional<FetchNote> note_of(const std::filesystem::path& file) {
  std::error_code problem;
  const std::uintmax_t bytes = std::filesystem::file_size(file, problem);
  if (problem) return std::nullopt;
  try {
    constexpr std::size_t most_bytes = std::size_t{64} << 10U;
    const json read = json::parse(text_of_given_file(note_file(file), "a note", most_bytes));
    FetchNote note;
    note.asked = read.at("asked").get<std::string>();
    note.from = read.at("from").get<std::string>();
    note.fetched_at = parse_utc(read.at("fetched_at").get<std::string>());
    note.bytes = read.at("bytes").get<std::uintmax_t>();
    note.lacks = read.at("lacks").get<std::string>();
    if (note.bytes != bytes) return std::nullopt;
    return note;
  } catch (const json::exception&) {
    return std::nullopt;
  } catch (const Error&) {
    return std::nullopt;
  }
}

void write_note(const std::filesystem::path& file, const FetchNote& note) {
  const json written{{"asked", note.asked},
                     {"from", note.from},
                     {"fetched_at", format_utc(note.fetched_at)},
                     {"bytes", note.bytes},
                     {"lacks", note.lacks}};
  write_text(note_file(file), written.dump(2) + "\n");
}

std::optional<UtcTime> next_out(const WantedFile& wanted, const ingest::ProductCatalogue& products,
                                UtcTime now) {
  if (wanted.run) return *wanted.run + gfs_published_after + gfs_run_every;
  const ingest::Product* const product = products.find(wanted.product_id);
  if (product == nullptr || !wanted.from || product->published_after == Duration{0})
    return std::nullopt;
  const UtcTime today = UtcTime(day_of(now)) + product->published_after;
  return today > now ? today : today + std::chrono::days(1);
}

}  // namespace slackwater::api
