#include "kernels/cleanup/patch_report.hpp"

namespace quarry {

void PatchReport::add(const PatchReport& other) {
  seeds += other.seeds;
  searches += other.searches;
  stages += other.stages;
  grown_faces += other.grown_faces;
  found += other.found;
  proposals += other.proposals;
  duplicates += other.duplicates;
  waves += other.waves;
  commits.add(other.commits);
  for (std::size_t i = 0; i < kFillKinds; ++i) {
    proposed[i] += other.proposed[i];
    won[i] += other.won[i];
  }
  for (std::size_t i = 0; i < kPatchRejects; ++i) rejected[i] += other.rejected[i];
  search_seconds += other.search_seconds;
  commit_seconds += other.commit_seconds;
}

}  // namespace quarry
