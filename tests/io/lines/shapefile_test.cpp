// Shapefiles that shapelib writes.
#include <fstream>
#include <iterator>

#include <shapefil.h>

#include "tests/io/lines/line_files.hpp"

namespace quarry {
namespace {

struct Shape {
  int type;
  std::vector<int> starts;
  std::vector<double> x, y, z;
};

const Shape kTwoParts{SHPT_ARC, {0, 2}, {0, 1, 2, 3, 4}, {0, 1, 0, 1, 0}, {}};
// Two outer rings, clockwise, before the hole of the first.
const Shape kPolygons{SHPT_POLYGON,
                      {0, 5, 10},
                      {0, 0, 9, 9, 0, 20, 20, 29, 29, 20, 2, 3, 3, 2, 2},
                      {0, 9, 9, 0, 0, 0, 9, 9, 0, 0, 2, 2, 3, 3, 2},
                      {}};

class Shapefile : public LineFiles {
 protected:
  [[nodiscard]] std::string base(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(int type, const std::vector<Shape>& shapes) {
    const SHPHandle file = SHPCreate(base("map").c_str(), type);
    for (const Shape& s : shapes) {
      SHPObject* object = SHPCreateObject(s.type, -1, static_cast<int>(s.starts.size()), s.starts.data(),
                                          nullptr, static_cast<int>(s.x.size()), s.x.data(), s.y.data(),
                                          s.z.empty() ? nullptr : s.z.data(), nullptr);
      SHPWriteObject(file, -1, object);
      SHPDestroyObject(object);
    }
    SHPClose(file);
    return base("map.shp");
  }
  void write_table(const std::string& name, double aperture) {
    const DBFHandle table = DBFCreateEx(base("map").c_str(), nullptr);
    DBFAddField(table, "NAME", FTString, 20, 0);
    DBFAddField(table, "Aperture", FTDouble, 12, 4);
    DBFAddField(table, "set", FTInteger, 6, 0);
    DBFWriteStringAttribute(table, 0, 0, name.c_str());
    DBFWriteDoubleAttribute(table, 0, 1, aperture);
    DBFWriteIntegerAttribute(table, 0, 2, 7);
    DBFClose(table);
  }
  [[nodiscard]] static std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

TEST_F(Shapefile, PartsAreLinesWithTheAttributesOfTheirFeature) {
  const std::string path = write(SHPT_ARC, {kTwoParts});
  write_table("Fault A", 0.25);
  const LineSet lines = read_lines({path});
  ASSERT_EQ(lines.lines.size(), 2U);
  EXPECT_EQ(points_of(lines, 0), (Points{{0, 0}, {1, 1}}));
  EXPECT_EQ(points_of(lines, 1), (Points{{2, 0}, {3, 1}, {4, 0}}));
  for (const LineId id : IdRange<LineId>(2))
    EXPECT_EQ(lines.attributes_of(id), (LineAttributes{"Fault A", "7", "", 0.25}));
}

TEST_F(Shapefile, HolesFollowTheRingAroundThem) {
  const LineSet lines = read_lines({write(SHPT_POLYGON, {kPolygons})});
  ASSERT_EQ(lines.lines.size(), 3U);
  EXPECT_TRUE(lines.lines[LineId(0U)].polygon_ring);
  EXPECT_EQ(points_of(lines, 1)[0], (Vec2{2, 2}));
  EXPECT_TRUE(lines.lines[LineId(1U)].hole);
  EXPECT_EQ(points_of(lines, 2)[0], (Vec2{20, 0}));
  EXPECT_FALSE(lines.lines[LineId(2U)].hole);
}

TEST_F(Shapefile, HeightsAreRead) {
  Shape high = kTwoParts;
  high.type = SHPT_ARCZ;
  high.z = {5, 6, 7, -1e39, 9};
  const LineSet lines = read_lines({write(SHPT_ARCZ, {high})});
  EXPECT_EQ(lines.lines[LineId(0U)].heights, (std::vector<double>{5, 6}));
  EXPECT_TRUE(lines.lines[LineId(1U)].heights.empty());
}

TEST_F(Shapefile, TextsBecomeUtf8) {
  const std::string path = write(SHPT_ARC, {kTwoParts});
  const auto name = [&] { return read_lines({path}).attributes_of(LineId(0U)).name; };
  write_table("St\xF6rung", 1);
  EXPECT_EQ(name(), "St\xC3\xB6rung") << "by guess";
  save("ISO-8859-1", "map.cpg");
  EXPECT_EQ(name(), "St\xC3\xB6rung");
  save("no such code", "map.cpg");
  EXPECT_EQ(name(), "St?rung");
  // Writing a table removes the file that names its encoding.
  write_table("St\xC3\xB6rung", 1);
  save("UTF-8", "map.cpg");
  EXPECT_EQ(name(), "St\xC3\xB6rung");
  write_table("\x90\xA0", 1);
  save("866\r\n", "map.cpg");
  EXPECT_EQ(name(), "\xD0\xA0\xD0\xB0");
}

TEST_F(Shapefile, TheProjectionTellsDegreesFromMetres) {
  const std::string path = write(SHPT_ARC, {kTwoParts});
  const std::string degrees =
      R"(GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]])";
  EXPECT_EQ(read_lines({path}).systems[0], CoordinateSystem());
  save(degrees + "\n", "map.prj");
  EXPECT_EQ(read_lines({path}).systems[0], (CoordinateSystem{degrees, true}));
  save("PROJCS[\"UTM\"," + degrees +
           R"(,PROJECTION["Transverse_Mercator"],PARAMETER["Central_Meridian",33.0],UNIT["Meter",1.0]])",
       "map.prj");
  EXPECT_FALSE(read_lines({path}).systems[0].geographic);
}

TEST_F(Shapefile, ErrorsNameTheFileAndTheFeature) {
  EXPECT_MESSAGE(error_of("x", "alone.shp"), "no .shx");
  const std::string path = write(SHPT_ARC, {kTwoParts, {SHPT_ARC, {0}, {7}, {8}, {}}});
  EXPECT_MESSAGE(error_of_path(path), "feature 1: a line of one point at (7, 8)");
  save(bytes_of(path).substr(0, 150), "map.shp");
  EXPECT_MESSAGE(error_of_path(path), "map.shp");
  save("no table", "map.dbf");
  (void)write(SHPT_ARC, {kTwoParts});
  try {
    (void)read_lines({path});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_MESSAGE(error.message(), "map.dbf: no dBASE table");
  }
}

TEST_F(Shapefile, ATableThatEndsBeforeItsLastRecordIsAnError) {
  const std::string path = write(SHPT_ARC, {kTwoParts, kTwoParts});
  write_table("A", 1);
  const DBFHandle table = DBFOpen(base("map").c_str(), "rb+");
  DBFWriteStringAttribute(table, 1, 0, "B");
  DBFClose(table);
  const std::string whole = bytes_of(base("map.dbf"));
  const std::size_t record = 20 + 12 + 6 + 1, header = 32 + 3 * 32 + 1;
  save(whole.substr(0, header + 2 * record), "map.dbf");
  EXPECT_EQ(read_lines({path}).attributes_of(LineId(2U)).name, "B") << "without the mark of its end";
  save(whole.substr(0, header + 2 * record - 1), "map.dbf");
  try {
    (void)read_lines({path});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_MESSAGE(error.message(), "map.dbf: the file ends too early: 2 records are announced, and 1 are");
  }
}

TEST_F(Shapefile, SurvivesEveryTruncationAndChangedByte) {
  const std::string path = write(SHPT_POLYGON, {kPolygons});
  write_table("A", 1);
  for (const char* const part : {"map.shp", "map.shx", "map.dbf"}) {
    const std::string whole = bytes_of(base(part));
    const auto attempt = [&](const std::string& text) {
      save(text, part);
      try {
        (void)read_lines({path});
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kInput) << error.message();
      }
    };
    log::set_level(log::Level::kQuiet);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      attempt(whole.substr(0, i));
      for (const char byte : {'\0', '\x7f', '\xff'}) {
        std::string changed = whole;
        changed[i] = byte;
        attempt(changed);
      }
    }
    log::set_level(log::Level::kNormal);
    save(whole, part);
  }
}

}  // namespace
}  // namespace quarry
