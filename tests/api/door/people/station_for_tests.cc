#include "tests/api/door/people/station_for_tests.h"

#include <gtest/gtest.h>

#include <future>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests {
namespace {

using nlohmann::json;

api::ScenarioWater water_of_yaml(const twin::Scenario& scenario) {
  return api::water_of(scenario, {}, {});
}

UtcTime wall_now() {
  return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
}

}  // namespace

void expect_taken(const json& answer) {
  ASSERT_TRUE(answer.is_object());
  EXPECT_EQ(answer["taken"], true) << answer;
}

void expect_refused(const json& answer, const std::string& reason, const std::string& words) {
  ASSERT_TRUE(answer.is_object());
  EXPECT_EQ(answer["taken"], false) << answer;
  EXPECT_EQ(answer.value("reason", ""), reason);
  EXPECT_TRUE(contains(answer.value("text", ""), words));
}

SessionUnderWay::SessionUnderWay(const std::string& yaml, Choice choice)
    : book_(choice.book), control_(choice.real_time_factor) {
  people::SessionSettings settings;
  settings.name = "a test";
  settings.now = wall_now;
  session_ = std::make_shared<people::Session>(std::move(settings), std::move(choice.book));
  api::http::Router router;
  people::add_routes(router, session_);
  api::http::ServerOptions options;
  options.read_only = true;
  options.address = choice.address;
  server_ = std::make_unique<api::http::Server>(options, router);
  const auto start = [this] { server_->start(); };
  if (choice.where)
    choice.where(start);
  else
    start();
  std::promise<void> ready;
  run_ = std::thread([this, yaml, also = std::move(choice.also), over = std::move(choice.over),
                      with_water = std::move(choice.with_water), &ready] {
    const twin::Scenario scenario = twin::parse_scenario(yaml, "test.yaml");
    api::ScenarioWater water = water_of_yaml(scenario);
    if (with_water) with_water(water);
    api::RunChoice run;
    run.control = &control_;
    run.on_ready = [&](const api::RunInHand& hand) {
      session_->begin(hand);
      if (also) also(hand);
      ready.set_value();
    };
    run.on_over = [&] {
      session_->end();
      if (over) over();
    };
    run.actions = [&] { return session_->actions(); };
    result_ = api::run_scenario(scenario, water, run);
  });
  ready.get_future().wait();
}

const std::string& SessionUnderWay::token(people::Role role) const {
  for (const people::Grant& grant : book_.grants())
    if (grant.role == role) return grant.token;
  throw Error(ErrorKind::not_found, "no such token");
}

const api::ScenarioResult& SessionUnderWay::ended() {
  control_.stop();
  if (run_.joinable()) run_.join();
  return *result_;
}

StationClient::StationClient(const ServerPlace& place, const std::string& token,
                             const std::string& field_lines, const std::string& session)
    : socket_(place, "/sessions/" + session + "/socket", "slackwater.session.v1, bearer." + token,
              field_lines) {}

StationClient::StationClient(const AtLog& log, const std::string& field_lines)
    : socket_(log.port, "/sessions/log/socket", "slackwater.session.v1", field_lines) {}

int StationClient::says(json message) {
  message["id"] = next_id_;
  (void)socket_.send_text(message.dump());
  return next_id_++;
}

json StationClient::asks(json message) {
  const int id = says(std::move(message));
  return told("answer", [&](const json& answer) { return answer["id"] == id; });
}

json StationClient::hello(const std::string& name, bool is_brief) {
  json hello{{"do", "hello"}, {"name", name}};
  if (is_brief) hello["brief"] = true;
  says(std::move(hello));
  json welcome = told("welcome");
  if (welcome.is_null()) return welcome;
  number_ = welcome["number"];
  return welcome;
}

bool StationClient::receive(std::chrono::milliseconds within) {
  const auto frame = socket_.receive(within);
  if (!frame) return false;
  const std::size_t length = frame->payload.size();
  received_bytes += length;
  wire_bytes += length + (length < 126 ? 2 : length < 65'536 ? 4 : 10);
  if (frame->opcode == 9) return socket_.send(0x8A, frame->payload);
  if (frame->opcode == 8) {
    close_code_ = frame->code();
    return false;
  }
  if (frame->opcode == 2) {
    frames.push_back(frame->payload);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(frame->payload.data());
    if (says_saw)
      (void)socket_.send_text(
          json{{"do", "saw"}, {"frame", slackwater::session::GetFrame(bytes)->number()}}.dump());
    return true;
  }
  messages.push_back(json::parse(frame->payload));
  const json& message = messages.back();
  if (message["is"] == "welcome" || message["is"] == "clock") {
    clock_ = message["clock"];
    clock_at_ = std::chrono::steady_clock::now();
  }
  return true;
}

json StationClient::told(const std::string& is, const std::function<bool(const json&)>& is_so,
                         std::chrono::milliseconds within) {
  const auto end = std::chrono::steady_clock::now() + within;
  std::size_t looked = messages.size();
  while (std::chrono::steady_clock::now() < end) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        end - std::chrono::steady_clock::now());
    if (!receive(left)) break;
    for (; looked < messages.size(); ++looked)
      if (messages[looked]["is"] == is && (!is_so || is_so(messages[looked])))
        return messages[looked];
  }
  return nullptr;
}

void StationClient::listen(std::chrono::milliseconds for_ms) {
  const auto end = std::chrono::steady_clock::now() + for_ms;
  while (std::chrono::steady_clock::now() < end && close_code_ == 0)
    if (!receive(std::chrono::duration_cast<std::chrono::milliseconds>(
            end - std::chrono::steady_clock::now())))
      break;
}

int StationClient::closed(std::chrono::milliseconds within) {
  listen(within);
  return close_code_;
}

std::int64_t StationClient::clock() const {
  return clock_ + std::chrono::duration_cast<std::chrono::milliseconds>(
                      std::chrono::steady_clock::now() - clock_at_)
                      .count();
}

json StationClient::command(const std::string& what, int vehicle, json with) {
  with["do"] = what;
  with["vehicle"] = vehicle;
  with["number"] = number();
  // As long as it may be: a test is not about a machine that stands still for a moment.
  with["at"] = clock();
  with["until"] = clock() + (what == "stick" || what == "thrusters" ? 900 : 4'500);
  return with;
}

}  // namespace slackwater::tests
