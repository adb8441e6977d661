#include "ingest/ais/read_ais.h"

#include <algorithm>
#include <utility>

#include "fields/base/error.h"
#include "ingest/ais/lines.h"
#include "ingest/ais/marine_cadastre.h"

namespace slackwater::ingest {
namespace {

/// The longest message of our types, type 5 (424 bits), has 71 characters; some transmitters pad.
constexpr std::size_t most_payload_characters = 80;

bool is_wanted(int type) noexcept {
  return (type >= 1 && type <= 5) || type == 18 || type == 19 || type == 24;
}

using OnReport = std::function<void(const AisReport&)>;

void count(AisReading& reading, const AisReport& report) {
  ++reading.reports_of_type[static_cast<std::size_t>(report.type)];
  reading.untimed += report.time ? 0U : 1U;
}

AisReading read_table(Lines& lines, std::string_view header, const OnReport& on_report) {
  AisReading reading;
  const MarineCadastreReader reader(header);
  reading.lines.lines = 1;
  while (const auto line = lines.next()) {
    ++reading.lines.lines;
    if (line->text.empty()) continue;
    const auto report = line->is_too_long ? std::nullopt : reader.report_of(line->text);
    if (!report) {
      if (reading.lines.malformed++ == 0) {
        reading.lines.first_malformed =
            "line " + std::to_string(line->number) + ": not a row of the table";
      }
      continue;
    }
    ++reading.messages;
    count(reading, *report);
    on_report(*report);
  }
  return reading;
}

AisReading read_sentences(Lines& lines, const TextLine& first, const OnReport& on_report,
                          const FilterProgram& decoder) {
  AisReading reading;
  MessageAssembler assembler;
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
      if (!is_wanted(message->type())) {
        ++reading.other_types;
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
  warn(
      untimed,
      " reports have no time, so their positions are left out; expected $PGHP lines or tag blocks");
  return result;
}

AisReading read_ais(const std::filesystem::path& file, const OnReport& on_report,
                    const FilterProgram& decoder) {
  return with_context("reading AIS of " + file.string(), [&] {
    Lines lines(file);
    const auto first = lines.next();
    if (!first) throw Error(ErrorKind::invalid_input, "found an empty file; expected AIS");
    const bool is_table = !first->is_too_long && MarineCadastreReader::is_header(first->text);
    AisReading reading = is_table ? read_table(lines, std::string(first->text), on_report)
                                  : read_sentences(lines, *first, on_report, decoder);
    if (reading.messages == 0) {
      throw Error(
          ErrorKind::invalid_input,
          "found no AIS message in " + std::to_string(reading.lines.lines) + " lines" +
              (reading.lines.malformed > 0 ? " (" + reading.lines.first_malformed + ")" : "") +
              "; expected NMEA 0183 sentences (!AIVDM,...) with $PGHP lines or tag blocks, or a "
              "table of "
              "MarineCadastre.gov");
    }
    return reading;
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
      decoder);
  result.tracks = std::move(collector).take();
  if (options.cut || options.from || options.to) {
    std::erase_if(result.tracks, [](const AisTrack& track) { return track.positions.empty(); });
  }
  return result;
}

}  // namespace slackwater::ingest
