#include "api/door/cli/sea/sample_write.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "api/door/cli/progress.h"
#include "api/pipeline/snapshot_json.h"
#include "fields/base/encode/csv.h"
#include "fields/base/error.h"
#include "ingest/cf/forecast/averaged_json.h"
#include "ingest/cf/forecast/point_samples_writer.h"
#include "ingest/cf/forecast/provenance_json.h"

namespace slackwater::api {
namespace {

using ingest::PointSamplesWriter;
using nlohmann::json;

std::string in_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

ingest::PointSamplesHead head_of(const Samples& s) {
  const Snapshot& f = s.field->snapshot();
  const std::string credit = in_lines(f.attributions);
  return {s.grid.points,
          s.grid.time,
          s.grid.depth_m,
          UtcTime(f.day) + std::chrono::days(1),
          s.members,
          {{"title", "Currents of the Slackwater forecast for " + f.site_name},
           {"institution", "Slackwater"},
           {"source", "Slackwater forecast " + std::to_string(s.row.id) + " from day " +
                          format_day(f.day) + ", " + s.row.code_version},
           {"history", format_utc(f.issued) + " issued by Slackwater"},
           {"references", credit.empty() ? "none" : credit},
           {"comment", f.headline.empty() ? "none" : f.headline},
           {"slackwater_site_id", f.site_id},
           {"slackwater_instance", std::to_string(s.row.id)},
           {"slackwater_issued", format_utc(f.issued)},
           {"slackwater_day", format_day(f.day)},
           {"slackwater_degraded", f.degraded ? "true" : "false"},
           {"slackwater_contains_stokes", f.contains_stokes ? "true" : "false"},
           {"slackwater_hindsight", f.hindsight ? "true" : "false"},
           {"slackwater_simulated_wind", f.simulated_wind ? "true" : "false"},
           {"slackwater_averaged_currents", ingest::averaged_json(f.averaged)},
           {"slackwater_attributions", credit},
           {"slackwater_provenance", ingest::provenance_json(f.provenance)}},
          s.names};
}

/// Shows how far the work is, block by block.
class Progress {
 public:
  Progress(const Samples& s, bool quiet)
      : bar_("sampling", quiet), s_(s), all_(s.grid.points.size() * s.members) {}
  void took(const SampleBlock& block) {
    done_ += block.east_m_s.size() / s_.grid.per_point();
    bar_.update(static_cast<double>(done_) / static_cast<double>(all_));
  }

 private:
  ProgressBar bar_;
  const Samples& s_;
  std::size_t all_;
  std::size_t done_ = 0;
};

}  // namespace

void write_netcdf(const std::filesystem::path& file, Samples& s, bool quiet) {
  PointSamplesWriter out(file, head_of(s));
  Progress progress(s, quiet);
  s.counts = sample_points(
      *s.field, s.grid, s.members, PointSamplesWriter::fill, [&](const SampleBlock& block) {
        out.write(block.member, block.first_point, block.east_m_s, block.north_m_s);
        if (block.member == 0) out.write_status(block.first_point, block.status);
        progress.took(block);
      });
  out.close();
}

namespace {

void write_rows(std::ostream& out, const SampleBlock& block, const Samples& s) {
  const SampleGrid& grid = s.grid;
  std::vector<std::string> stamp;
  for (const UtcTime time : grid.time) stamp.push_back(format_utc(time));
  char text[200];
  for (std::size_t i = 0; i < block.east_m_s.size(); ++i) {
    const std::size_t point = block.first_point + i / grid.per_point();
    const std::size_t time = i / grid.depth_m.size() % grid.time.size();
    const auto status = static_cast<SampleStatus>(block.status[i]);
    const bool is_there = has_value(status) && block.east_m_s[i] != PointSamplesWriter::fill;
    char values[48] = ",";
    if (is_there) {
      std::snprintf(values, sizeof values, "%.4f,%.4f", static_cast<double>(block.east_m_s[i]),
                    static_cast<double>(block.north_m_s[i]));
    }
    std::snprintf(
        text, sizeof text, "%zu,%.6f,%.6f,%s,%g,%zu,%s,%s", point + 1,
        grid.points[point].longitude_deg(), grid.points[point].latitude_deg(), stamp[time].c_str(),
        grid.depth_m[i % grid.depth_m.size()], block.member, values,
        std::string(name_of(has_value(status) && !is_there ? SampleStatus::missing : status))
            .c_str());
    out << text;
    if (!s.names.empty()) out << ',' << csv_cell(s.names[point]);
    out << '\n';
  }
}

}  // namespace

void write_csv(const std::filesystem::path& file, Samples& s, bool quiet) {
  std::ofstream out(file);
  out << "point,longitude_deg,latitude_deg,time,depth_m,member,east_m_s,north_m_s,status"
      << (s.names.empty() ? "\n" : ",name\n");
  Progress progress(s, quiet);
  s.counts = sample_points(*s.field, s.grid, s.members, PointSamplesWriter::fill,
                           [&](const SampleBlock& block) {
                             if (out) write_rows(out, block, s);
                             progress.took(block);
                           });
  out.close();
  if (out) return;
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  throw Error(ErrorKind::unavailable,
              "cannot write " + file.string() + "; check free space and permissions");
}

std::size_t with_value(const StatusCounts& counts) {
  std::size_t count = 0;
  for (std::size_t s = 0; s < counts.size(); ++s)
    count += has_value(static_cast<SampleStatus>(s)) ? counts[s] : 0;
  return count;
}

std::string counts_text(const StatusCounts& counts) {
  std::string text;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    if (counts[s] == 0) continue;
    text += (text.empty() ? "" : ", ") + std::string(name_of(static_cast<SampleStatus>(s))) + " " +
            std::to_string(counts[s]);
  }
  return text;
}

void print_samples_json(const Samples& s, const std::filesystem::path& out) {
  json status = json::object();
  for (std::size_t i = 0; i < s.counts.size(); ++i)
    status[std::string(name_of(static_cast<SampleStatus>(i)))] = s.counts[i];
  const Snapshot& f = s.field->snapshot();
  const json document = {{"site", f.site_id},
                         {"instance", s.row.id},
                         {"issued", format_utc(f.issued)},
                         {"day", format_day(f.day)},
                         {"degraded", f.degraded},
                         {"hindsight", f.hindsight},
                         {"simulated_wind", f.simulated_wind},
                         {"averaged", averaged_json(f.averaged)},
                         {"headline", f.headline},
                         {"out", out.string()},
                         {"points", s.grid.points.size()},
                         {"times", s.grid.time.size()},
                         {"from", format_utc(s.grid.time.front())},
                         {"to", format_utc(s.grid.time.back())},
                         {"depth_m", s.grid.depth_m},
                         {"members", s.members},
                         {"status", status},
                         {"valid",
                          {{"bbox",
                            {s.range.box.west_deg, s.range.box.south_deg, s.range.box.east_deg,
                             s.range.box.north_deg}},
                           {"from", format_utc(s.range.from)},
                           {"to", format_utc(s.range.to)},
                           {"deepest_m", s.range.deepest_m}}},
                         {"attributions", f.attributions}};
  std::printf("%s\n", document.dump(2, ' ', false, json::error_handler_t::replace).c_str());
}

void print_samples(const Samples& s, const std::filesystem::path& out) {
  const Snapshot& f = s.field->snapshot();
  std::printf("%s, forecast %lld issued %s from day %s\n", f.site_name.c_str(),
              static_cast<long long>(s.row.id), format_utc(f.issued).c_str(),
              format_day(f.day).c_str());
  if (f.degraded) std::printf("DEGRADED: %s\n", f.headline.c_str());
  std::printf("%zu points x %zu times x %zu depths, %zu member%s: %s\n%s\n", s.grid.points.size(),
              s.grid.time.size(), s.grid.depth_m.size(), s.members, s.members == 1 ? "" : "s",
              counts_text(s.counts).c_str(), out.c_str());
  for (const std::string& line : f.attributions) std::printf("%s\n", line.c_str());
}

}  // namespace slackwater::api
