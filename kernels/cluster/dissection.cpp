#include "kernels/cluster/dissection.hpp"

#include <cassert>
#include <vector>

namespace quarry {
namespace {

using Table = std::vector<Dissection>;

Dissection joined(const Dissection& a, const Dissection& b) {
  Dissection sum = a;
  for (int i = 0; i < b.face_count; ++i)
    sum.faces[static_cast<std::size_t>(sum.face_count++)] = b.faces[static_cast<std::size_t>(i)];
  return sum;
}

Table product(const Table& a, const Table& b) {
  Table result;
  for (const Dissection& left : a)
    for (const Dissection& right : b) result.push_back(joined(left, right));
  return result;
}

// Dissections of the polygon of corners first .. last, whose last edge closes it; each begins with the face
// at that edge. Odd parts hold the one triangle, so that at most one of the parts beside a face may be odd.
Table cut(int first, int last, bool may_use_triangle) {
  const int corners = last - first + 1;
  if (corners == 2) return {Dissection{}};
  const bool odd = corners % 2 == 1;
  if (corners < 2 || (odd && !may_use_triangle)) return {};
  Table result;
  const auto place = [](int i) { return static_cast<std::uint8_t>(i); };
  const auto add = [&](std::array<std::uint8_t, 4> face, const Table& parts) {
    Dissection one;
    one.face_count = 1;
    one.faces[0] = face;
    for (const Dissection& part : parts) result.push_back(joined(one, part));
  };
  for (int a = first + 1; a < last; ++a) {
    if (odd && (a - first) % 2 == 1 && (last - a) % 2 == 1)
      add({place(first), place(a), place(last), Dissection::kNone},
          product(cut(first, a, false), cut(a, last, false)));
    for (int b = a + 1; b < last; ++b) {
      const int odd_parts = (a - first + 1) % 2 + (b - a + 1) % 2 + (last - b + 1) % 2;
      if (odd_parts > 1) continue;
      add({place(first), place(a), place(b), place(last)},
          product(product(cut(first, a, odd), cut(a, b, odd)), cut(b, last, odd)));
    }
  }
  return result;
}

Dissection two_triangles(std::array<std::uint8_t, 4> first, std::array<std::uint8_t, 4> second) {
  Dissection result;
  result.face_count = 2;
  result.faces[0] = first;
  result.faces[1] = second;
  return result;
}

void count_corners(Dissection& dissection) {
  for (int i = 0; i < dissection.face_count; ++i) {
    for (const std::uint8_t corner : dissection.faces[static_cast<std::size_t>(i)]) {
      if (corner == Dissection::kNone)
        ++dissection.triangle_count;
      else
        ++dissection.faces_at[corner];
    }
  }
}

std::array<Table, kMostPolygonCorners + 1> all_tables() {
  std::array<Table, kMostPolygonCorners + 1> tables;
  for (int corners = 4; corners <= kMostPolygonCorners; ++corners) {
    Table& table = tables[static_cast<std::size_t>(corners)];
    table = cut(0, corners - 1, true);
    if (corners == 4) {
      table.push_back(two_triangles({0, 1, 2, Dissection::kNone}, {2, 3, 0, Dissection::kNone}));
      table.push_back(two_triangles({1, 2, 3, Dissection::kNone}, {3, 0, 1, Dissection::kNone}));
    }
    for (Dissection& dissection : table) count_corners(dissection);
  }
  return tables;
}

}  // namespace

std::span<const Dissection> dissections(int corners) {
  static const std::array<Table, kMostPolygonCorners + 1> tables = all_tables();
  assert(corners >= 4 && corners <= kMostPolygonCorners);
  return tables[static_cast<std::size_t>(corners)];
}

}  // namespace quarry
