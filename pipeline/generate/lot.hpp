// What the drawn lines follow: lengths by a power law, directions of von Mises, normal deviates. Each draw is
// a function of the seed and of the number of the item that it is for, so that neither the number of threads
// nor the items before it matter, and has the same bits everywhere (portable_math.hpp).
#pragma once

#include <cstdint>

#include "engine/base/random.hpp"
#include "engine/geometry/vec.hpp"

namespace quarry {

// The random numbers of one item, one after the other.
class Lot {
 public:
  Lot(std::uint64_t seed, std::uint64_t item) : stream_(mix64(mix64(seed) ^ item)) {}

  // Uniform in [0, 1).
  double uniform() { return uniform01(stream_, next_++); }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  // Of mean 0 and variance 1 (Box & Muller 1958).
  double normal();

 private:
  std::uint64_t stream_;
  std::uint64_t next_ = 0;
};

// p(l) ~ l^-exponent between two lengths above 0, drawn by the inverse of its distribution.
class PowerLaw {
 public:
  PowerLaw(double exponent, double shortest, double longest);

  double draw(Lot& lot) const;
  // The integral of (l / shortest)^-exponent over all l / shortest: the weight of this law among others.
  [[nodiscard]] double integral() const;

 private:
  double exponent_, shortest_, longest_;
};

// Angles about 0 with density ~ e^(kappa cos), by rejection from a wrapped Cauchy law (Best & Fisher 1979).
class VonMises {
 public:
  // kappa: from 0 (any direction) on; 1 / sqrt(kappa) is about the standard deviation in radians.
  explicit VonMises(double kappa);

  // The unit vector (cos, sin) of such an angle.
  Vec2 draw(Lot& lot) const;

 private:
  double kappa_, proposal_;
};

}  // namespace quarry
