#include "api/door/people/gathering.h"

#include <algorithm>
#include <cmath>

#include "api/door/people/told.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::people {
namespace {

using nlohmann::json;

constexpr std::size_t longest_note = 200;

twin::Triple<double> place_in(const StationSays& says, std::string_view key) {
  const auto at = says.object_if(key);
  if (!at)
    throw Error(ErrorKind::invalid_input,
                formatted("{}: found no {}, expected {{east_m, north_m, up_m}}", says.what(), key));
  return place_of(*at);
}

std::string words_at(const Note& note) {
  return formatted("{} at {:.1f} m east, {:.1f} m north, {:.1f} m up", note.text, note.at_m.y,
                   note.at_m.x, -note.at_m.z);
}

}  // namespace

void Gathering::look(const Seat& seat, const StationSays& says) {
  if (!says.object_if("from")) return gone(seat.number);
  Look look{place_in(says, "from"), says.number("heading_deg", -360, 360),
            says.number("tilt_deg", -90, 90), std::nullopt};
  if (says.object_if("point")) look.pointed_m = place_in(says, "point");
  looks_[seat.number] = look;
}

bool Gathering::knows(const std::string& what) noexcept {
  return what == "note" || what == "unnote" || what == "acknowledge";
}

Said Gathering::handle(const Seat& seat, const StationSays& says, const RunNow& run) {
  if (seat.role == Role::looks_on)
    return refused(twin::RefusalReason::unauthorised,
                   says.what() + " needs the role of operator, and yours is spectator");
  if (says.what() == "note") return note(seat, says);
  if (says.what() == "unnote") return unnote(seat, says);
  return acknowledge(seat, says, run);
}

Said Gathering::note(const Seat& seat, const StationSays& says) {
  Note note{0, seat.number, seat.name, says.text("text", longest_note), place_in(says, "at")};
  if (notes_.size() >= most_notes)
    return refused(
        twin::RefusalReason::too_many,
        formatted("found {} notes, the most there are; take one away first", notes_.size()));
  note.number = next_note_++;
  notes_.push_back(note);
  Said said;
  said.after = words_at(note);
  return said;
}

Said Gathering::unnote(const Seat& seat, const StationSays& says) {
  const auto number = says.whole("note", 1, 0xFFFFFFFFLL);
  const auto found = std::find_if(notes_.begin(), notes_.end(),
                                  [&](const Note& note) { return note.number == number; });
  if (found == notes_.end())
    return refused(twin::RefusalReason::out_of_range,
                   formatted("found no note {}; it may have been taken away", number));
  if (found->seat != seat.number && seat.role != Role::supervises)
    return refused(
        twin::RefusalReason::unauthorised,
        formatted("note {} is of {}, who takes it away, or a supervisor", number, found->who));
  Said said;
  said.before = words_at(*found);
  notes_.erase(found);
  return said;
}

Said Gathering::acknowledge(const Seat& seat, const StationSays& says, const RunNow& run) {
  const auto vehicle = static_cast<std::size_t>(says.whole("vehicle", 0, 0xFFFF));
  const auto mmsi = static_cast<std::uint32_t>(says.whole("mmsi", 0, 0xFFFFFFFFLL));
  const AlarmNow* standing = nullptr;
  if (vehicle < run.vehicles.size())
    for (const AlarmNow& alarm : run.vehicles[vehicle].alarms)
      if (alarm.alarm.id == mmsi) standing = &alarm;
  if (standing == nullptr)
    return refused(
        twin::RefusalReason::out_of_range,
        formatted("found no alarm of vehicle {} about {}; it may be over", vehicle, mmsi));
  const auto [row, is_new] = acknowledged_by_.try_emplace({vehicle, mmsi}, seat.name);
  if (!is_new)
    return refused(twin::RefusalReason::out_of_range,
                   formatted("found it acknowledged by {}; nothing is left to do", row->second));
  Said said;
  if (run.agents != nullptr) said.vehicle = run.agents[vehicle].name;
  said.after = standing->name.empty() ? formatted("MMSI {}", mmsi) : standing->name;
  return said;
}

void Gathering::mind(RunNow& run) {
  std::map<AlarmKey, std::string> standing;
  for (std::size_t vehicle = 0; vehicle < run.vehicles.size(); ++vehicle)
    for (AlarmNow& alarm : run.vehicles[vehicle].alarms) {
      const auto found = acknowledged_by_.find({vehicle, alarm.alarm.id});
      if (found == acknowledged_by_.end()) continue;
      alarm.acknowledged_by = found->second;
      standing.insert(*found);
    }
  acknowledged_by_ = std::move(standing);
}

json Gathering::looks_json() const {
  json looks = json::array();
  for (const auto& [seat, look] : looks_)
    looks.push_back({{"seat", seat},
                     {"from", place_json(look.from_m)},
                     {"heading_deg", std::round(look.heading_deg)},
                     {"tilt_deg", std::round(look.tilt_deg)},
                     {"point", look.pointed_m ? place_json(*look.pointed_m) : json(nullptr)}});
  return looks;
}

json Gathering::notes_json() const {
  json notes = json::array();
  for (const Note& note : notes_)
    notes.push_back({{"note", note.number},
                     {"seat", note.seat},
                     {"who", note.who},
                     {"text", note.text},
                     {"at", place_json(note.at_m)}});
  return notes;
}

}  // namespace slackwater::people
