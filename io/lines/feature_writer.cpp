#include "io/lines/feature_writer.hpp"

#include "io/text_output.hpp"

namespace quarry {

void write_features_geojson(const std::string& path, const LineSet& lines,
                            const std::function<std::string(LineId)>& properties) {
  AtomicFile file(path);
  file.write("{\"type\":\"FeatureCollection\",\"features\":[\n");
  write_lines(file, lines.lines.size(), [&](TextLine text, std::size_t i) {
    const InputLine& line = lines.lines[LineId(i)];
    text << "{\"type\":\"Feature\",\"properties\":{" << properties(LineId(i)) << "},\"geometry\":{\"type\":\""
         << (line.polygon_ring ? "Polygon\",\"coordinates\":[[" : "LineString\",\"coordinates\":[");
    for (std::size_t k = 0; k < line.points.size(); ++k)
      text << (k == 0 ? "[" : ",[") << line.points[k].x << "," << line.points[k].y << "]";
    text << (line.polygon_ring ? "]]}}" : "]}}") << (i + 1 < lines.lines.size() ? ",\n" : "\n");
  });
  file.write("]}\n");
  file.commit();
}

}  // namespace quarry
