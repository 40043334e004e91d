#include "kernels/cleanup/clean_up.hpp"

#include "engine/base/heap.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/geometry/model.hpp"
#include "engine/mesh/balance.hpp"
#include "engine/mesh/compact.hpp"
#include "engine/mesh/sectors.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "kernels/cleanup/node_slots.hpp"
#include "kernels/cleanup/patch_remesh.hpp"

namespace quarry {
namespace {

class CleanUp {
 public:
  CleanUp(Mesh& mesh, const NodedLines& lines, const CleanUpOptions& options, CleanUpReport& report,
          const Progress& progress)
      : mesh_(mesh), lines_(lines), options_(options), report_(report), progress_(progress), balance_(mesh) {}

  void run() {
    progress_.report("clean-up", 0);
    add_time(report_.smoothing_seconds, [&] { smooth_between(); });
    clean_up_locally(report_.local);
    if (options_.level != CleanUpLevel::kLocal) {
      remesh();
      clean_up_locally(report_.local_at_end);
    }
    add_time(report_.smoothing_seconds, [&] {
      report_.shape = sweep(options_.shape);
      SquareCornersOptions squaring = options_.square_corners;
      squaring.size = options_.size;
      report_.square_corners = square_corners(mesh_, lines_, squaring, progress_);
      report_.optimise = optimise_corners(mesh_, lines_, options_.optimise, progress_);
    });
  }

 private:
  // over_lines: sewn again where lines are to run through patches; else none.
  void open(const NodeSlots* over_lines = nullptr) {
    const ConstraintTags tags = ConstraintTags::of(mesh_);
    std::vector<std::uint8_t> nodes;
    if (over_lines != nullptr) nodes = find_regular_nodes(mesh_, tags, *over_lines);
    cut_open(mesh_, tags);
    if (over_lines != nullptr) sew_pieces(mesh_, tags, nodes);
    set_ideal_faces(mesh_, PlaneModel());
  }

  // Every operation leaves tombstones, and its new entities at the end.
  void close() {
    sew(mesh_, ConstraintTags::of(mesh_));
    mesh_.remove_tag<VertexId>(kIdealTag);
    balance_.check("sewing", mesh_, GeometryCheck::kNone);
    compact(mesh_, EntityOrder::kHilbert);
    give_back_freed_memory();
  }

  void clean_up_locally(LocalCleanupReport& report) {
    add_time(report_.local_seconds, [&] {
      open();
      report = quarry::clean_up_locally(mesh_, PlaneModel(), options_.local, progress_);
      close();
    });
  }

  void remesh() {
    const bool fewest = options_.level == CleanUpLevel::kFewest;
    const std::vector<std::size_t> classes =
        patch_classes(options_.patches.largest, fewest, mesh_.count_alive_faces());
    PatchOptions patches = options_.patches;
    if (patches.wanted_faces == 0) patches.wanted_faces = mesh_.count_alive_faces();
    if (fewest) {
      // The last pairs go only where counts may change by more.
      if (options_.patches.wanted_faces == 0) {
        patches.most_growth = 0.3;
        patches.most_shrinkage = 0.5;
      }
      patches.most_mean_loss = 1;
      patches.fewest_faces_of_large = patches.fewest_faces;
      patches.most_faces_of_large = patches.most_faces;
    }
    PatchMemory memory;
    for (std::size_t i = 0; i < classes.size(); ++i) {
      progress_.report("clean-up", static_cast<double>(i + 1) / static_cast<double>(classes.size() + 1));
      patches.largest = classes[i];
      if (!fewest && patches.largest > options_.thorough) patches.directions = 0;
      remesh_class(patches, memory);
      if (!fewest && hopeless(report_.patches.back())) break;
      if (i == 0) collapse_chords(patches, memory);
    }
    remesh_over_lines(patches);
    mesh_.remove_tag<FaceId>(kSignatureTag);
  }

  // What failed inside a cell may do over a line: these classes have a memory of their own.
  void remesh_over_lines(PatchOptions patches) {
    if (options_.over_lines == 0) return;
    const bool fewest = options_.level == CleanUpLevel::kFewest;
    const NodeSlots slots(lines_);
    PatchMemory memory;
    patches.over_lines = &slots;
    patches.directions = options_.patches.directions;
    for (const std::size_t size : patch_classes(options_.patches.largest, false, 0)) {
      if (size < options_.over_lines || (size > options_.over_lines && !fewest)) continue;
      patches.largest = size;
      remesh_class(patches, memory);
    }
  }

  void remesh_class(const PatchOptions& patches, PatchMemory& memory) {
    add_time(report_.patch_seconds, [&] {
      open(patches.over_lines);
      report_.patches.push_back(remesh_patches(mesh_, PlaneModel(), patches, memory, progress_));
      close();
    });
    add_time(report_.smoothing_seconds, [&] { smooth_between(); });
  }

  // Where a chord went nothing is as the memory knows it.
  void collapse_chords(const PatchOptions& patches, PatchMemory& memory) {
    ChordOptions options = options_.chords;
    options.wanted_faces = patches.wanted_faces;
    options.most_shrinkage = patches.most_shrinkage;
    options.least_jacobian = patches.least_jacobian;
    options.largest_edge_ratio = patches.largest_edge_ratio;
    options.price = patches.price;
    add_time(report_.chord_seconds, [&] {
      report_.chords = quarry::collapse_chords(mesh_, find_charges(), options, progress_);
      if (report_.chords.won == 0) return;
      mesh_.remove_tag<FaceId>(kSignatureTag);
      memory = PatchMemory();
      compact(mesh_, EntityOrder::kHilbert);
    });
    if (report_.chords.won > 0) add_time(report_.smoothing_seconds, [&] { smooth_between(); });
  }

  SectorCharges find_charges() {
    open();
    SectorCharges charges(mesh_);
    sew(mesh_, ConstraintTags::of(mesh_));
    mesh_.remove_tag<VertexId>(kIdealTag);
    return charges;
  }

  // Whether larger patches are not worth their time; of few seeds nothing can be said.
  [[nodiscard]] bool hopeless(const PatchReport& patches) const {
    constexpr std::uint64_t kFewSeeds = 1000;
    return patches.seeds >= kFewSeeds && static_cast<double>(patches.count_won()) <
                                             options_.least_yield * static_cast<double>(patches.seeds);
  }

  void smooth_between() { add(report_.between, sweep(options_.between)); }

  SweepReport sweep(ShapeOptions options) {
    options.size = options_.size;
    return optimise_shape(mesh_, lines_, options, progress_);
  }

  Mesh& mesh_;
  const NodedLines& lines_;
  const CleanUpOptions& options_;
  CleanUpReport& report_;
  const Progress& progress_;
  BalanceGuard balance_;
};

}  // namespace

const char* name_of(CleanUpLevel level) {
  switch (level) {
    case CleanUpLevel::kNone:
      return "none";
    case CleanUpLevel::kLocal:
      return "local";
    case CleanUpLevel::kFull:
      return "full";
    case CleanUpLevel::kFewest:
      break;
  }
  return "fewest";
}

CleanUpLevel clean_up_level_of(std::string_view name) {
  for (const CleanUpLevel level : {CleanUpLevel::kLocal, CleanUpLevel::kFull, CleanUpLevel::kFewest})
    if (name == name_of(level)) return level;
  return CleanUpLevel::kNone;
}

void clean_up(Mesh& mesh, const NodedLines& lines, const CleanUpOptions& options, CleanUpReport& report,
              const Progress& progress) {
  if (options.level != CleanUpLevel::kNone) CleanUp(mesh, lines, options, report, progress).run();
}

}  // namespace quarry
