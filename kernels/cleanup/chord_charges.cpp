#include "kernels/cleanup/chord_charges.hpp"

#include "engine/parallel/parallel.hpp"
#include "kernels/cleanup/ideal.hpp"

namespace quarry {

SectorCharges::SectorCharges(const Mesh& cut_open) : charges_(cut_open.face_slots()) {
  const auto ideal = cut_open.find_tag<VertexId, std::uint8_t>(kIdealTag);
  parallel::for_each(cut_open.vertex_slots(), [&](std::size_t i) {
    const VertexId v(i);
    if (!cut_open.alive(v)) return;
    int charge = ideal[v];
    for_each_side_around(cut_open, v, [&](SideId) { --charge; });
    const auto kept = stored(charge);
    for_each_side_around(cut_open, v, [&](SideId s) {
      charges_[s.face().value()][static_cast<std::size_t>(s.index())] = kept;
    });
  });
}

}  // namespace quarry
