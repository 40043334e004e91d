#include <memory>

#include "engine/base/log.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/vtu_writer.hpp"
#include "kernels/quality/face.hpp"
#include "kernels/quality/summary.hpp"
#include "pipeline/cli/commands.hpp"
#include "pipeline/section/section.hpp"

namespace quarry::cli {
namespace {

struct MeshArguments {
  SectionOptions section;
  std::string output;
  std::string elements = "quad", preset = "default", orient = "0";
  int threads = 0;
  bool verbose = false;
};

void run(const MeshArguments& arguments, const Progress& progress) {
  const SectionResult result = mesh_section(arguments.section, progress);
  MeshWriteOptions options;
  write_vtu(arguments.output, result.mesh, options);
  const QualitySummary quality = summarize_quality(result.mesh);
  for (const StageTime& stage : result.times) log::detail("{:12} {:8.1f} ms", stage.name, 1e3 * stage.seconds);
  const DeferredReport& d = result.deferred;
  log::detail("nodes {} pieces {} attractions {} taken {} flips {} splits {} fallbacks {} rebuilt {} most tries {}",
              result.cleaned.lines.nodes.size(), result.cleaned.lines.pieces.size(), d.attractions, d.taken, d.flips,
              d.splits, d.fallbacks, d.rebuilt, d.most_tries);
  log::detail("rounds {} + {}, proposed {} + {}, won {} + {}", d.nodes.rounds, d.pieces.rounds, d.nodes.proposed,
              d.pieces.proposed, d.nodes.won, d.pieces.won);
  log::detail("pairs {} singles {}", result.pairing.pairs, result.pairing.singles);
  const ShapeSummary& q = quality.all;
  log::info("{} faces, {} regions, scaled Jacobian min {:.3f} mean {:.4f}, below 0.2 {:.4f}%, irregular {:.2f}%, "
            "aspect {:.2f}, smallest angle {:.2f} (lines {:.2f}), 80-90 {:.1f}%",
            q.faces, result.regions, q.scaled_jacobian.min, q.scaled_jacobian.mean,
            100 * q.share(q.scaled_jacobian_below_0p2), 100 * quality.valence.irregular_share(), q.aspect.max,
            q.min_angle.min, result.cleaned.counts.smallest_angle, 100 * q.share(q.min_angle_histogram[8]));
}

}  // namespace

void add_mesh_command(CLI::App& program, const Progress& progress) {
  CLI::App* command = program.add_subcommand("mesh", "lines (2D section, trace map) -> mesh");
  const auto arguments = std::make_shared<MeshArguments>();
  SectionOptions& section = arguments->section;
  command->add_option("inputs", section.inputs, "GeoJSON files")->required();
  command->add_option("-o,--output", arguments->output, "the mesh to write")->required();
  command->add_option("--size", section.size, "wanted edge length, in input units");
  command->add_option("--count", section.count, "about how many elements");
  command->add_option("--snap", section.snap, "joins raw lines nearer than this");
  command->add_option("--min-edge", section.min_edge, "shortest piece kept");
  command->add_option("--tolerance", section.tolerance, "largest distance of a line to its edges");
  command->add_option("--boundary", section.boundary, "hull, box, or a file of rings");
  command->add_option("--elements", arguments->elements, "quad or tri")->check(CLI::IsMember({"quad", "tri"}));
  command->add_option("--preset", arguments->preset, "default or paper")->check(CLI::IsMember({"default", "paper"}));
  command->add_option("--threads", arguments->threads, "0: all cores");
  command->add_flag("-v", arguments->verbose, "tell more");
  command->callback([arguments, &progress] {
    if (arguments->verbose) log::set_level(log::Level::kVerbose);
    arguments->section.elements = arguments->elements == "tri" ? Elements::kTriangle : Elements::kQuad;
    arguments->section.preset = arguments->preset == "paper" ? Preset::kPaper : Preset::kDefault;
    parallel::with_threads(arguments->threads, [&] { run(*arguments, progress); });
  });
}

}  // namespace quarry::cli
