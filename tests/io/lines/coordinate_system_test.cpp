#include "io/lines/coordinate_system.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "tests/io/lines/line_files.hpp"

namespace quarry {
namespace {

class CoordinateSystems : public LineFiles {
 protected:
  LineSet line(const std::string& coordinates, const std::string& system = "") {
    const std::string crs =
        system.empty() ? "" : R"("crs":{"type":"name","properties":{"name":")" + system + R"("}},)";
    return read("{" + crs + R"("type":"LineString","coordinates":)" + coordinates + "}", "in.geojson");
  }
};

TEST_F(CoordinateSystems, GeojsonThatSaysNothingIsInDegreesIfItLooksSo) {
  const auto degrees = [&](const std::string& coordinates) {
    return line(coordinates).systems[0].geographic;
  };
  EXPECT_TRUE(degrees("[[33.80228,-17.16523],[35.52788,-9.2566]]"));
  EXPECT_TRUE(line("[[33.80228,-17.16523],[35.52788,-9.2566]]").systems[0].assumed);
  EXPECT_FALSE(degrees("[[0,0],[1,1]]")) << "near the origin";
  EXPECT_FALSE(degrees("[[2.95297,4.4016],[6.20364,5.33841]]")) << "near the origin for its extent";
  EXPECT_FALSE(degrees("[[50,50],[60,60]]")) << "whole numbers";
  EXPECT_FALSE(degrees("[[150.125,50.25],[151.5,51.875]]")) << "millimetres";
  EXPECT_FALSE(degrees("[[466000.28223,6691582.0992],[466001.71098,6691583.1]]")) << "beyond 180";
}

TEST_F(CoordinateSystems, DefinitionsAreComparedByWhatTheyMean) {
  EXPECT_TRUE(same_system("EPSG:3067", "urn:ogc:def:crs:EPSG::3067"));
  EXPECT_TRUE(same_system("EPSG:4326", "OGC:CRS84"));
  EXPECT_FALSE(same_system("EPSG:3067", "EPSG:32635"));
  EXPECT_FALSE(same_system("a grid of our own", "EPSG:32635"));
}

TEST_F(CoordinateSystems, HaveNamesByWhatTheyMean) {
  EXPECT_EQ(system_urn("EPSG:3067"), "urn:ogc:def:crs:EPSG::3067");
  EXPECT_EQ(system_urn("OGC:CRS84"), "urn:ogc:def:crs:OGC:1.3:CRS84");
  EXPECT_EQ(system_urn("a grid of our own"), "");
  EXPECT_EQ(system_urn(""), "");
  EXPECT_EQ(system_urn(R"(PROJCS["EUREF_FIN_TM35FIN",GEOGCS["GCS_ETRS_1989",DATUM["D_ETRS_1989",)"
                       R"(SPHEROID["GRS_1980",6378137.0,298.257222101]],PRIMEM["Greenwich",0.0],)"
                       R"(UNIT["Degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
                       R"(PARAMETER["False_Easting",500000.0],PARAMETER["False_Northing",0.0],)"
                       R"(PARAMETER["Central_Meridian",27.0],PARAMETER["Scale_Factor",0.9996],)"
                       R"(PARAMETER["Latitude_Of_Origin",0.0],UNIT["Meter",1.0]])"),
            "urn:ogc:def:crs:EPSG::3067");
}

TEST_F(CoordinateSystems, DegreesComeToTheZoneOfTheirMiddle) {
  // The tower of Pisa, and its place in zone 32N (EPSG's own method, to a millimetre).
  LineSet lines = line("[[10.396597,43.723057],[10.406597,43.723057]]", "urn:ogc:def:crs:OGC:1.3:CRS84");
  EXPECT_EQ(project_to_utm(lines, nullptr), "EPSG:32632 (WGS 84 / UTM zone 32N)");
  const Points& points = points_of(lines, 0);
  // A degree of longitude at this latitude, by the ellipsoid's radius of the parallel.
  const double latitude = 43.723057 * M_PI / 180, e2 = 0.00669437999014;
  const double parallel = 6378137 * std::cos(latitude) / std::sqrt(1 - e2 * std::pow(std::sin(latitude), 2));
  EXPECT_NEAR(std::hypot(points[1].x - points[0].x, points[1].y - points[0].y), parallel * 0.01 * M_PI / 180,
              0.5);
  EXPECT_NEAR(points[0].x, 612'508, 200);
  EXPECT_NEAR(points[0].y, 4'842'000, 2000);
}

TEST_F(CoordinateSystems, TheSouthHasZonesOfItsOwnAndLatitudeMayComeFirstByName) {
  LineSet lines = line("[[34.5,-13.1],[34.6,-13.2]]", "EPSG:4326");
  EXPECT_EQ(project_to_utm(lines, nullptr), "EPSG:32736 (WGS 84 / UTM zone 36S)");
  EXPECT_NEAR(points_of(lines, 0)[0].y, 10'000'000 - 13.1 * 110'600, 3000);
}

TEST_F(CoordinateSystems, LinesAcrossTheAntimeridianComeToAZoneBesideIt) {
  for (const auto& [coordinates, zone] :
       {std::pair("[[179.9,50.1],[-179.9,50.2]]", 60), std::pair("[[179.9,50.1],[-179.5,50.2]]", 1)}) {
    LineSet lines = line(coordinates, "OGC:CRS84");
    EXPECT_EQ(project_to_utm(lines, nullptr), "EPSG:326" + std::string(zone < 10 ? "0" : "") +
                                                  std::to_string(zone) + " (WGS 84 / UTM zone " +
                                                  std::to_string(zone) + "N)");
    EXPECT_LT(lines.box().width(), 50'000);
  }
}

TEST_F(CoordinateSystems, LinesTooWideForAZoneAreAnError) {
  for (const char* const coordinates : {"[[-30,10],[30,10]]", "[[-100,10],[100,10]]", "[[0,10],[41,10]]"}) {
    try {
      LineSet lines = line(coordinates, "OGC:CRS84");
      (void)project_to_utm(lines, nullptr);
      ADD_FAILURE() << coordinates;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_MESSAGE(error.message(), "the lines fit no zone; project them yourself");
    }
  }
  LineSet wide = line("[[2,10],[36,10]]", "OGC:CRS84");
  EXPECT_EQ(project_to_utm(wide, nullptr), "EPSG:32634 (WGS 84 / UTM zone 34N)");
}

TEST_F(CoordinateSystems, WhatHasNoPlaceInAPlaneIsAnError) {
  const auto error = [](LineSet lines) -> std::string {
    try {
      return project_to_utm(lines, nullptr);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::kInput);
      return e.message();
    }
  };
  EXPECT_MESSAGE(error(line("[[10,88],[11,89]]", "OGC:CRS84")), "no UTM zone");
  EXPECT_MESSAGE(error(line("[[10,40],[500,40]]", "OGC:CRS84")), "no UTM zone");
  LineSet two = read_lines({save(R"({"type":"LineString","coordinates":[[1,1],[2,2]]})", "a.geojson"),
                            save("lon,lat\n33.5,-10.5\n33.6,-10.6\n", "b.csv")});
  EXPECT_MESSAGE(error(two), "a.geojson: does not say");
}

}  // namespace
}  // namespace quarry
