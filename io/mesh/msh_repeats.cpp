#include "io/mesh/msh_repeats.hpp"

#include <algorithm>
#include <numeric>

#include "engine/parallel/sort.hpp"

namespace quarry {
namespace {

std::uint64_t key_of(VertexId a, VertexId b) {
  return (std::uint64_t{std::min(a, b).value()} << 32) | std::max(a, b).value();
}

// Calls visit(span of places) for each run of equal keys, the places ascending.
template <class Visit>
void for_each_run(std::vector<std::uint64_t> keys, const Visit& visit) {
  std::vector<std::uint32_t> places(keys.size());
  std::iota(places.begin(), places.end(), 0U);
  parallel::stable_sort_by_key(keys, places);
  for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
    while (end < keys.size() && keys[end] == keys[begin]) ++end;
    visit(std::span(places).subspan(begin, end - begin));
  }
}

}  // namespace

std::vector<std::uint8_t> find_repeated_faces(std::span<const FaceCorners> faces,
                                              std::span<const std::int32_t> regions) {
  std::vector<std::uint8_t> repeated(faces.size(), 0);
  std::vector<std::uint64_t> keys;
  keys.reserve(faces.size());
  for (const FaceCorners& face : faces) keys.push_back(key_of(face[0], face[2]));
  for_each_run(std::move(keys), [&](std::span<const std::uint32_t> run) {
    for (std::size_t i = 1; i < run.size(); ++i)
      for (std::size_t k = 0; k < i && repeated[run[i]] == 0; ++k)
        if (faces[run[k]] == faces[run[i]] && regions[run[k]] != regions[run[i]]) repeated[run[i]] = 1;
  });
  return repeated;
}

std::vector<std::uint8_t> find_needless_edges(std::span<const std::pair<VertexId, VertexId>> edges,
                                              std::span<const LineGroup> groups) {
  std::vector<std::uint8_t> needless(edges.size(), 0);
  std::vector<std::uint64_t> keys;
  keys.reserve(edges.size());
  for (const auto& [a, b] : edges) keys.push_back(key_of(a, b));
  for_each_run(std::move(keys), [&](std::span<const std::uint32_t> run) {
    const auto has = [&](auto... kinds) {
      return std::ranges::any_of(run, [&](std::uint32_t i) { return ((groups[i] == kinds) || ...); });
    };
    const bool line = has(LineGroup::kLine);
    const bool any = has(LineGroup::kLine, LineGroup::kOther, LineGroup::kExtra);
    for (const std::uint32_t i : run)
      if ((line && groups[i] == LineGroup::kExtra) || (any && groups[i] == LineGroup::kNone)) needless[i] = 1;
  });
  return needless;
}

}  // namespace quarry
