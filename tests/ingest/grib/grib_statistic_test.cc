#include <map>

#include "tests/ingest/grib/grib_fixture.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"

namespace slackwater::ingest::tests::grib_statistic_test {
namespace {

using slackwater::tests::contains;

struct GribStatistic : GribTest {
  /// A 10u/10v pair of ensemble products: template, then keys in order.
  void write_derived(long product_template,
                     const std::vector<std::pair<const char*, long>>& keys) const {
    write_bent(2, [&](grib::Message& message) { bend(message, product_template, keys); });
  }
  static void bend(grib::Message& message, long product_template,
                   const std::vector<std::pair<const char*, long>>& keys) {
    message.set("productDefinitionTemplateNumber", product_template);
    message.set("parameterCategory", 2L);
    for (const auto& [key, value] : keys) message.set(key, value);
  }
  [[nodiscard]] std::string warnings() {
    std::string all;
    for (const std::string& warning : decode().warnings) all += warning + "\n";
    return all;
  }
  /// Appends the messages of another file to this one.
  void append(const std::vector<char>& bytes) const {
    std::vector<char> all = contents();
    all.insert(all.end(), bytes.begin(), bytes.end());
    write_contents(all);
  }
};

TEST_F(GribStatistic, OfDerivedForecastsOnlyTheMeanOfAllMembersIsRead) {
  // WMO code table 4.7, and NCEP's local codes.
  const std::map<long, std::string> refused{{2, "standard deviation of the members"},
                                            {3, "normalised standard deviation"},
                                            {4, "spread of all members"},
                                            {5, "large anomaly index"},
                                            {6, "mean of a cluster"},
                                            {7, "interquartile range"},
                                            {8, "minimum of all members"},
                                            {9, "maximum of all members"},
                                            {192, "mode"},
                                            {193, "10 % percentile"},
                                            {77, "statistic of the members"}};
  for (const auto& [code, words] : refused) {
    write_derived(2, {{"derivedForecast", code}, {"numberOfForecastsInEnsemble", 31}});
    const std::string why = refusal();
    EXPECT_TRUE(contains(why, words)) << code << ": " << why;
    EXPECT_TRUE(contains(why, "derived forecast " + std::to_string(code))) << why;
    EXPECT_TRUE(contains(why, "expected the control, members or the mean")) << why;
  }
  for (const long code : {0L, 1L}) {
    write_derived(2, {{"derivedForecast", code}, {"numberOfForecastsInEnsemble", 31}});
    const Granule granule = decode().granules.at(0).granule;
    EXPECT_EQ(granule.dataset_id, "ensemble_mean");
    EXPECT_FALSE(granule.ensemble_member);
    EXPECT_TRUE(contains(warnings(), "means over the members of an ensemble"));
  }
}

TEST_F(GribStatistic, DerivedOverAnIntervalIsJudgedTwice) {
  const auto write = [&](long derived, long processing) {
    write_derived(12, {{"derivedForecast", derived},
                       {"numberOfForecastsInEnsemble", 31},
                       {"typeOfStatisticalProcessing", processing}});
  };
  write(4, 0);
  EXPECT_TRUE(contains(refusal(), "spread of all members"));
  write(0, 2);
  EXPECT_TRUE(contains(refusal(), "maximum over time (template 4.12)"));
}

TEST_F(GribStatistic, EveryStatisticalTemplateIsRefusedByName) {
  const std::map<long, std::string> refused{
      {3, "of a cluster"},  {4, "of a cluster"},   {5, "probability"}, {6, "percentile"},
      {7, "error"},         {9, "probability"},    {10, "percentile"}, {13, "of a cluster"},
      {14, "of a cluster"}, {51, "categories"},    {86, "quantile"},   {87, "quantile"},
      {91, "categories"},   {53, "not known here"}};
  for (const auto& [number, words] : refused) {
    write_derived(number, {});
    const std::string why = refusal();
    EXPECT_TRUE(contains(why, words)) << number << ": " << why;
    EXPECT_TRUE(contains(why, "template 4." + std::to_string(number))) << why;
  }
}

TEST_F(GribStatistic, StatisticsOverTimeAreRefusedByNameButAveragesAreRead) {
  for (const long number : {8L, 11L}) {
    const std::map<long, std::string> refused{{1, "accumulation"}, {2, "maximum"},
                                              {3, "minimum"},      {4, "difference"},
                                              {5, "root mean"},    {6, "standard deviation"}};
    for (const auto& [processing, words] : refused) {
      write_derived(number, {{"typeOfStatisticalProcessing", processing}});
      EXPECT_TRUE(contains(refusal(), words)) << number << " " << processing << refusal();
      EXPECT_TRUE(contains(refusal(), "over time")) << refusal();
    }
  }
  write_bent(2, [](grib::Message& message) {
    message.set("productDefinitionTemplateNumber", 8L);
    message.set("typeOfStatisticalProcessing", 0L);
    message.set("stepRange", std::string("3-6"));
  });
  EXPECT_TRUE(decode().granules.at(0).granule.grid.time.at(0).is_mean());
}

TEST_F(GribStatistic, AFieldMadeAsAnErrorOrAClimatologyIsRefused) {
  for (const auto& [process, words] : std::map<long, std::string>{{5, "probability forecast"},
                                                                  {6, "forecast error"},
                                                                  {7, "analysis error"},
                                                                  {9, "climatology"},
                                                                  {20, "analysis increment"}}) {
    write_derived(0, {{"typeOfGeneratingProcess", process}});
    EXPECT_TRUE(contains(refusal(), words)) << refusal();
  }
}

TEST_F(GribStatistic, TheTypesOfEcmwfAreHeardInEdition1) {
  const auto write = [&](long type) {
    write_bent(1, [&](grib::Message& message) {
      message.set("setLocalDefinition", 1L);
      message.set("localDefinitionNumber", 1L);
      message.set("type", type);
      message.set("numberOfForecastsInEnsemble", 51L);
    });
  };
  // MARS types by number (codes.ecmwf.int/grib/format/mars/type).
  const std::map<long, std::string> refused{
      {14, "type cm"},  {15, "type cs"}, {16, "type fp"},    {18, "type es"},    {20, "type cl"},
      {27, "type efi"}, {30, "type ep"}, {81, "type fcmax"}, {82, "type fcmin"}, {44, "type wes"}};
  for (const auto& [type, words] : refused) {
    write(type);
    EXPECT_TRUE(contains(refusal(), words)) << type << ": " << refusal();
  }
  write(17);
  const Granule mean = decode().granules.at(0).granule;
  EXPECT_EQ(mean.dataset_id, "ensemble_mean");
  EXPECT_FALSE(mean.ensemble_member);
  write(10);
  const Granule control = decode().granules.at(0).granule;
  EXPECT_EQ(control.dataset_id, "");
  EXPECT_EQ(control.ensemble_member, 0);
}

TEST_F(GribStatistic, NcepsEnsembleExtensionIsHeardInEdition1) {
  const auto write = [&](long type, long number, long product) {
    write_bent(1, [&](grib::Message& message) {
      message.set("centre", 7L);
      message.set("setLocalDefinition", 1L);
      message.set("localDefinitionNumber", 1L);
      message.set("type", type);
      message.set("identificationNumber", number);
      message.set("productIdentifier", product);
    });
  };
  write(5, 0, 11);
  EXPECT_TRUE(contains(refusal(), "standard deviation of the members (NCEP")) << refusal();
  write(5, 0, 1);
  EXPECT_EQ(decode().granules.at(0).granule.dataset_id, "ensemble_mean");
  write(4, 1, 2);
  EXPECT_TRUE(contains(refusal(), "cluster"));
  write(3, 4, 1);
  EXPECT_EQ(decode().granules.at(0).granule.ensemble_member, 7);
  write(2, 4, 1);
  EXPECT_EQ(decode().granules.at(0).granule.ensemble_member, 8);
}

TEST_F(GribStatistic, OfAFileWithBothTheWindIsReadAndTheRestIsCounted) {
  write_derived(2, {{"derivedForecast", 4}, {"numberOfForecastsInEnsemble", 31}});
  const std::vector<char> spread = contents();
  write_grib(file, std::array{wind_field("10u", run, 6), wind_field("10v", run, 6)}, 2, false);
  append(spread);
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 1U);
  EXPECT_TRUE(contains(warnings(), "left out 2 fields that are statistics")) << warnings();
  EXPECT_TRUE(contains(warnings(), "10u: spread of all members")) << warnings();
}

TEST_F(GribStatistic, TheMeanStandsApartFromControlAndMembersOfItsRun) {
  write_derived(2, {{"derivedForecast", 0}, {"numberOfForecastsInEnsemble", 31}});
  const std::vector<char> mean = contents();
  const auto member = [&](int number) {
    std::vector<GribField> fields{wind_field("10u", run, 6), wind_field("10v", run, 6)};
    for (GribField& field : fields) field.member = number;
    return fields;
  };
  std::vector<GribField> fields = member(0);
  for (const GribField& field : member(1)) fields.push_back(field);
  write_grib(file, fields, 2, false);
  append(mean);
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 3U);
  int means = 0;
  for (const DecodedGranule& decoded : ingested.granules)
    means += decoded.granule.dataset_id == "ensemble_mean" ? 1 : 0;
  EXPECT_EQ(means, 1);
}

TEST_F(GribStatistic, TheCaseFilesAreWhatTheySeem) {
  SLACKWATER_NEEDS_SHARED(shared);
  const std::filesystem::path cases = shared / "data" / "cases" / "statistics_as_quantity";
  if (!std::filesystem::is_directory(cases)) GTEST_SKIP() << "no case files in " << cases;
  for (const auto& [name, words] :
       std::map<std::string, std::string>{{"gespr.grib2", "derived forecast"},
                                          {"gespr4.grib2", "spread of all members"},
                                          {"maxdd.grib2", "maximum"}}) {
    file = cases / name;
    EXPECT_TRUE(contains(refusal(), words)) << name << ": " << refusal();
  }
  file = cases / "geavg.grib2";
  EXPECT_EQ(decode().granules.at(0).granule.dataset_id, "ensemble_mean");
  file = cases / "gec00.grib2";
  EXPECT_EQ(decode().granules.at(0).granule.dataset_id, "");
}

}  // namespace
}  // namespace slackwater::ingest::tests::grib_statistic_test
