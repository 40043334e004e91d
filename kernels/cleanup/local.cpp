#include "kernels/cleanup/local.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/base/log.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/balance.hpp"
#include "kernels/cleanup/local_operation.hpp"

namespace quarry {
namespace {

constexpr const char* kFacesTag = "faces_of_vertex";
constexpr const char* kPriceTag = "price_of_vertex";

// The tags that the operators work with; the count of faces and the prices live as long as this.
class CountedTags {
 public:
  template <GeometryModel Model>
  CountedTags(Mesh& mesh, const Model& model, const IrregularPrice& price) : mesh_(mesh) {
    tags_.constraints = ConstraintTags::of(mesh);
    tags_.ideal = mesh.find_tag<VertexId, std::uint8_t>(kIdealTag);
    if (!tags_.ideal.valid()) tags_.ideal = set_ideal_faces(mesh, model);
    tags_.faces = mesh.add_tag<VertexId, std::uint16_t>(kFacesTag, 0);
    parallel::for_each(mesh.vertex_slots(), [&](std::size_t i) {
      const VertexId v(i);
      if (mesh.alive(v)) for_each_side_around(mesh, v, [&](SideId) { ++tags_.faces[v]; });
    });
    if (price) set_prices(price);
  }
  ~CountedTags() {
    mesh_.remove_tag<VertexId>(kFacesTag);
    if (tags_.price.valid()) mesh_.remove_tag<VertexId>(kPriceTag);
  }
  CountedTags(const CountedTags&) = delete;
  CountedTags& operator=(const CountedTags&) = delete;

  [[nodiscard]] const LocalTags& tags() const { return tags_; }

 private:
  void set_prices(const IrregularPrice& price) {
    tags_.price = mesh_.add_tag<VertexId, std::uint16_t>(kPriceTag, kPriceUnit);
    parallel::for_each(mesh_.vertex_slots(), [&](std::size_t i) {
      const VertexId v(i);
      if (!mesh_.alive(v)) return;
      const double units = std::clamp<double>(kPriceUnit * price(mesh_.point3(v)), 1, kHighestPrice);
      tags_.price[v] = static_cast<std::uint16_t>(std::lround(units));
    });
  }

  Mesh& mesh_;
  LocalTags tags_;
};

struct Irregular {
  std::uint64_t count = 0, energy = 0;
};

Irregular count_irregular(const Mesh& mesh, const LocalTags& tags) {
  return parallel::reduce_ordered(
      mesh.vertex_slots(), Irregular{},
      [&](std::size_t begin, std::size_t end) {
        Irregular sum;
        for (std::size_t i = begin; i < end; ++i) {
          const VertexId v(i);
          if (!mesh.alive(v)) continue;
          const int energy = valence_energy(tags.faces[v], tags.ideal[v]);
          sum.count += energy > 0 ? 1 : 0;
          sum.energy += static_cast<std::uint64_t>(energy);
        }
        return sum;
      },
      [](Irregular a, Irregular b) {
        return Irregular{a.count + b.count, a.energy + b.energy};
      });
}

template <GeometryModel Model>
class LocalCleanup {
 public:
  LocalCleanup(Mesh& mesh, const Model& model, const LocalTags& tags, const LocalCleanupOptions& options,
               const Progress& progress)
      : mesh_(mesh), model_(model), tags_(tags), options_(options), progress_(progress) {
#ifndef NDEBUG
    balance_ = balance_of(mesh, model);
#endif
  }

  // True if something was done.
  bool sweep(std::vector<LocalOperatorReport>& reports) {
    reports_ = &reports;
    at_ = 0;
    bool changed = run<DoubletRemoval>();
    changed = run<SingletOpening>() || changed;
    changed = run<FaceCollapse>() || changed;
    changed = run<EdgeRotation>() || changed;
    changed = run<VertexSplit>() || changed;
    return run<PairWalk>() || changed;
  }

 private:
  template <class Operator>
  bool run() {
    using Operation = LocalOperation<Model, Operator>;
    const Stopwatch watch;
    const Operation operation(model_, tags_, {.floor = options_.floor, .shape = {}}, options_.most_ways);
    const auto wanted = parallel::filter_indices(
        mesh_.vertex_slots(), [&](std::size_t i) { return operation.wants(mesh_, VertexId(i)); });
    std::vector<typename Operation::Item> work;
    work.reserve(wanted.size());
    for (const std::uint32_t v : wanted) work.push_back({VertexId(v), 0});
    PassOptions pass;
    pass.cutoff = 4;
    pass.reverse = options_.reverse;
    const PassReport done = run_pass(mesh_, operation, std::move(work), pass, progress_, claims_);

    if (reports_->size() == at_) reports_->emplace_back().pass.name = Operator::kName;
    LocalOperatorReport& report = (*reports_)[at_++];
    report.pass.add(done);
    report.won += operation.count(Verdict::kWon);
    report.invalid += operation.count(Verdict::kInvalid);
    report.poor += operation.count(Verdict::kPoor);
    report.seconds += watch.seconds();
    check(Operator::kName);
    return operation.count(Verdict::kWon) > 0;
  }

  void check([[maybe_unused]] const char* name) const {
#ifndef NDEBUG
    const std::string broken = find_imbalance(mesh_, model_, balance_);
    if (!broken.empty()) log::warn("after {}: {}", name, broken);
    assert(broken.empty());
#endif
  }

  Mesh& mesh_;
  const Model& model_;
  const LocalTags& tags_;
  const LocalCleanupOptions& options_;
  const Progress& progress_;
  std::vector<LocalOperatorReport>* reports_ = nullptr;
  std::size_t at_ = 0;
  Claims claims_;
#ifndef NDEBUG
  ModelBalance balance_;
#endif
};

}  // namespace

template <GeometryModel Model>
LocalCleanupReport clean_up_locally(Mesh& mesh, const Model& model, const LocalCleanupOptions& options,
                                    const Progress& progress) {
  const Stopwatch watch;
  const CountedTags counted(mesh, model, options.price);
  LocalCleanupReport report;
  const Irregular before = count_irregular(mesh, counted.tags());
  report.irregular_before = before.count;
  report.energy_before = before.energy;
  LocalCleanup<Model> cleanup(mesh, model, counted.tags(), options, progress);
  bool changed = true;
  while (changed && report.sweeps < options.most_sweeps) {
    progress.report("clean up", static_cast<double>(report.sweeps) / options.most_sweeps);
    changed = cleanup.sweep(report.operators);
    ++report.sweeps;
  }
  const Irregular after = count_irregular(mesh, counted.tags());
  report.irregular_after = after.count;
  report.energy_after = after.energy;
  report.seconds = watch.seconds();
  return report;
}

template LocalCleanupReport clean_up_locally(Mesh&, const PlaneModel&, const LocalCleanupOptions&,
                                             const Progress&);
template LocalCleanupReport clean_up_locally(Mesh&, const SpaceModel&, const LocalCleanupOptions&,
                                             const Progress&);

}  // namespace quarry
