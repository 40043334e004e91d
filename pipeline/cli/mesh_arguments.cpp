#include "pipeline/cli/mesh_arguments.hpp"

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"
#include "io/number_text.hpp"
#include "pipeline/cli/irregular_price.hpp"
#include "pipeline/cli/mixed_quality.hpp"
#include "pipeline/cli/not_built.hpp"
#include "pipeline/cli/whole_number.hpp"

namespace quarry::cli {
namespace {

// The most that the engine's 32-bit numbers of sides can hold, with room for what is deleted on the way.
constexpr double kMostElements = 5e8;

// A number that is mistyped should not run for days.
constexpr int kMostAnnealingSweeps = 100'000;

// A check that says nothing in the help text, where the type already tells the values.
CLI::Validator one_of(std::vector<std::string> values) {
  return CLI::IsMember(std::move(values)).description("");
}

void add_shape_options(CLI::App& command, MeshArguments& arguments) {
  const auto option = [&](const char* name, auto& value, const char* type, const char* help) {
    return command.add_option(name, value, help)->type_name(type)->group("Elements");
  };
  option("--elements", arguments.elements, "quad|tri|mixed",
         "quad (default): quadrilaterals only; tri: triangles only; mixed: quadrilaterals, and two triangles "
         "in place of one that would be worse than --mixed-quality")
      ->check(one_of({"quad", "tri", "mixed"}));
  option("--mixed-quality", arguments.mixed_quality, "Q", kMixedQualityHelp)->check(CLI::Range(0.0, 1.0));
  option("--method", arguments.method, "deferred|front|blocks",
         "deferred (default): lines are worked into a start mesh; the others are not built yet")
      ->check(one_of({"deferred", "front", "blocks"}));
  option("--start", arguments.start, "4-8|delaunay|FILE",
         "the mesh that the lines are worked into; default 4-8: a lattice of right triangles, or delaunay "
         "with --quads matching");
  option("--orient", arguments.orient, "auto|DEGREES",
         "turns the start mesh counter-clockwise; auto: along the direction that the lines prefer; default "
         "auto, "
         "or 0 where the outline is the box of the lines");
  option("--preset", arguments.preset, "default|paper",
         "paper: constraint insertion as published (Araujo & Celes 2014), for comparison")
      ->check(one_of({"default", "paper"}));
  option("--fronts", arguments.section.fronts, "N",
         "alignment fronts go N steps away from the lines before triangles are paired; default 0, or 4 with "
         "--preset paper")
      ->check(CLI::Range(0, 100));
  option("--quads", arguments.quads, "cluster|matching|field",
         "how triangles become quadrilaterals: cluster halves every edge; matching keeps the edges of the "
         "triangles; field, on surfaces, halves those of rows of squares; default field on surfaces, else "
         "cluster")
      ->check(one_of({"cluster", "matching", "field"}));
  option(
      "--anneal", arguments.section.anneal, "N",
      "with --quads matching: N sweeps of annealing, reproducible by --seed, for fewer Steiner points where "
      "lines are few; default 0")
      ->check(CLI::Range(0, kMostAnnealingSweeps));
  option(
      "--cleanup", arguments.cleanup, "none|local|full|fewest",
      "topological clean-up: small changes, and patches of up to 512 faces (full) or of any size (fewest); "
      "default full, or none with --preset paper")
      ->check(one_of({"none", "local", "full", "fewest"}));
  add_irregular_price(command, arguments.section.irregular_price);
  command
      .add_flag("--keep-boundary", arguments.keep_boundary,
                "the vertices of the outline (of rims, on surfaces) are the boundary's: none added, none "
                "moved; with "
                "--quads matching or --elements tri")
      ->group("Elements");
}

void add_size_options(CLI::App& command, SizeOptions& sizes) {
  const auto option = [&](const char* name, auto& value, const char* type, const char* help) {
    return command.add_option(name, value, help)->type_name(type)->group("Sizes by place");
  };
  option("--size-field", sizes.file, "FILE",
         "wanted sizes: an ESRI ASCII raster (.asc), or text with x, y and a size a line; elsewhere --size, "
         "which "
         "is also the largest");
  option("--refine-near", sizes.near, "GROUP:H:DISTANCE",
         "elements of size H up to a distance from the lines of a group, growing from there; the groups are "
         "\"lines\" "
         "(all), each input file by its name without ending, and sets, names and materials of lines; may be "
         "given "
         "several times")
      ->allow_extra_args(false);
  option("--between-lines", sizes.between, "N",
         "where lines run close to each other, elements so small that about N fit between them");
  option("--gradation", sizes.gradation, "G", "growth of the size for each unit of distance; default 0.3");
  option("--smallest", sizes.smallest, "H",
         "no size below this is wanted anywhere; default a tenth of --size");
}

void add_output_options(CLI::App& command, MeshArguments& arguments) {
  const char* group = "Output";
  command.add_option("-o,--output", arguments.output, "the mesh to write: " + writable_mesh_formats())
      ->type_name("OUT")
      ->group(group);
  command
      .add_option("--report", arguments.report,
                  "counts, times, quality, the fate of each line, all options; JSON")
      ->type_name("FILE.json")
      ->group(group);
  command.add_option("--picture", arguments.picture, "a drawing of the mesh with its lines on top")
      ->type_name("FILE.svg|.png")
      ->group(group);
  command
      .add_option("--page", arguments.page,
                  "a page with a view that turns, and the quality; needs no network")
      ->type_name("FILE.html")
      ->group(group);
  add_mesh_output_options(command, arguments.written, group);
  command
      .add_option("--require", arguments.require,
                  "exit code 6, and no mesh, unless it is met; the figures stand below")
      ->delimiter(',')
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("FIGURE=LIMIT")
      ->group(group);
}

void add_surface_options(CLI::App& command, MeshArguments& arguments) {
  const char* group = "Surfaces";
  command
      .add_option(
          "--sharp", arguments.sharp,
          "edges across which the surface turns by so many degrees are kept; auto (default): from what the "
          "surface itself tells")
      ->type_name("auto|DEGREES")
      ->group(group);
  command
      .add_option("--curvature", arguments.curvature,
                  "where the surface is curved elements are so small that the middles of their edges lie no "
                  "farther from it than this")
      ->type_name("ERROR")
      ->group(group);
  command
      .add_option("--lines", arguments.lines,
                  "lines on or near the surface that become chains of edges; without heights they lie "
                  "where plumb lines meet the surface from above")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--weld", arguments.weld,
                  "points this near to one another become one; default 0: equal ones")
      ->check(CLI::NonNegativeNumber.description(""))
      ->type_name("D")
      ->group(group);
  command
      .add_option("--fill-holes", arguments.fill_holes,
                  "holes with at most N edges are closed; default 0: none")
      ->check(whole_number())
      ->type_name("N")
      ->group(group);
  command.add_option("--repaired", arguments.repaired, "the repaired surface is written here")
      ->type_name("FILE")
      ->group(group);
}

double parse_degrees(const std::string& text) {
  const std::optional<double> degrees = parse_finite(text);
  if (!degrees) throw Error(ErrorKind::kUsage, fmt::format("--orient {}: give degrees or auto", text));
  return *degrees;
}

void refuse_what_is_not_built(const MeshArguments& arguments) {
  if (arguments.method != "deferred") fail_not_built("--method " + arguments.method, "use deferred");
  if (arguments.quads == "field") fail_not_built("--quads field of lines", "use cluster or matching");
  const SectionOptions& section = arguments.section;
  if (!section.sizes.uniform() && section.start != StartMesh::kCrisscross)
    fail_not_built("sizes that differ by place, with this start mesh,", "use --start 4-8");
}

void fill_start(MeshArguments& arguments) {
  SectionOptions& section = arguments.section;
  section.orient_auto = arguments.orient == "auto";
  if (!section.orient_auto && !arguments.orient.empty())
    section.orient_degrees = parse_degrees(arguments.orient);
  // Right triangles merge into squares across one side alone: matching wants a choice.
  if (arguments.start.empty() && section.quads == QuadMethod::kMatching) section.start = StartMesh::kDelaunay;
  if (arguments.start.empty() || arguments.start == "4-8") return;
  section.start = arguments.start == "delaunay" ? StartMesh::kDelaunay : StartMesh::kFile;
  if (section.start == StartMesh::kFile) section.start_file = arguments.start;
}

}  // namespace

void add_line_options(CLI::App& command, SectionOptions& section) {
  const auto option = [&](const char* name, auto& value, const char* type, const char* help) {
    return command.add_option(name, value, help)->type_name(type);
  };
  option("inputs", section.inputs, "FILE",
         "lines or polygons: GeoJSON, Shapefile, WKT, CSV, FracPaQ, Triangle .poly, GOCAD .pl; by ogr2ogr, "
         "where it "
         "is installed, what GDAL knows; - is standard input");
  const char* place = "Coordinates";
  command.add_flag("--project", section.project, "degrees are projected to metres, in the local UTM zone")
      ->group(place);
  command.add_flag("--as-is", section.as_is, "degrees are taken for lengths")
      ->group(place)
      ->excludes("--project");
  option("--section", section.section, "x=VALUE|y=VALUE",
         "the lines that stand in this vertical plane; their coordinates are y (or x) and height")
      ->group(place);
  const char* group = "Lengths, in input units";
  option("--size", section.size, "H", "wanted length of an element's edge")->group(group);
  option("--snap", section.snap, "T",
         "what comes nearer is joined, and no vertex stays nearer to a foreign line; default 0.05 H")
      ->group(group);
  option("--min-edge", section.min_edge, "T", "shortest piece of a line that is kept; default 0.1 H")
      ->group(group);
  option("--tolerance", section.tolerance, "D",
         "largest distance of a cleaned line to its edges; default 0.05 H")
      ->group(group);
  option("--boundary", section.boundary, "FILE|hull|box[:MARGIN]",
         "the outline; default: polygons of the input, else its outermost closed lines if they hold all "
         "others, else "
         "the box of the lines. box:50 is wider by 50 on each side, box:5% by a share of its longer side");
}

void add_mesh_options(CLI::App& command, MeshArguments& arguments) {
  add_line_options(command, arguments.section);
  command.add_option("--count", arguments.section.count, "about how many elements, in place of --size")
      ->type_name("N")
      ->group("Lengths, in input units");
  command
      .add_option("--seed-point", arguments.section.seed_points,
                  "the region around this place is called NAME; may be given several times")
      ->type_name("X,Y,NAME")
      ->group("Groups");
  add_size_options(command, arguments.section.sizes);
  add_shape_options(command, arguments);
  add_surface_options(command, arguments);
  add_output_options(command, arguments);
  command
      .add_option("--max-elements", arguments.section.max_elements,
                  "a job that is predicted to need more is refused with exit code 5; default 2e8")
      ->type_name("N")
      ->group("Running");
  command
      .add_option("--seed", arguments.section.seed, "of what is drawn by lot; part of the result; default 0")
      ->check(whole_number())
      ->type_name("S")
      ->group("Running");
  add_common_options(command, arguments.common);
  command
      .add_option("--config", arguments.config,
                  "the same keys without dashes (inputs for the files); the command line wins")
      ->type_name("FILE.toml")
      ->group("Running");
}

void fill_section(MeshArguments& arguments) {
  SectionOptions& section = arguments.section;
  if (section.inputs.empty())
    throw Error(ErrorKind::kUsage, "no input file is given; see quarry mesh --help");
  if (arguments.output.empty()) throw Error(ErrorKind::kUsage, "no output is given: name it with -o OUT.vtu");
  if (arguments.curvature) throw Error(ErrorKind::kUsage, "--curvature is for surfaces; the input is lines");
  if (!arguments.lines.empty())
    throw Error(ErrorKind::kUsage, "--lines is for lines on a surface; give the files of lines as inputs");
  if (!(section.max_elements >= 1 && section.max_elements <= kMostElements))
    throw Error(ErrorKind::kUsage, fmt::format("--max-elements is {}: it must be from 1 to {:g}",
                                               section.max_elements, kMostElements));
  section.elements = arguments.elements == "tri"     ? Elements::kTriangle
                     : arguments.elements == "mixed" ? Elements::kMixed
                                                     : Elements::kQuad;
  section.mixed_quality = mixed_quality_of(arguments.elements, arguments.mixed_quality);
  section.preset = arguments.preset == "paper" ? Preset::kPaper : Preset::kDefault;
  section.keep_boundary = arguments.keep_boundary;
  if (arguments.keep_boundary && arguments.elements != "tri" && arguments.quads != "matching")
    throw Error(ErrorKind::kUsage, "--keep-boundary needs --quads matching: clusters halve every edge");
  section.quads = arguments.quads == "matching" ? QuadMethod::kMatching : QuadMethod::kCluster;
  if (section.anneal > 0 && (section.quads != QuadMethod::kMatching || !makes_quads(section)))
    throw Error(ErrorKind::kUsage, "--anneal needs quadrilaterals by --quads matching");
  fill_start(arguments);
  refuse_what_is_not_built(arguments);
  for (const std::string& near : section.sizes.near) (void)parse_near_group(near);
  if (!arguments.cleanup.empty()) section.cleanup = clean_up_level_of(arguments.cleanup);
  check_irregular_price(section.irregular_price, clean_up_level(section));
}

}  // namespace quarry::cli
