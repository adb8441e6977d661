#include "api/door/people/session.h"

#include "fields/base/error.h"
#include "fields/base/text.h"

// What the record of a session keeps. With the lock held, but for `actions`.

namespace slackwater::people {
namespace {

/// Whether both were taken, or refused for the same reason.
bool is_refused_alike(const std::optional<twin::Refusal>& a,
                      const std::optional<twin::Refusal>& b) {
  return a.has_value() == b.has_value() && (!a || a->reason == b->reason);
}

}  // namespace

/// Of a run that is over nothing more is told: its log is written.
void Session::record(const Seat& seat, std::string what, const Said& said, std::uint64_t count) {
  if (is_over_) return;
  nlohmann::json told = action_json(add_to_record(seat, std::move(what), said, count));
  told["is"] = "action";
  tell_all(told);
}

const Action& Session::add_to_record(const Seat& seat, std::string what, const Said& said,
                                     std::uint64_t count) {
  Action row;
  row.at = settings_.now();
  row.time_s = now_.time_s;
  row.step = now_.step;
  row.seat = seat.number;
  row.who = seat.name;
  row.role = name_of(seat.role);
  row.what = std::move(what);
  row.vehicle = said.vehicle;
  row.before = said.before;
  row.after = said.refused ? said.before : said.after;
  row.is_taken = !said.refused;
  if (said.refused) row.reason = twin::name_of(said.refused->reason);
  row.count = count;
  row.why = said.refused ? said.refused->text : said.why;
  return record_.add(std::move(row));
}

/// What somebody looks at who wants it kept: in the record, and told to nobody.
void Session::attend(Station& station, const StationSays& says) {
  if (is_over_) return;
  if (!station.deeds.take(clock())) return turn_out(station, CloseCode::too_many, many_deeds);
  const std::string by = says.text("by", 10);
  if (by != "head" && by != "pointer" && by != "off")
    throw Error(ErrorKind::invalid_input,
                "attend: found by: '" + by + "', expected head, pointer or off");
  Said said;
  said.before = station.attends_to;
  said.after = by == "off" ? "" : says.text_or_empty("on", 100);
  said.why = by;
  station.attends_to = said.after;
  add_to_record(*seats_.find(station.seat), attend_row, said, 1);
  tell(station, {{"is", "answer"}, {"id", says.id()}, {"taken", true}});
}

void Session::note_stick(Station& station, const StationSays& says, const Said& said) {
  const Milliseconds now = clock();
  const auto vehicle = static_cast<std::size_t>(says.whole("vehicle", 0, 0xFFFF));
  if (station.stick &&
      (station.stick->vehicle != vehicle || station.stick->row.what != says.what() ||
       !is_refused_alike(station.stick->refused, said.refused)))
    end_stick(station);
  if (!station.stick) {
    station.stick.emplace();
    station.stick->vehicle = vehicle;
    const Seat& seat = *seats_.find(station.seat);
    record(seat, says.what(), said);
    station.stick->row = record_.all().back();
    station.stick->refused = said.refused;
  }
  ++station.stick->count;
  station.stick->last_at = now;
}

void Session::end_stick(Station& station) {
  if (!station.stick) return;
  const StickRow stick = *std::exchange(station.stick, std::nullopt);
  const Seat* seat = seats_.find(station.seat);
  if (seat == nullptr || stick.count < 2) return;
  Said said;
  said.vehicle = stick.row.vehicle;
  said.before = stick.row.after;
  said.after = formatted("{} of them", stick.count);
  said.refused = stick.refused;
  record(*seat, stick.row.what + "_end", said, stick.count);
}

std::vector<Action> Session::actions() const {
  const std::lock_guard lock(mutex_);
  return record_.all();
}

}  // namespace slackwater::people
