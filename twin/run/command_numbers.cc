#include "twin/run/command_numbers.h"

#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>

#include "fields/base/error.h"

namespace slackwater::twin {
namespace {

/// Structs of doubles only.
template <typename T>
constexpr std::size_t size_of = sizeof(T) / sizeof(double);

template <typename T>
void append(const T& value, std::vector<double>& numbers) {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0);
  const std::size_t before = numbers.size();
  numbers.resize(before + size_of<T>);
  std::memcpy(numbers.data() + before, &value, sizeof(T));
}

/// Takes numbers off the front of a list.
struct Reader {
  std::string_view kind;
  std::span<const double> left;

  template <typename T>
  T take() {
    expect(left.size() >= size_of<T>);
    T value;
    std::memcpy(static_cast<void*>(&value), left.data(), sizeof(T));
    left = left.subspan(size_of<T>);
    return value;
  }
  bool flag() {
    const auto value = take<double>();
    expect(value == 0 || value == 1);
    return value == 1;
  }
  template <typename T>
  std::optional<T> take_if() {
    return flag() ? std::optional(take<T>()) : std::nullopt;
  }
  std::string text() {
    const auto size = take<double>();
    expect(size >= 0 && size <= static_cast<double>(left.size()) && size == std::floor(size));
    std::string letters;
    for (std::size_t i = static_cast<std::size_t>(size); i > 0; --i) {
      const auto code = take<double>();
      expect(code >= 0 && code <= 255 && code == std::floor(code));
      letters += static_cast<char>(static_cast<unsigned char>(code));
    }
    return letters;
  }
  void expect(bool condition) const {
    if (!condition)
      throw Error(ErrorKind::invalid_input, "found " + std::to_string(left.size()) +
                                                " numbers left that are none of a command " +
                                                std::string(kind));
  }
};

struct Writer {
  std::vector<double> numbers;

  void operator()(const Reroute& reroute) {
    numbers.push_back(reroute.loop ? 1 : 0);
    for (const Waypoint& waypoint : reroute.waypoints) append(waypoint, numbers);
  }
  void operator()(const SetVelocity& set) { append(set.velocity, numbers); }
  void operator()(const SetThrusters& set) { numbers = set.share; }
  void operator()(const SetActuators& set) {
    numbers.push_back(set.is_physical ? 1 : 0);
    append(set.given, numbers);
  }
  void operator()(const HoldHere& hold) { numbers.push_back(hold.is_client_lost ? 1 : 0); }
  void operator()(const GoHome&) {}
  void operator()(const Resume&) {}
  void operator()(const PutVehicle& put) { append(*put.vehicle, numbers); }
  void operator()(const HostPhysics& host) { numbers.push_back(host.is_hosted ? 1 : 0); }
  void operator()(const Spawn& spawn) {
    append_text(spawn.newcomer.model);
    append_text(spawn.newcomer.name);
    append(spawn.newcomer.position_m, numbers);
    numbers.push_back(spawn.newcomer.heading_rad);
  }
  void operator()(const PointCamera& camera) { append(camera.pointing, numbers); }
  void operator()(const SetWeather& weather) {
    const WeatherAsked& asked = weather.asked;
    append_if(asked.wind_10m_m_s);
    append_if(asked.significant_wave_height_m);
    append_if(asked.current_m_s);
    append_if(asked.visibility_m);
    append_if(asked.water_visibility_m);
    numbers.push_back(asked.over_s);
  }
  template <typename T>
  void append_if(const std::optional<T>& value) {
    numbers.push_back(value ? 1 : 0);
    if (value) append(*value, numbers);
  }
  void append_text(const std::string& text) {
    numbers.push_back(static_cast<double>(text.size()));
    for (const char c : text) numbers.push_back(static_cast<unsigned char>(c));
  }
};

CommandWhat read(Reader& reader) {
  const std::string_view kind = reader.kind;
  if (kind == name_of(CommandWhat{Reroute{}})) {
    Reroute reroute;
    reroute.loop = reader.flag();
    while (!reader.left.empty()) reroute.waypoints.push_back(reader.take<Waypoint>());
    return reroute;
  }
  if (kind == name_of(CommandWhat{SetThrusters{}})) {
    SetThrusters set{{reader.left.begin(), reader.left.end()}};
    reader.left = {};
    return set;
  }
  if (kind == name_of(CommandWhat{SetVelocity{}})) return SetVelocity{reader.take<HelmVelocity>()};
  if (kind == name_of(CommandWhat{SetActuators{}})) {
    SetActuators set;
    set.is_physical = reader.flag();
    set.given = reader.take<ActuatorValues>();
    return set;
  }
  if (kind == name_of(CommandWhat{HoldHere{}})) return HoldHere{reader.flag()};
  if (kind == name_of(CommandWhat{GoHome{}})) return GoHome{};
  if (kind == name_of(CommandWhat{Resume{}})) return Resume{};
  if (kind == name_of(CommandWhat{PutVehicle{}}))
    return PutVehicle{reader.take<VehicleState<double>>()};
  if (kind == name_of(CommandWhat{HostPhysics{}})) return HostPhysics{reader.flag()};
  if (kind == name_of(CommandWhat{Spawn{}})) {
    Newcomer newcomer;
    newcomer.model = reader.text();
    newcomer.name = reader.text();
    newcomer.position_m = reader.take<Triple<double>>();
    newcomer.heading_rad = reader.take<double>();
    return Spawn{std::move(newcomer), nullptr};
  }
  if (kind == name_of(CommandWhat{PointCamera{}}))
    return PointCamera{reader.take<CameraPointing>()};
  if (kind == name_of(CommandWhat{SetWeather{}})) {
    WeatherAsked asked;
    asked.wind_10m_m_s = reader.take_if<Horizontal>();
    asked.significant_wave_height_m = reader.take_if<double>();
    asked.current_m_s = reader.take_if<Horizontal>();
    asked.visibility_m = reader.take_if<double>();
    asked.water_visibility_m = reader.take_if<double>();
    asked.over_s = reader.take<double>();
    return SetWeather{asked};
  }
  throw Error(ErrorKind::invalid_input, "found a command of the kind " + std::string(kind) +
                                            ", which this version does not know");
}

}  // namespace

std::vector<double> numbers_of(const CommandWhat& what) {
  Writer writer;
  std::visit(writer, what);
  return std::move(writer.numbers);
}

CommandWhat what_of(std::string_view kind, std::span<const double> numbers) {
  Reader reader{kind, numbers};
  CommandWhat what = read(reader);
  reader.expect(reader.left.empty());
  return what;
}

}  // namespace slackwater::twin
