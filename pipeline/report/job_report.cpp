#include "pipeline/report/job_report.hpp"

#include <cmath>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "io/atomic_file.hpp"
#include "pipeline/report/clean_up_json.hpp"

namespace quarry {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<ReportItem>& items) {
  Json object = Json::object();
  for (const ReportItem& item : items)
    std::visit([&](const auto& value) { object[item.name] = value; }, item.value);
  return object;
}

Json json_of(const ValueRange& range) {
  return {{"min", range.min}, {"mean", range.mean}, {"max", range.max}};
}

// Histograms are counts of faces.
Json json_of(const ShapeSummary& shape) {
  Json object;
  object["faces"] = shape.faces;
  Json& jacobian = object["scaled_jacobian"] = json_of(shape.scaled_jacobian);
  jacobian["share_below_0.2"] = shape.share(shape.scaled_jacobian_below_0p2);
  jacobian["share_not_positive"] = shape.share(shape.scaled_jacobian_not_positive);
  jacobian["histogram_0.1"] = shape.scaled_jacobian_histogram;
  Json& angle = object["min_angle"] = json_of(shape.min_angle);
  angle["histogram_10_degrees"] = shape.min_angle_histogram;
  object["max_angle"] = {{"max", shape.max_angle}, {"share_over_150", shape.share(shape.max_angle_over_150)}};
  Json& lo = object["lo_measure"] = json_of(shape.lo_measure);
  lo["histogram_0.1"] = shape.lo_histogram;
  object["aspect"] = json_of(shape.aspect);
  object["shortest_edge"] = shape.shortest_edge;
  return object;
}

Json json_of_valences(const std::vector<std::size_t>& histogram) {
  Json object = Json::object();
  for (std::size_t i = 0; i < histogram.size(); ++i)
    if (histogram[i] != 0) object[std::to_string(i)] = histogram[i];
  return object;
}

Json json_of(const ValenceSummary& valence) {
  return {{"regular", valence.regular},
          {"interior_vertices", valence.interior},
          {"irregular_share", valence.irregular_share()},
          {"free_vertices", valence.free},
          {"free_irregular_share", valence.free_irregular_share()},
          {"histogram", json_of_valences(valence.histogram)},
          {"free_histogram", json_of_valences(valence.free_histogram)}};
}

Json json_of(const QualitySummary& quality) {
  Json object;
  object["vertices"] = quality.vertices;
  object["triangles"] = quality.triangles.faces;
  object["quads"] = quality.quads.faces;
  object["area"] = quality.area;
  object["boundary_length"] = quality.boundary_length;
  object["face_area"] = {{"percentile_1", quality.face_area.first},
                         {"percentile_99", quality.face_area.last},
                         {"ratio", quality.face_area.ratio()}};
  object.update(json_of(quality.all));
  // With both sorts of faces, measures that mean different things for them are told apart as well.
  if (quality.triangles.faces != 0 && quality.quads.faces != 0) {
    object["of_triangles"] = json_of(quality.triangles);
    object["of_quads"] = json_of(quality.quads);
  }
  object["valence"] = json_of(quality.valence);
  return object;
}

void add_attributes(Json& line, const LineAttributes& attributes) {
  if (!attributes.name.empty()) line["name"] = attributes.name;
  if (!attributes.set.empty()) line["set"] = attributes.set;
  if (!attributes.material.empty()) line["material"] = attributes.material;
  if (attributes.aperture) line["aperture"] = *attributes.aperture;
}

Json lines_json(const JobReport& report) {
  Json lines = Json::array();
  for (std::size_t i = 0; i < report.lines.size(); ++i) {
    const LedgerEntry& entry = report.lines[LineId(i)];
    Json with = Json::array();
    for (const LineId other : entry.with) with.push_back(other.value());
    Json line = {{"line", i},        {"fate", name_of(entry.fate)}, {"with", std::move(with)},
                 {"why", entry.why}, {"moved", entry.moved},        {"clipped_length", entry.clipped_length}};
    if (i < report.line_files.size()) line["file"] = report.line_files[LineId(i)];
    if (i < report.line_attributes.size()) add_attributes(line, report.line_attributes[LineId(i)]);
    lines.push_back(std::move(line));
  }
  return lines;
}

Json points_json(const JobReport& report) {
  Json points = Json::array();
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const PointEntry& entry = report.points[PointId(i)];
    Json point = {{"point", i},
                  {"fate", entry.node.valid() ? "kept" : "dropped"},
                  {"why", entry.why},
                  {"moved", entry.moved}};
    if (i < report.point_attributes.size()) add_attributes(point, report.point_attributes[PointId(i)]);
    points.push_back(std::move(point));
  }
  return points;
}

Json constraints_json(const JobReport& report) {
  Json lines = Json::array();
  double largest = 0;
  for (std::size_t i = 0; i < report.line_distances.size(); ++i) {
    const double distance = report.line_distances[LineId(i)];
    if (std::isnan(distance)) continue;
    largest = std::max(largest, distance);
    lines.push_back({{"line", i}, {"largest_distance", distance}});
  }
  return {{"largest_distance", largest}, {"lines", std::move(lines)}};
}

Json regions_json(const JobReport& report) {
  Json regions = Json::array();
  for (const RegionSummary& region : report.regions) {
    Json json = {{"region", region.region}, {"faces", region.faces}, {"area", region.area}};
    for (const auto& [tag, name] : region.groups) json[tag] = name;
    regions.push_back(std::move(json));
  }
  return regions;
}

Json passes_json(const JobReport& report) {
  Json passes = Json::array();
  const auto append = [&](const std::vector<PassReport>& all) {
    for (const PassReport& pass : all)
      passes.push_back({{"name", pass.name},
                        {"rounds", pass.rounds},
                        {"proposed", pass.proposed},
                        {"live", pass.live},
                        {"won", pass.won}});
  };
  append(report.passes);
  if (report.clean_up) append(passes_of(*report.clean_up));
  return passes;
}

StageTime total_of(const std::vector<StageTime>& stages) {
  StageTime total{.name = "total"};
  for (const StageTime& stage : stages) {
    total.seconds += stage.seconds;
    total.processor_seconds += stage.processor_seconds;
  }
  return total;
}

Json times_json(const JobReport& report) {
  Json times = Json::object();
  for (const StageTime& stage : report.times) times[stage.name] = stage.seconds;
  times["total"] = total_of(report.times).seconds;
  if (report.clean_up) times["of_cleanup"] = clean_up_times_json(*report.clean_up);
  return times;
}

Json processor_json(const JobReport& report) {
  Json stages = Json::object();
  const auto add = [&](const StageTime& stage) {
    const double busy = stage.busy_share(report.threads);
    stages[stage.name] = {{"seconds", stage.processor_seconds}, {"busy", busy}, {"idle", 1 - busy}};
  };
  for (const StageTime& stage : report.times) add(stage);
  add(total_of(report.times));
  return stages;
}

// Names of files may hold bytes that are no UTF-8: they are replaced, not refused.
std::string dump(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string report_text(const JobReport& report) {
  Json json;
  json["command"] = report.command;
  json["quarry_version"] = report.version;
  json["options"] = json_of(report.options);
  json["counts"] = json_of(report.counts);
  json["quality"] = json_of(report.quality);
  if (report.quality_before) json["quality_before"] = json_of(*report.quality_before);
  json["input"] = {{"files", report.input_files},
                   {"hash", report.input_hash},
                   {"outline", report.outline},
                   {"lines", lines_json(report)}};
  if (!report.points.empty()) json["input"]["points"] = points_json(report);
  if (!report.coordinate_systems.empty()) json["input"]["coordinate_systems"] = report.coordinate_systems;
  json["constraints"] = constraints_json(report);
  json["regions"] = regions_json(report);
  json["passes"] = passes_json(report);
  if (report.clean_up) json["cleanup"] = clean_up_json(*report.clean_up);
  json["notes"] = report.notes;
  json["times"] = times_json(report);
  json["processor"] = processor_json(report);
  json["peak_memory_bytes"] = peak_memory_bytes();
  json["threads"] = report.threads;
  return dump(json);
}

void write_report(const std::string& path, const JobReport& report) { write_file(path, report_text(report)); }

std::string quality_text(const QualitySummary& quality) { return dump(json_of(quality)); }

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace quarry
