#include "ingest/ais/read_ais.h"

#include <algorithm>
#include <utility>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/ais/lines.h"
#include "ingest/ais/table.h"
#include "ingest/text/foreign_file.h"

namespace slackwater::ingest {
namespace {

/// The longest message of our types, type 5 (424 bits), has 71 characters; some transmitters pad.
constexpr std::size_t most_payload_characters = 80;

using OnReport = std::function<void(const AisReport&)>;

void count(AisReading& reading, const AisReport& report) {
  ++reading.reports_of_type[static_cast<std::size_t>(report.type)];
  reading.untimed += report.time ? 0U : 1U;
}

AisReading read_table(Lines& lines, std::string_view header, const OnReport& on_report) {
  AisReading reading;
  const AisTable table(header);
  reading.lines.lines = 1;
  while (const auto line = lines.next()) {
    ++reading.lines.lines;
    if (line->text.empty()) continue;
    const auto report = line->is_too_long ? std::nullopt : table.report_of(line->text);
    if (!report) {
      if (reading.lines.malformed++ == 0) {
        reading.lines.first_malformed =
            "line " + std::to_string(line->number) + ": not a row of the table";
      }
      continue;
    }
    ++reading.messages;
    if (report->type == 0) {
      ++reading.other_types;
      ++reading.others_of_type[0];
      continue;
    }
    count(reading, *report);
    on_report(*report);
  }
  return reading;
}

AisReading read_sentences(Lines& lines, const TextLine& first, const OnReport& on_report,
                          const FilterProgram& decoder, bool assume_utc) {
  AisReading reading;
  MessageAssembler assembler(assume_utc);
  std::optional<AisMessage> waiting = assembler.take(first.text, first.is_too_long);
  const auto next_message = [&]() -> std::optional<AisMessage> {
    if (waiting) return std::exchange(waiting, std::nullopt);
    while (const auto line = lines.next()) {
      if (auto message = assembler.take(line->text, line->is_too_long)) return message;
    }
    return std::nullopt;
  };
  const auto next_wanted = [&]() -> std::optional<AisMessage> {
    while (auto message = next_message()) {
      ++reading.messages;
      if (!is_ais_type_of_ours(message->type())) {
        ++reading.other_types;
        ++reading.others_of_type[static_cast<std::size_t>(message->type())];
      } else if (message->payload.size() > most_payload_characters) {
        ++reading.undecodable;
      } else {
        return message;
      }
    }
    return std::nullopt;
  };
  const auto on_decoded = [&](const AisMessage& message, std::string_view json) {
    std::optional<AisReport> report = report_from_json(json);
    if (!report) {
      ++reading.undecodable;
      return;
    }
    report->time = message.time;
    report->is_own_ship = message.is_own_ship;
    count(reading, *report);
    on_report(*report);
  };
  const std::size_t undecoded = decode_messages(decoder, next_wanted, on_decoded);
  reading.undecodable += undecoded;
  assembler.finish();
  reading.lines = assembler.counts();
  return reading;
}

/// @throws Error(invalid_input) for a table of others
bool is_known_table(const TextLine& first) {
  const bool is_table = !first.is_too_long && AisTable::is_header(first.text);
  if (is_table || !AisTable::looks_like_one(first.text)) return is_table;
  throw Error(ErrorKind::invalid_input,
              "found a table with the columns " +
                  joined(fields_of_csv(first.text.substr(0, 200)), ", ") +
                  "; expected those of MarineCadastre.gov (mmsi, base_date_time, latitude, "
                  "longitude) or of the Danish Maritime Authority (# Timestamp, Type of mobile, "
                  "MMSI, Latitude, Longitude): rename them");
}

}  // namespace

std::vector<std::string> AisReading::warnings() const {
  std::vector<std::string> result;
  const auto warn = [&](std::size_t number, const std::string& text) {
    if (number > 0) result.push_back(std::to_string(number) + text);
  };
  warn(lines.malformed, " lines are malformed (the first is " + lines.first_malformed + ")");
  warn(lines.lost_fragments, " sentences belong to messages that are not whole");
  warn(lines.mismatched_stamps, " time stamps belong to sentences that are not there");
  warn(undecodable, " messages could not be decoded or name no vessel");
  warn(lines.zoneless_times,
       " times of the log state no zone and are not taken; if they are UTC, write a Z behind them "
       "or "
       "say --assume-utc (slackwater ais)");
  warn(untimed,
       " reports have no time, so their positions are left out; expected a time in front of each "
       "line, $PGHP lines or tag blocks");
  return result;
}

std::string AisReading::passed_over() const {
  if (other_types == 0) return {};
  std::vector<std::string> types;
  for (std::size_t type = 0; type < others_of_type.size(); ++type) {
    if (others_of_type[type] == 0) continue;
    const std::string_view name = name_of_ais_type(static_cast<int>(type));
    types.push_back(type == 0 ? counted(others_of_type[0], "row") + " of no ship"
                              : formatted("type {}{} {}", type,
                                          name.empty() ? "" : " (" + std::string(name) + ")",
                                          others_of_type[type]));
  }
  return counted(other_types, "message") + " of types that tell of no vessel's way " +
         (other_types == 1 ? "is" : "are") + " passed over: " + joined(types, ", ");
}

AisReading read_ais(const std::filesystem::path& file, const OnReport& on_report,
                    const FilterProgram& decoder, bool assume_utc) {
  return with_context("reading AIS of " + file.string(), [&] {
    Lines lines(file);
    const auto first = lines.next();
    if (!first) throw Error(ErrorKind::invalid_input, "found an empty file; expected AIS");
    const bool is_table = is_known_table(*first);
    AisReading reading = is_table ? read_table(lines, std::string(first->text), on_report)
                                  : read_sentences(lines, *first, on_report, decoder, assume_utc);
    if (reading.messages == 0) {
      const auto foreign = foreign_file(file);
      if (foreign && foreign->what == "JSON" && reading.lines.sentences == 0)
        refuse(
            "found JSON without NMEA sentences, expected these: record what the receiver hears and "
            "not what was decoded (gpspipe -r, or the `nmea` of AIS-catcher)");
      if (foreign && foreign->what != "JSON") refuse(foreign->refusal("a log or a table of AIS"));
      throw Error(
          ErrorKind::invalid_input,
          "found no AIS message in " + std::to_string(reading.lines.lines) + " lines" +
              (reading.lines.malformed > 0 ? " (" + reading.lines.first_malformed + ")" : "") +
              "; expected NMEA 0183 sentences (!AIVDM,...) with a time in front of each, $PGHP "
              "lines "
              "or tag blocks, or a table of MarineCadastre.gov or of the Danish Maritime "
              "Authority");
    }
    return reading;
  });
}

AisReading read_ais_part(const std::filesystem::path& file, const AisPart& part,
                         const OnReport& on_report, const FilterProgram& decoder, bool assume_utc) {
  return with_context("reading AIS of " + file.string(), [&] {
    Lines lines(file);
    if (lines.is_packed())
      refuse("found a packed file, expected a log as a receiver writes it; unpack it");
    auto line = lines.next();
    if (!line) return AisReading{};
    const bool is_table = is_known_table(*line);
    const std::string header = is_table ? std::string(line->text) : std::string();
    lines.go_to(is_table ? std::max<std::uint64_t>(part.from, 1) : part.from, part.to);
    if (is_table) return read_table(lines, header, on_report);
    line = lines.next();
    return line ? read_sentences(lines, *line, on_report, decoder, assume_utc) : AisReading{};
  });
}

AisTracks read_ais_tracks(const std::filesystem::path& file, const AisTrackOptions& options,
                          const FilterProgram& decoder) {
  AisTrackCollector collector;
  const auto is_outside = [&](const AisReport& report) {
    if (options.cut && !(report.position && options.cut->contains(*report.position))) return true;
    if (options.from && !(report.time && *report.time >= *options.from)) return true;
    return options.to && !(report.time && *report.time <= *options.to);
  };
  AisTracks result;
  result.reading = read_ais(
      file,
      [&](const AisReport& heard) {
        if (options.mmsi && heard.mmsi != *options.mmsi) return;
        AisReport report = heard;
        if (is_outside(report)) report.position.reset();  // what it says of itself still counts
        collector.add(report);
        if (collector.positions() + 5 * collector.vessels() > options.most_positions) {
          throw Error(ErrorKind::invalid_input, "found more than " +
                                                    std::to_string(options.most_positions) +
                                                    " positions; give a box, a time or a vessel");
        }
      },
      decoder, options.assume_utc);
  result.tracks = std::move(collector).take();
  if (options.cut || options.from || options.to) {
    std::erase_if(result.tracks, [](const AisTrack& track) { return track.positions.empty(); });
  }
  return result;
}

}  // namespace slackwater::ingest
