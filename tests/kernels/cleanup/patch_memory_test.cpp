#include "kernels/cleanup/patch_memory.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"
#include "kernels/cleanup/ideal.hpp"
#include "kernels/cleanup/patch_search.hpp"
#include "tests/kernels/cleanup/patch_meshes.hpp"

namespace quarry {
namespace {

TEST(KeySet, HoldsWhatWasInsertedAndNothingElse) {
  KeySet set;
  EXPECT_FALSE(set.contains(mix64(1)));
  for (std::uint64_t i = 0; i < 5000; ++i) set.insert(mix64(i));
  for (std::uint64_t i = 0; i < 5000; ++i) EXPECT_TRUE(set.contains(mix64(i)));
  for (std::uint64_t i = 5000; i < 10000; ++i) EXPECT_FALSE(set.contains(mix64(i)));
  set.clear();
  for (std::uint64_t i = 0; i < 5000; ++i) EXPECT_FALSE(set.contains(mix64(i)));
}

TEST(KeyParts, HoldsWhatWasInsertedAtOnceAndNothingElse) {
  KeyParts set;
  std::vector<std::uint64_t> keys;
  for (std::uint64_t i = 0; i < 5000; ++i) keys.push_back(mix64(i));
  set.insert(keys);
  set.insert(mix64(5000));
  for (std::uint64_t i = 0; i <= 5000; ++i) EXPECT_TRUE(set.contains(mix64(i)));
  for (std::uint64_t i = 5001; i < 10000; ++i) EXPECT_FALSE(set.contains(mix64(i)));
}

TEST(PatchMemory, SignsNewFacesAndTheirNeighboursAnewAndNoOthers) {
  Mesh mesh = test::disk_of_quads(600, 3);
  PatchMemory memory;
  memory.begin_class(mesh);
  std::vector<std::uint64_t> before;
  for (const FaceId f : mesh.faces()) before.push_back(memory.signature(f));
  const FaceId made(17U);
  std::vector<VertexId> rim;
  for (int k = 0; k < 4; ++k) rim.push_back(mesh.corner(made, k));
  memory.renew(mesh, std::vector<FaceId>{made}, rim, 99);
  for (const FaceId f : mesh.faces()) {
    bool touches = false;
    for (int k = 0; k < 4; ++k)
      for (const VertexId v : rim) touches = touches || mesh.corner(f, k) == v;
    EXPECT_EQ(memory.signature(f) != before[f.value()], touches) << "face " << f.value();
  }
}

TEST(PatchMemory, KeepsSignaturesWithTheirFacesFromOneClassToTheNext) {
  Mesh mesh = test::disk_of_quads(600, 4);
  PatchMemory memory;
  memory.begin_class(mesh);
  const std::uint64_t first = memory.signature(FaceId(5U));
  memory.begin_class(mesh);
  EXPECT_EQ(memory.signature(FaceId(5U)), first);
}

// Memory must only spare work: a seed around which it finds nothing has nothing to be found.
TEST(PatchSearch, FindsSomethingWithMemoryWhereverItDoesWithout) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = test::disk_of_quads(600, seed);
    const PatchStars stars(mesh, {});
    PatchOptions options;
    options.largest = 64;
    PatchMemory memory, empty;
    memory.begin_class(mesh);
    empty.begin_class(mesh);
    PatchSearch learning(mesh, stars, memory, options);
    PatchSearch fresh(mesh, stars, empty, options);
    PatchReport with, without;
    std::uint64_t failed = 0;
    for (const VertexId v : mesh.vertices()) {
      if (!stars.irregular(v)) continue;
      learning.begin_chunk();  // what others find is no reason to find nothing
      const std::optional<PatchProposal> found = learning.find(v, with);
      memory.learn(learning.learned());
      fresh.begin_chunk();
      EXPECT_EQ(found.has_value(), fresh.find(v, without).has_value()) << "vertex " << v.value();
      failed += found ? 0 : 1;
    }
    EXPECT_GT(failed, 0U);
    EXPECT_LT(with.stages, without.stages);
  }
}

TEST(PatchSearch, LooksForARefusedPatchNoFurther) {
  Mesh mesh = test::disk_of_quads(600, 7);
  const PatchStars stars(mesh, {});
  PatchOptions options;
  options.largest = 32;
  PatchMemory memory;
  memory.begin_class(mesh);
  PatchSearch search(mesh, stars, memory, options);
  PatchReport report;
  for (const VertexId v : mesh.vertices()) {
    if (!stars.irregular(v)) continue;
    search.begin_chunk();
    const std::optional<PatchProposal> found = search.find(v, report);
    if (!found) continue;
    memory.refuse(found->key);
    search.begin_chunk();
    const std::optional<PatchProposal> other = search.find(v, report);
    EXPECT_TRUE(!other || other->key != found->key);
    return;
  }
  FAIL() << "nothing found at all";
}

}  // namespace
}  // namespace quarry
