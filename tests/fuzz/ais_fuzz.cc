#include <cmath>

#include "ingest/ais/message.h"
#include "ingest/ais/report.h"
#include "ingest/ais/table.h"
#include "tests/fuzz/fuzz_case.h"

namespace {

using namespace slackwater;
using namespace slackwater::ingest;

void check_sentence(const AisSentence& sentence) {
  fuzz::claim(sentence.total >= 1 && sentence.total <= 9, "a number of fragments out of range");
  fuzz::claim(sentence.number >= 1 && sentence.number <= sentence.total, "a fragment out of range");
  fuzz::claim(sentence.fill_bits >= 0 && sentence.fill_bits <= 5, "fill bits out of range");
  fuzz::claim(!sentence.payload.empty(), "a sentence without a payload");
  for (const auto& time : {sentence.time, sentence.logged_time}) {
    if (time) fuzz::claim(parse_utc(format_utc(*time)) == *time, "a time that cannot be written");
  }
}

/// What we write for gpsdecode is printable, short, and the same message when it is read.
void check_message(const AisMessage& message) {
  fuzz::claim(message.type() >= 0 && message.type() <= 63, "a type of more than six bits");
  if (message.payload.size() > 9 * 56) return;  // never sent
  MessageAssembler again;
  std::optional<AisMessage> back;
  for (const std::string& sentence : message.sentences()) {
    fuzz::claim(sentence.size() <= 80, "a sentence longer than NMEA 0183 allows");
    for (const char c : sentence)
      fuzz::claim(c > ' ' && c <= '~', "a character that is not printable");
    back = again.take(sentence);
  }
  fuzz::claim(back && back->payload == message.payload && back->fill_bits == message.fill_bits,
              "a message changes when it is written and read");
}

void check_report(const AisReport& report) {
  fuzz::claim(report.mmsi >= 1 && report.mmsi <= 999'999'999, "an MMSI out of range");
  if (report.position) {
    fuzz::claim(std::abs(report.position->latitude_deg()) <= 90.0000001,
                "a latitude off the globe");
    fuzz::claim(std::abs(report.position->longitude_deg()) <= 180.0000001,
                "a longitude off the globe");
  }
  if (report.speed_over_ground_m_s) {
    fuzz::claim(*report.speed_over_ground_m_s >= 0 && *report.speed_over_ground_m_s < 53,
                "a speed out of range");
  }
  for (const auto& angle : {report.course_over_ground, report.heading}) {
    if (angle)
      fuzz::claim(angle->degrees() >= 0 && angle->degrees() < 360.0000001, "an angle out of range");
  }
  for (const auto& text : {report.identity.name, report.identity.callsign}) {
    if (!text) continue;
    fuzz::claim(!text->empty() && text->size() <= 20, "a name of no length or too long");
    for (const char c : *text) fuzz::claim(c >= ' ' && c <= '~', "a name that cannot be printed");
  }
}

}  // namespace

/// A log of AIS, line by line: as sentences, as what gpsdecode may answer, and as rows of a table
/// whose header is the first line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view log = fuzz::text_of(data, size);
  fuzz::accepts([&] {
    MessageAssembler assembler;
    const AisTable table(log.substr(0, log.find('\n')));
    for (std::string_view rest = log; !rest.empty();) {
      const std::size_t end = rest.find('\n');
      const std::string_view line = rest.substr(0, end);
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
      const AisLine read = parse_ais_line(line);
      if (const auto* sentence = std::get_if<AisSentence>(&read)) check_sentence(*sentence);
      if (const auto* problem = std::get_if<MalformedLine>(&read)) {
        fuzz::claim(!problem->reason.empty(), "a malformed line without a reason");
      }
      if (const auto message = assembler.take(line)) check_message(*message);
      if (const auto report = report_from_json(line)) check_report(*report);
      if (const auto report = table.report_of(line)) check_report(*report);
    }
    assembler.finish();
    const AisLineCounts& counts = assembler.counts();
    fuzz::claim(counts.lost_fragments <= counts.sentences, "more sentences lost than read");
    fuzz::claim(counts.sentences + counts.malformed <= counts.lines, "more sentences than lines");
  });
  return 0;
}
