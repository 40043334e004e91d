#include "pipeline/cli/summary_text.hpp"

#include <algorithm>
#include <array>

#include "engine/base/log.hpp"
#include "pipeline/report/job_report.hpp"

namespace quarry::cli {
namespace {

void tell_insertion(const SectionResult& result) {
  const DeferredReport& d = result.deferred;
  log::detail(
      "insertion: {} attractions, {} flips, {} splits, {} fallbacks, {} pieces rebuilt, at most {} tries",
      d.attractions, d.flips, d.splits, d.fallbacks, d.rebuilt, d.most_tries);
  for (const PassReport* pass : {&d.nodes, &d.pieces})
    log::detail("pass {}: {} rounds, {} proposed, {} won", pass->name, pass->rounds, pass->proposed,
                pass->won);
  log::detail("pairing: {} pairs, {} single triangles; {} left after recutting",
              result.quads.mixed.pairing.pairs, result.quads.mixed.pairing.singles,
              result.quads.subdivide.from_triangles);
}

void tell_points(const IdVector<PointId, PointEntry>& points) {
  if (points.empty()) return;
  std::size_t dropped = 0;
  double moved = 0;
  for (const PointEntry& entry : points) {
    dropped += entry.node.valid() ? 0U : 1U;
    moved = std::max(moved, entry.moved);
  }
  log::info("points: {} read, of which {} dropped; none moved more than {:.4g}", points.size(), dropped,
            moved);
}

}  // namespace

void tell_lines(const SectionResult& result) {
  std::array<std::size_t, 5> fates{};
  for (const LedgerEntry& entry : result.cleaned.ledger) ++fates.at(static_cast<std::size_t>(entry.fate));
  const auto count = [&](LineFate fate) { return fates.at(static_cast<std::size_t>(fate)); };
  log::info(
      "lines: {} read, of which {} kept as they are, {} split, {} joined, {} clipped, {} dropped; {} pieces",
      result.cleaned.ledger.size(), count(LineFate::kKept), count(LineFate::kSplit), count(LineFate::kJoined),
      count(LineFate::kClipped), count(LineFate::kDropped), result.cleaned.lines.pieces.size());
  tell_points(result.cleaned.points);
  log::info("outline: {}; no point of a line moved more than {:.4g}", result.outline.text,
            result.cleaned.counts.largest_move);
  for (const std::string& note : result.cleaned.notes) log::warn("{}", note);
}

void tell_nodes(const SectionResult& result) {
  const CleanCounts& counts = result.cleaned.counts;
  log::info("nodes: {} isolated (I), {} abutting (Y), {} crossing (X); {} on the outline (E)",
            counts.nodes.isolated, counts.nodes.abutting, counts.nodes.crossing, counts.nodes.edge);
  if (counts.duplicate_lines + counts.empty_segments + counts.cut_dangles > 0)
    log::info("mended: {} duplicate lines, {} segments of no length, {} dangling ends shorter than {:.4g}",
              counts.duplicate_lines, counts.empty_segments, counts.cut_dangles,
              result.cleaned.options.min_edge);
}

void tell_quality(const QualitySummary& quality, const char* when) {
  const ShapeSummary& q = quality.all;
  log::info("{}mesh: {} quads, {} triangles, {} vertices, {} line edges", when, quality.quads.faces,
            quality.triangles.faces, quality.vertices, quality.edges);
  log::info(
      "{}quality: scaled Jacobian min {:.3f}, mean {:.4f}, {:.3f}% below 0.2; smallest angle {:.2f} degrees, "
      "{:.1f}% "
      "in 80 to 90; longest by shortest edge at most {:.2f}; {:.2f}% of inner vertices irregular",
      when, q.scaled_jacobian.min, q.scaled_jacobian.mean, 100 * q.share(q.scaled_jacobian_below_0p2),
      q.min_angle.min, 100 * q.share(q.min_angle_histogram.back()), q.aspect.max,
      100 * quality.valence.irregular_share());
}

void tell_times(const std::vector<StageTime>& times, int threads) {
  double total = 0;
  for (const StageTime& stage : times) {
    log::detail("{:12} {:10.1f} ms, threads busy for {:3.0f} % of it", stage.name, 1e3 * stage.seconds,
                100 * stage.busy_share(threads));
    total += stage.seconds;
  }
  log::info("{:.2f} s on {} thread{}, peak memory {:.0f} MB", total, threads, threads == 1 ? "" : "s",
            static_cast<double>(peak_memory_bytes()) / 1e6);
}

void tell_effort(const SectionResult& result, int threads) {
  if (result.mesh.face_slots() > 0) tell_insertion(result);
  tell_times(result.times, threads);
}

}  // namespace quarry::cli
