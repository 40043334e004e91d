// Points, regions and sides that have names, from the files of lines to the files of meshes.
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"
#include "pipeline/section/boundary_rule.hpp"
#include "pipeline/section/conservation.hpp"
#include "pipeline/section/point_tags.hpp"
#include "pipeline/section/region_names.hpp"
#include "pipeline/section/section.hpp"

namespace quarry {
namespace {

constexpr const char* kWells =
    R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[0,0],[100,60]]}},
{"type":"Feature","properties":{"name":"W1"},"geometry":{"type":"Point","coordinates":[20,40.125]}},
{"type":"Feature","properties":{"name":"W2"},"geometry":{"type":"MultiPoint","coordinates":[[70,10],[70.75,10]]}},
{"type":"Feature","properties":{"name":"on the line"},"geometry":{"type":"Point","coordinates":[50,30]}}]})";

constexpr const char* kUnits =
    R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"name":"sand","material":"quartz"},"geometry":{"type":"Polygon",
 "coordinates":[[[0,0],[50,0],[50,40],[0,40],[0,0]],[[10,10],[20,10],[20,20],[10,20],[10,10]]]}},
{"type":"Feature","properties":{"name":"clay"},"geometry":{"type":"Polygon",
 "coordinates":[[[50,0],[90,0],[90,40],[50,40],[50,0]]]}},
{"type":"Feature","properties":{"name":"lens","material":"coal"},"geometry":{"type":"Polygon",
 "coordinates":[[[60,10],[80,10],[80,20],[60,20],[60,10]]]}}]})";

class Groups : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "quarry_groups_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  SectionOptions options_for(const char* text) {
    const std::string path = (folder_ / "in.geojson").string();
    std::ofstream(path) << text;
    SectionOptions options;
    options.inputs = {path};
    options.size = 4;
    return options;
  }
  static SectionResult mesh(const SectionOptions& options) { return mesh_section(options, Progress()); }
  static std::string error_of(const SectionOptions& options) {
    try {
      (void)mesh(options);
    } catch (const Error& error) {
      return error.message();
    }
    return "no error";
  }
  std::string text_of(const std::string& file, const SectionResult& result) {
    MeshWriteOptions options;
    options.groups = result.groups;
    options.names.points = point_names(result.lines);
    const std::string path = (folder_ / file).string();
    write_mesh(path, result.mesh, options);
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  Mesh read_back(const std::string& file) { return read_mesh((folder_ / file).string()); }

  std::filesystem::path folder_;
};

// The place of the vertex of each point.
std::map<std::int32_t, Vec2> places_of(const Mesh& mesh) {
  std::map<std::int32_t, Vec2> places;
  const auto tag = mesh.find_tag<VertexId, std::int32_t>(kPointTag);
  for (const VertexId v : mesh.vertices())
    if (tag[v] >= 0) places[tag[v]] = mesh.point(v);
  return places;
}

// How large the part of the mesh is that each name of a grouping has.
std::map<std::string, double> areas_of(const SectionResult& result, const std::string& grouping) {
  std::map<std::string, double> areas;
  for (const Grouping& group : result.groups) {
    const auto tag = result.mesh.find_tag<FaceId, std::int32_t>(group.tag);
    if (group.tag != grouping || !tag.valid()) continue;
    for (const FaceId f : result.mesh.faces()) {
      double twice = 0;
      for (int k = 0; k < result.mesh.corner_count(f); ++k) {
        const SideId s(f, k);
        twice += cross(result.mesh.point(result.mesh.origin(s)), result.mesh.point(result.mesh.target(s)));
      }
      areas[tag[f] < 0 ? "" : group.names[static_cast<std::size_t>(tag[f])]] += twice / 2;
    }
  }
  return areas;
}

TEST_F(Groups, EachPointIsAVertexInItsPlaceOnAnyNumberOfThreads) {
  for (const Elements elements : {Elements::kQuad, Elements::kTriangle}) {
    SectionOptions options = options_for(kWells);
    options.elements = elements;
    std::vector<Vec2> points;
    for (const int threads : {1, 2, 4, 7}) {
      SectionResult result;
      parallel::with_threads(threads, [&] { result = mesh(options); });
      const auto places = places_of(result.mesh);
      ASSERT_EQ(places.size(), 4U);
      EXPECT_EQ(places.at(0), (Vec2{20, 40.125}));
      EXPECT_EQ(places.at(1), (Vec2{70, 10}));
      EXPECT_EQ(places.at(2), (Vec2{70.75, 10}));
      EXPECT_EQ(places.at(3), (Vec2{50, 30}));
      std::vector<Vec2> all;
      for (const VertexId v : result.mesh.vertices()) all.push_back(result.mesh.point(v));
      if (threads == 1) points = all;
      EXPECT_EQ(all, points);
    }
  }
}

TEST_F(Groups, PointsStayWhereMatchingMakesTheQuads) {
  SectionOptions options = options_for(kWells);
  options.quads = QuadMethod::kMatching;
  EXPECT_EQ(places_of(mesh(options).mesh).at(1), (Vec2{70, 10}));
}

TEST_F(Groups, PointsAloneMakeAMeshInAWiderBox) {
  SectionOptions options = options_for(R"({"type":"MultiPoint","coordinates":[[1,2],[30,4],[12,25]]})");
  options.boundary = "box:10";
  const SectionResult result = mesh(options);
  EXPECT_EQ(places_of(result.mesh).size(), 3U);
  EXPECT_EQ(result.mesh.box().low, (Vec2{-9, -8}));
  EXPECT_EQ(result.mesh.box().high, (Vec2{40, 35}));
}

TEST_F(Groups, AOnePointMapNeedsABoundary) {
  SectionOptions options = options_for(R"({"type":"Point","coordinates":[1,2]})");
  EXPECT_NE(error_of(options).find("all points of the lines are one"), std::string::npos)
      << error_of(options);
  options.boundary = "box:10";
  EXPECT_EQ(places_of(mesh(options).mesh).at(0), (Vec2{1, 2}));
}

TEST_F(Groups, FilesNameTheVerticesOfPoints) {
  const SectionResult result = mesh(options_for(kWells));
  const std::string msh = text_of("a.msh", result);
  EXPECT_NE(msh.find("0 1 \"W1\"\n0 2 \"point_1\"\n0 3 \"point_2\"\n0 4 \"on the line\"\n"),
            std::string::npos);
  EXPECT_EQ(msh.find("name_W1"), std::string::npos) << "no group of lines";
  EXPECT_EQ(read_back("a.msh").face_slots(), result.mesh.face_slots());
  const std::string inp = text_of("a.inp", result);
  EXPECT_NE(inp.find("*NSET, NSET=W1\n"), std::string::npos);
  EXPECT_EQ(read_back("a.inp").edge_slots(), result.mesh.edge_slots());
  EXPECT_NE(text_of("a.vtu", result).find("<PointData>"), std::string::npos);
  EXPECT_EQ(read_back("a.vtu").face_slots(), result.mesh.face_slots());
}

TEST_F(Groups, PolygonsNameTheRegionsWithinThem) {
  const SectionResult result = mesh(options_for(kUnits));
  const auto zones = areas_of(result, kZoneTag);
  ASSERT_EQ(zones.size(), 3U);
  EXPECT_NEAR(zones.at("sand"), 1900, 1e-9);
  EXPECT_NEAR(zones.at("clay"), 1400, 1e-9);
  EXPECT_NEAR(zones.at("lens"), 200, 1e-9);
  const auto materials = areas_of(result, "material");
  EXPECT_NEAR(materials.at("quartz"), 1900, 1e-9);
  EXPECT_NEAR(materials.at("coal"), 200, 1e-9);
  EXPECT_NEAR(materials.at(""), 1400, 1e-9);
}

TEST_F(Groups, RegionsOfFilesComeBackAsTheyWere) {
  const SectionResult result = mesh(options_for(kUnits));
  const auto region = result.mesh.find_tag<FaceId, std::int32_t>("region");
  for (const char* const file : {"a.msh", "a.inp", "a.vtu"}) {
    const std::string text = text_of(file, result);
    EXPECT_NE(text.find("region"), std::string::npos) << file;
    const Mesh read = read_back(file);
    const auto again = read.find_tag<FaceId, std::int32_t>("region");
    std::map<std::int32_t, int> faces, faces_again;
    for (const FaceId f : result.mesh.faces()) ++faces[region[f]];
    for (const FaceId f : read.faces()) ++faces_again[again[f]];
    EXPECT_EQ(faces, faces_again) << file;
  }
}

TEST_F(Groups, NamesThatLookLikeThoseOfOtherGroupsGetAnEnding) {
  const SectionResult result = mesh(options_for(R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"name":"region_1"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[50,0],[50,60],[0,60],[0,0]]]}},
{"type":"Feature","properties":{"name":"material_x","material":"x"},"geometry":{"type":"Polygon","coordinates":[[[50,0],[90,0],[90,60],[50,60],[50,0]]]}},
{"type":"Feature","properties":{"name":"a\nb \"c\""},"geometry":{"type":"LineString","coordinates":[[10,10],[80,50]]}},
{"type":"Feature","properties":{"name":"line_2"},"geometry":{"type":"Point","coordinates":[20,40]}},
{"type":"Feature","properties":{"name":"Outer_Boundary"},"geometry":{"type":"Point","coordinates":[70,10]}}]})"));
  const std::string msh = text_of("a.msh", result), inp = text_of("a.inp", result);
  const auto count = [](const std::string& text, const std::string& part) {
    int times = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
    return times;
  };
  for (const char* const name : {"\"region_1\"", "\"region_1_2\"", "\"material_x_2\"", "\"line_2_2\"",
                                 "\"Outer_Boundary\"", "\"name_a b 'c'\""})
    EXPECT_EQ(count(msh, name), 1) << name;
  for (const char* const line :
       {"*ELSET, ELSET=region_1_2\n", "*ELSET, ELSET=material_x\n", "*ELSET, ELSET=material_x_2\n",
        "*NSET, NSET=line_2\n", "*NSET, NSET=line_2_2\n", "*NSET, NSET=outer_boundary\n",
        "*NSET, NSET=Outer_Boundary_2\n", "NAME=name_a_b__c_\n"})
    EXPECT_EQ(count(inp, line), 1) << line;
  for (const char* const file : {"a.msh", "a.inp"}) {
    const Mesh read = read_back(file);
    EXPECT_EQ(read.edge_slots(), result.mesh.edge_slots()) << file;
    EXPECT_EQ(places_of(read).size(), 2U) << file;
    std::map<std::int32_t, int> faces, faces_again;
    const auto region = result.mesh.find_tag<FaceId, std::int32_t>("region"),
               again = read.find_tag<FaceId, std::int32_t>("region");
    for (const FaceId f : result.mesh.faces()) ++faces[region[f]];
    for (const FaceId f : read.faces()) ++faces_again[again[f]];
    EXPECT_EQ(faces, faces_again) << file;
  }
}

TEST_F(Groups, SeedsNameRegionsBeforePolygonsDo) {
  SectionOptions options = options_for(kUnits);
  options.seed_points = {"70,15,the lens, seen again", "5,5,below"};
  const auto zones = areas_of(mesh(options), kZoneTag);
  EXPECT_NEAR(zones.at("the lens, seen again"), 200, 1e-9);
  EXPECT_NEAR(zones.at("below"), 1900, 1e-9);
  EXPECT_NEAR(zones.at("clay"), 1400, 1e-9);
}

TEST_F(Groups, SeedsThatNameNothingAreErrors) {
  SectionOptions options = options_for(kUnits);
  options.seed_points = {"15,15,hole"};
  EXPECT_NE(error_of(options).find("lies in no region"), std::string::npos) << error_of(options);
  options.seed_points = {"5,5,a", "45,35,b"};
  EXPECT_NE(error_of(options).find("no line parts them"), std::string::npos) << error_of(options);
  for (const char* const text : {"1,2", "1,2,", "1,x,name", "", "nan,1,name"}) {
    options.seed_points = {text};
    EXPECT_NE(error_of(options).find("X,Y,NAME"), std::string::npos) << text;
  }
}

TEST_F(Groups, ABoxHasFourSides) {
  const SectionResult result = mesh(options_for(kWells));
  const auto side = result.mesh.find_tag<EdgeId, std::int32_t>("box_side");
  const auto kind = result.mesh.find_tag<EdgeId, std::int32_t>("kind");
  std::array<double, 4> lengths{};
  for (const EdgeId e : result.mesh.edges()) {
    EXPECT_EQ(side[e] >= 0, kind[e] == kOuterBoundary);
    const auto [a, b] = result.mesh.edge_ends(e);
    if (side[e] >= 0)
      lengths.at(static_cast<std::size_t>(side[e])) += distance(result.mesh.point(a), result.mesh.point(b));
  }
  EXPECT_NEAR(lengths[0], 60, 1e-9);
  EXPECT_NEAR(lengths[1], 60, 1e-9);
  EXPECT_NEAR(lengths[2], 100, 1e-9);
  EXPECT_NEAR(lengths[3], 100, 1e-9);
  const std::string msh = text_of("a.msh", result);
  for (const char* const name : {"\"left\"", "\"right\"", "\"bottom\"", "\"top\""})
    EXPECT_NE(msh.find(name), std::string::npos) << name;
  const Mesh read = read_back("a.msh");
  EXPECT_EQ(read.edge_slots(), result.mesh.edge_slots()) << "sides are no lines of their own";
}

TEST_F(Groups, OutlinesThatAreNoBoxHaveNoSides) {
  const SectionResult result = mesh(options_for(kUnits));
  EXPECT_FALSE((result.mesh.find_tag<EdgeId, std::int32_t>("box_side").valid()));
}

TEST(BoundaryRule, ReadsMarginsOfBoxes) {
  EXPECT_EQ(parse_boundary("").kind, BoundaryRule::Kind::kDefault);
  EXPECT_EQ(parse_boundary("hull").kind, BoundaryRule::Kind::kHull);
  EXPECT_EQ(parse_boundary("box").margin, 0);
  EXPECT_EQ(parse_boundary("box:12.5").margin, 12.5);
  EXPECT_EQ(parse_boundary("box:5%").margin, 0.05);
  EXPECT_TRUE(parse_boundary("box:5%").margin_is_share);
  EXPECT_EQ(parse_boundary("a/box.geojson").kind, BoundaryRule::Kind::kFile);
  for (const char* const text : {"box:", "box:-1", "box:x", "box:%", "box:inf"})
    EXPECT_THROW((void)parse_boundary(text), Error) << text;
}

TEST_F(Groups, ALineOrPointThatIsNotAccountedForIsABug) {
  const SectionResult good = mesh(options_for(kWells));
  EXPECT_NO_THROW(require_all_told(good.lines, good.cleaned));
  EXPECT_NO_THROW(require_lines_kept(good.mesh, good.cleaned));
  CleanedLines bad = good.cleaned;
  bad.ledger[LineId(0U)].fate = LineFate::kDropped;
  EXPECT_THROW(require_all_told(good.lines, bad), Error) << "dropped, but with pieces";
  bad = good.cleaned;
  bad.ledger.push_back({});
  EXPECT_THROW(require_all_told(good.lines, bad), Error) << "one too many";
  bad = good.cleaned;
  bad.points[PointId(0U)].node = {};
  EXPECT_THROW(require_all_told(good.lines, bad), Error) << "a point without a reason";
  bad = good.cleaned;
  bad.lines.nodes[bad.lines.pieces[PieceId(0U)].from].x += 1;
  EXPECT_THROW(require_lines_kept(good.mesh, bad), Error) << "edges of another length";
}

}  // namespace
}  // namespace quarry
