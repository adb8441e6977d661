// Forecast files whose members were damaged: each is refused with a sentence, in bounded memory.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <map>
#include <set>
#include <variant>

#include "fields/base/error.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/netcdf/file.h"
#include "tests/support/made_up_forecast.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::forecast_members_hostile_test {
namespace {

constexpr const char* east = "eastward_sea_water_velocity_member";
constexpr const char* north = "northward_sea_water_velocity_member";

/// What a copy of a file does not take over as it was.
struct Damage {
  std::map<std::string, std::size_t> dimension_lengths;
  std::set<std::string> left_out;  ///< variables, global attributes
  std::map<std::string, std::vector<std::string>> dimensions;
  std::map<std::string, std::function<void(std::vector<double>&)>> values;
  std::map<std::string, std::string> attributes;  ///< global ones
  std::set<std::string> without_values;           ///< nothing but fill
};

void copy_attributes(netcdf::Writer& out, int id, const std::vector<netcdf::Attribute>& attributes,
                     const std::map<std::string, std::string>& changed) {
  for (const netcdf::Attribute& a : attributes) {
    if (a.name == "_FillValue" || a.name.starts_with("_NC")) continue;
    const auto change = changed.find(a.name);
    if (change != changed.end()) {
      out.attribute(id, a.name, change->second);
    } else if (const auto text = a.text()) {
      out.attribute(id, a.name, *text);
    } else {
      out.attribute(id, a.name, std::get<std::vector<double>>(a.value), a.type);
    }
  }
}

/// One file being copied, with what is damaged on the way.
class DamagedCopy {
 public:
  DamagedCopy(const std::filesystem::path& from, const std::filesystem::path& to,
              const Damage& damage)
      : in_(netcdf::File::open(from)), out_(netcdf::Writer::create(to)), damage_(damage) {
    for (const netcdf::Dimension& d : in_.dimensions()) {
      const auto length = damage.dimension_lengths.find(d.name);
      lengths_[d.name] = length == damage.dimension_lengths.end() ? d.length : length->second;
      dimensions_[d.name] = out_.dimension(d.name, lengths_[d.name]);
    }
    for (const netcdf::Variable& v : in_.variables()) define(v);
    std::vector<netcdf::Attribute> kept;
    for (const netcdf::Attribute& a : in_.attributes()) {
      if (!damage.left_out.contains(a.name)) kept.push_back(a);
    }
    copy_attributes(out_, netcdf::Writer::global, kept, damage.attributes);
    out_.end_definitions();
    for (const netcdf::Variable& v : in_.variables()) copy_values(v);
    out_.close();
  }

 private:
  const std::vector<std::string>& names_of(const netcdf::Variable& v) const {
    const auto changed = damage_.dimensions.find(v.name);
    return changed == damage_.dimensions.end() ? v.dimensions : changed->second;
  }
  void define(const netcdf::Variable& v) {
    if (damage_.left_out.contains(v.name)) return;
    std::vector<int> dimensions;
    for (const std::string& name : names_of(v)) dimensions.push_back(dimensions_.at(name));
    netcdf::Writer::Layout layout;
    layout.fill_value = v.number("_FillValue");
    if (v.compressed) layout.deflate = 1;
    ids_[v.name] = out_.variable(v.name, v.type, dimensions, layout);
    copy_attributes(out_, ids_[v.name], v.attributes, {});
  }
  void copy_values(const netcdf::Variable& v) {
    if (!ids_.contains(v.name) || damage_.without_values.contains(v.name)) return;
    if (v.type == netcdf::Type::character) {
      out_.write_text(ids_[v.name], in_.read_text(v));
      return;
    }
    std::vector<double> values = in_.read_all(v);
    std::size_t wanted = 1;
    for (const std::string& name : names_of(v)) wanted *= lengths_.at(name);
    values.resize(wanted, 1.0);
    const auto change = damage_.values.find(v.name);
    if (change != damage_.values.end()) change->second(values);
    out_.write_all(ids_[v.name], values);
  }

  netcdf::File in_;
  netcdf::Writer out_;
  const Damage& damage_;
  std::map<std::string, std::size_t> lengths_;
  std::map<std::string, int> dimensions_;
  std::map<std::string, int> ids_;
};

/// How a damaged copy is refused; empty where it is read.
/// @param is_numbered  whether a weather ensemble drives the members
std::string refusal_of(const Damage& damage,
                       const slackwater::tests::MadeUpForecast& size = {.members = 4},
                       bool is_numbered = false) {
  const slackwater::tests::TemporaryFolder folder;
  Snapshot sound = slackwater::tests::made_up_forecast(size);
  if (is_numbered) {
    for (ForecastColumn& column : sound.columns)
      column.wind_member_number.assign(size.members - 1, 9);
  }
  write_forecast(folder / "sound.nc", sound);
  const DamagedCopy copy(folder / "sound.nc", folder / "damaged.nc", damage);
  try {
    static_cast<void>(read_forecast(folder / "damaged.nc"));
  } catch (const Error& refused) {
    EXPECT_EQ(refused.kind(), ErrorKind::invalid_input);
    return refused.message();
  }
  return {};
}

void expect_refused(const Damage& damage, const std::string& because,
                    const slackwater::tests::MadeUpForecast& size = {.members = 4}) {
  const std::string found = refusal_of(damage, size);
  EXPECT_NE(found.find(because), std::string::npos) << "found: " << found;
}

TEST(DamagedMembers, AreNoneInAnExactCopy) {
  EXPECT_EQ(refusal_of({}), "");
  EXPECT_EQ(refusal_of({}, {.columns = 3, .members = 4}), "");
}

TEST(FileFromBeforeTheEnsemble, IsAForecastOfOneMember) {
  const slackwater::tests::TemporaryFolder folder;
  const Snapshot made = slackwater::tests::made_up_forecast({.columns = 2, .members = 4});
  write_forecast(folder / "now.nc", made);
  Damage age;
  age.left_out = {"realization", "slackwater_seed",      east,
                  north,         "eastward_wind_member", "northward_wind_member"};
  const DamagedCopy copy(folder / "now.nc", folder / "then.nc", age);
  const Snapshot read = read_forecast(folder / "then.nc");
  EXPECT_EQ(read.members, 1U);
  EXPECT_EQ(read.seed, 0U);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(read.columns[c].current_m_s, made.columns[c].current_m_s);
    EXPECT_TRUE(read.columns[c].member_m_s.empty());
  }
}

TEST(DamagedMembers, WithOtherNumbersAreRefused) {
  Damage damage;
  damage.values["realization"] = [](auto& v) { v.front() = 0; };
  expect_refused(damage, "not numbered 1, 2");
  damage.values["realization"] = [](auto& v) { std::swap(v[0], v[1]); };
  expect_refused(damage, "not numbered 1, 2");
}

TEST(DamagedMembers, BeyondAThousandAreRefused) {
  Damage damage;
  damage.dimension_lengths["realization"] = 1024;
  expect_refused(damage, "at most 1023 members");
}

TEST(DamagedMembers, OfOneComponentAreRefused) {
  for (const char* name : {east, north, "eastward_wind_member", "northward_wind_member"}) {
    Damage damage;
    damage.left_out = {name};
    expect_refused(damage, "one component only");
  }
}

TEST(DamagedMembers, OfAnotherShapeAreRefused) {
  Damage damage;
  damage.dimensions[east] = {"time", "realization", "depth"};
  expect_refused(damage, "unexpected shape");
  damage.dimensions[east] = {"depth"};
  expect_refused(damage, "unexpected shape");
}

TEST(DamagedMembers, ThatAreNotWholeAreRefused) {
  const auto remove_one = [](auto& v) { v[11] = 9.969209968386869e+36; };
  const auto remove_all = [](auto& v) { v.assign(v.size(), 9.969209968386869e+36); };
  for (const char* name : {east, north, "northward_wind_member"}) {
    Damage damage;
    damage.values[name] = remove_one;
    expect_refused(damage, "not whole");
    damage.values[name] = remove_all;
    expect_refused(damage, "not whole");
  }
}

TEST(DamagedMembers, WithoutANumberAreRefused) {
  Damage damage;
  damage.values[east] = [](auto& v) { v[11] = std::numeric_limits<double>::quiet_NaN(); };
  expect_refused(damage, "not a number");
}

TEST(DamagedMembers, OfAWindThatIsNotThereAreRefused) {
  Damage damage;
  damage.left_out = {"eastward_wind", "northward_wind", "wind_source"};
  expect_refused(damage, "without its central one");
}

TEST(DamagedMembers, WhoseDriversHaveNoNumbersAreRefused) {
  const slackwater::tests::MadeUpForecast size{.columns = 2, .members = 4};
  EXPECT_EQ(refusal_of({}, size, true), "");
  const auto refusal_after = [&](const std::function<void(std::vector<double>&)>& change) {
    Damage damage;
    damage.values["wind_member"] = change;
    return refusal_of(damage, size, true);
  };
  for (const double number : {-2.0, 1e7})
    EXPECT_NE(refusal_after([=](auto& v) { v[4] = number; }).find("without a number"),
              std::string::npos);
  EXPECT_NE(refusal_after([](auto& v) { v[4] = -1; }).find("for some members only"),
            std::string::npos);
  Damage shape;
  shape.dimensions["wind_member"] = {"realization"};
  EXPECT_NE(refusal_of(shape, size, true).find("unexpected shape"), std::string::npos);
  Damage windless;
  windless.left_out = {"eastward_wind_member", "northward_wind_member"};
  EXPECT_NE(refusal_of(windless, size, true).find("for some members only"), std::string::npos);
}

TEST(DamagedMembers, WithASeedThatIsNoNumberAreRefused) {
  for (const char* seed : {"", "-1", "7 ", "18446744073709551616", "many"}) {
    Damage damage;
    damage.attributes["slackwater_seed"] = seed;
    expect_refused(damage, "a seed that is not a number");
  }
}

TEST(DamagedMembers, OfAForecastWithAnUnknownWindPolicyAreRefused) {
  Damage damage;
  damage.attributes["slackwater_wind_policy"] = "storm";
  expect_refused(damage,
                 "slackwater_wind_policy: found wind policy 'storm', expected best, forecast or");
}

TEST(DamagedMembers, ThatDeflateToNothingAreRefusedBeforeTheyFillTheMemory) {
  Damage damage;
  damage.dimension_lengths["realization"] = 1023;
  damage.values["realization"] = [](auto& v) {
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = static_cast<double>(i + 1);
  };
  damage.without_values = {east, north, "eastward_wind_member", "northward_wind_member"};
  EXPECT_EQ(refusal_of(damage), "") << "members of nothing but fill are none";
  // 8201 stamps x 8 levels x 1023 members: 67 million values in a file of 5 MB.
  expect_refused(damage, "values; at most", {.levels = 8, .hours = 8200, .members = 2});
}

}  // namespace
}  // namespace slackwater::ingest::forecast_members_hostile_test
