#include "io/lines/ogr_reader.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/child_process.hpp"
#include "io/lines/coordinate_system.hpp"
#include "io/lines/csv_reader.hpp"
#include "io/lines/line_format.hpp"
#include "io/lines/ogr_layers.hpp"
#include "io/lines/text_rows.hpp"
#include "io/mapped_file.hpp"
#include "io/scratch_folder.hpp"

namespace quarry {
namespace {

// GDAL closes a full circle with a chord of this step, whatever gap is allowed: it has to be small for that
// chord to stay within the tolerance, as it does up to a radius of 26,000 times that.
constexpr double kArcStepDegrees = 1;

// The first error that GDAL told, or its last row.
std::string reason_in(const std::string& path) {
  const MappedFile file(path);
  TextRows rows(file.text());
  std::string reason;
  while (rows.next()) {
    const std::string_view row = trimmed(rows.row());
    if (row.empty()) continue;
    reason = row.substr(0, 300);
    if (row.starts_with("ERROR")) break;
  }
  return reason;
}

class OgrReader {
 public:
  OgrReader(const LineSource& source, const OgrOptions& options, LineSet& lines)
      : source_(source), options_(options), lines_(lines) {
    // No name is taken for an option, or for a database.
    const std::filesystem::path path(source.name);
    path_ = path.is_absolute() ? source.name : (std::filesystem::path(".") / path).string();
  }

  void read() {
    if (!std::filesystem::exists(source_.name)) fail("cannot be read: No such file or directory");
    run({"ogrinfo", "-ro", "-so", "-al", "-nocount", "-noextent", "-nomd", path_}, "layers");
    const MappedFile text(folder_.file("layers"));
    std::vector<OgrLayer> layers = parse_ogr_layers(text.text());
    std::erase_if(layers, [](const OgrLayer& layer) { return !layer.geometry; });
    for (const OgrLayer& layer : layers) {
      if (layer.system != layers.front().system)
        fail(
            fmt::format("layers {} and {} have different coordinate systems; give them as files of their own",
                        layers.front().name, layer.name));
      read_layer(layer.name);
    }
    lines_.systems[source_.file] = describe_system(layers.empty() ? "" : layers.front().system);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(ErrorKind::kInput, fmt::format("{}: {}", source_.name, problem));
  }

  void run(std::vector<std::string> words, const std::string& out) {
    ChildStart start;
    start.words = std::move(words);
    start.out = folder_.file(out);
    start.err = folder_.file("messages");
    const std::optional<int> status = run_program(start, options_.progress);
    const std::string extension = std::filesystem::path(source_.name).extension().string();
    if (!status)
      fail(
          fmt::format("no reader for lines in '{}' files without GDAL's ogr2ogr: install it (Debian: apt-get "
                      "install gdal-bin), or save them as one of {}",
                      extension, readable_line_extensions()));
    if (*status != 0) {
      std::string reason = reason_in(start.err);
      if (reason.empty()) reason = reason_in(start.out);
      fail(fmt::format("GDAL ({}) cannot read it: {}; read without GDAL: {}", start.words[0],
                       reason.empty() ? fmt::format("exit status {}", *status) : reason,
                       readable_line_extensions()));
    }
  }

  void read_layer(const std::string& layer) {
    const std::string out = folder_.file("lines.csv");
    std::filesystem::remove(out);
    // Of the formats that take every sort of geometry in one file, well-known text keeps all digits.
    std::vector<std::string> words = {"ogr2ogr"};
    const auto configure = [&](const char* key, std::string value) {
      words.insert(words.end(), {"--config", key, std::move(value)});
    };
    configure("OGR_WKT_PRECISION", "17");
    configure("OGR_WKT_ROUND", "FALSE");
    configure("OGR_ARC_STEPSIZE", fmt::format("{}", kArcStepDegrees));
    if (options_.arc_tolerance) {
      // Small arcs have chords of this step, large ones chords of the gap. Farthest from its chord is the arc
      // for which both are the same: by half the gap times the tangent of a quarter of the step.
      const double step = kArcStepDegrees * std::numbers::pi / 180;
      configure("OGR_ARC_MAX_GAP", fmt::format("{}", 2 * *options_.arc_tolerance / std::tan(step / 4)));
    }
    words.insert(words.end(),
                 {"-f", "CSV", "-lco", "GEOMETRY=AS_WKT", "-nlt", "CONVERT_TO_LINEAR", out, path_, layer});
    run(std::move(words), "said");
    const MappedFile file(out);
    LineSource source = source_;
    source.text = file.text();
    read_csv_table(source, ',', lines_);
  }

  const LineSource& source_;
  const OgrOptions& options_;
  LineSet& lines_;
  ScratchFolder folder_;
  std::string path_;
};

}  // namespace

void read_ogr_lines(const LineSource& source, const OgrOptions& options, LineSet& lines) {
  OgrReader(source, options, lines).read();
}

}  // namespace quarry
