#pragma once
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "api/door/http/websocket.h"
#include "api/door/people/farm_output.h"
#include "api/door/people/gathering.h"
#include "api/door/people/inspected_now.h"
#include "api/door/people/pictures_now.h"
#include "api/door/people/run_desk.h"
#include "api/door/people/station.h"
#include "api/door/people/ticker.h"
#include "api/door/people/told.h"

namespace slackwater::people {

struct SessionSettings {
  std::string id = "run";
  std::string name;                         ///< of the run, for people
  std::function<UtcTime()> now;             ///< the clock of the wall
  std::function<void(const Action&)> keep;  ///< each row of the record, at once; may be empty
};

/// One live run and the people who take part in it. The server's word is the only one: what a
/// station says is asked for, never done by itself.
///
/// Three threads meet here: the server's, which brings what stations say (`WebSocketHandler`); the
/// run's, which leaves at its barriers what there is to see and never waits for a station; and one
/// of its own, which twenty times a second minds the helms and tells the stations what changed.
class Session final : public api::http::WebSocketHandler {
 public:
  Session(SessionSettings settings, TokenBook book);
  ~Session() override;

  /// Joins a run that is about to begin; on the thread of the run.
  void begin(const api::RunInHand& hand);
  /// The run is over; its parts may go. Tells the stations and closes them.
  void end();

  [[nodiscard]] const std::string& id() const noexcept { return settings_.id; }
  /// Of `GET /sessions`.
  [[nodiscard]] nlohmann::json summary() const;
  /// Why a token opens no seat now; nothing: it does. @param path  that was asked for
  [[nodiscard]] std::optional<api::http::Response> refusal_of(std::string_view token,
                                                              const std::string& path) const;
  /// The same for who only reads: a token all of whose seats are taken may.
  [[nodiscard]] std::optional<api::http::Response> refusal_to_read(std::string_view token,
                                                                   const std::string& path) const;
  [[nodiscard]] std::vector<Action> actions() const;

  /// What a camera of a vehicle saw: tells the stations that it is there. From any thread.
  void take_picture(const live::SensorPicture& picture);
  /// The last picture of a camera, as JPEG; 404 that names the cameras there are.
  /// @param path  that was asked for
  [[nodiscard]] api::http::Response picture(const std::string& vehicle, const std::string& sensor,
                                            const std::string& path) const;

  /// What a vehicle inspects, for drawing; 404 that names what there is.
  [[nodiscard]] api::http::Response surface(const std::string& vehicle, const std::string& surface,
                                            const std::string& path) const;

  // --- stations ---
  [[nodiscard]] std::vector<std::string> protocols() const override;
  [[nodiscard]] std::optional<api::http::Response> refusal(
      const api::http::Request& request) const override;
  void opened(const std::shared_ptr<api::http::WebSocket>& socket,
              const api::http::Request& request, const std::string& protocol) override;
  void received_text(api::http::WebSocket& socket, std::string_view text) override;
  void received_bytes(api::http::WebSocket& socket, std::span<const std::uint8_t> bytes) override;
  void closed(api::http::WebSocket& socket) override;

 private:
  using Socket = const api::http::WebSocket*;
  [[nodiscard]] Milliseconds clock() const;
  /// @return whether there will be another one: not once the run is over
  bool tick();
  void look_at_run(const twin::RunControl& control);
  void tell_all(const nlohmann::json& json);
  /// Those who asked to be told briefly, or those who did not.
  [[nodiscard]] bool has_those(bool is_brief) const;
  void tell_those(bool is_brief, const nlohmann::json& json);
  void tell(Station& station, const nlohmann::json& json);
  void turn_out(Station& station, CloseCode code, const std::string& text);
  void cut_off(Station& station);
  void hello(Station& station, const StationSays& says);
  void welcome(Station& station, const Seats::Taken& taken);
  void heard(Station& station, const StationSays& says);
  void gather(Station& station, const StationSays& says);
  void attend(Station& station, const StationSays& says);
  void desk_work(Station& station, const StationSays& says);
  void note_stick(Station& station, const StationSays& says, const Said& said);
  void end_stick(Station& station);
  /// @param count  of sticks, at their end
  void record(const Seat& seat, std::string what, const Said& said, std::uint64_t count = 1);
  const Action& add_to_record(const Seat& seat, std::string what, const Said& said,
                              std::uint64_t count);
  void drop_seat(unsigned seat, const std::string& why);
  void tell_seats();
  void tell_helms();
  void tell_status(bool is_second);
  void tell_run();
  void tell_around();
  void tell_lines();
  void tell_thrusts();
  void tell_thrusts_briefly();
  void tell_gathering();
  [[nodiscard]] nlohmann::json pictures_json() const;
  void mind_farm();
  void begin_inspections();
  void mind_inspections();
  [[nodiscard]] nlohmann::json weather_now() const;
  [[nodiscard]] ShownHelm shown(std::size_t vehicle) const;
  [[nodiscard]] nlohmann::json run_json() const;
  [[nodiscard]] std::string run_state() const;

  SessionSettings settings_;
  std::chrono::steady_clock::time_point began_;

  mutable std::mutex mutex_;
  Seats seats_;
  ActionRecord record_;
  std::map<Socket, Station> stations_;
  std::optional<api::RunInHand> hand_;  ///< nothing: not begun, or over
  std::unique_ptr<RunDesk> desk_;
  RunNow now_;
  nlohmann::json run_facts_;  ///< that never change: of the welcome
  std::vector<ShownHelm> helms_told_;
  std::vector<nlohmann::json> status_told_, lines_told_, thrusts_told_, thrust_rows_told_;
  nlohmann::json seats_told_, run_told_, weather_told_, traffic_told_;
  Gathering gathering_;
  nlohmann::json looks_told_ = nlohmann::json::array(), notes_told_ = nlohmann::json::array();
  std::shared_ptr<FarmOutput> farm_;  ///< null: the site has no turbines
  std::optional<FarmNow> farm_now_;
  /// By vehicle; once there is a run, the first two are of the ticker's thread alone.
  std::map<std::size_t, std::shared_ptr<const twin::InspectionState>> looks_minded_;
  std::map<std::size_t, std::unique_ptr<InspectedNow>> inspected_;
  std::map<std::size_t, ToldInspection> inspections_;
  PicturesNow pictures_;
  bool is_over_ = false;
  Milliseconds barrier_at_ = 0, barrier_after_ = 0;  ///< the last one, and how long after another
  Milliseconds second_at_ = 0, lines_at_ = 0, thrusts_at_ = 0;

  std::mutex look_mutex_;  ///< of what the run leaves
  std::optional<RunNow> left_;
  std::unique_ptr<RunLook> look_;
  std::chrono::steady_clock::time_point looked_at_{};

  Ticker ticker_;  ///< goes first
};

}  // namespace slackwater::people
