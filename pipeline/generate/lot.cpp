#include "pipeline/generate/lot.hpp"

#include <cmath>
#include <numbers>

#include "pipeline/generate/portable_math.hpp"

namespace quarry {
namespace {

// Below it directions are uniform to within five digits, and the proposal would be a quotient of two small
// differences.
constexpr double kUniformKappa = 1e-5;
// A proposal is taken with a probability of 0.65 or more: this many fail once in 10^29 draws.
constexpr int kProposals = 64;

}  // namespace

double Lot::normal() {
  const double radius = std::sqrt(-2 * portable::log(1 - uniform()));
  return radius * portable::direction(2 * std::numbers::pi * uniform()).x;
}

PowerLaw::PowerLaw(double exponent, double shortest, double longest)
    : exponent_(exponent), shortest_(shortest), longest_(longest) {}

// Written with the ratio of the lengths, so that no power leaves the range of doubles where the lengths are
// very small or large.
double PowerLaw::draw(Lot& lot) const {
  const double u = lot.uniform(), power = 1 - exponent_, ratio = longest_ / shortest_;
  if (power == 0) return shortest_ * portable::power(ratio, u);
  const double reach = portable::power(ratio, power);
  return std::fmin(longest_, shortest_ * portable::power(1 + u * (reach - 1), 1 / power));
}

double PowerLaw::integral() const {
  const double power = 1 - exponent_, ratio = longest_ / shortest_;
  return power == 0 ? portable::log(ratio) : (portable::power(ratio, power) - 1) / power;
}

VonMises::VonMises(double kappa) : kappa_(kappa), proposal_(0) {
  if (kappa < kUniformKappa) return;
  const double tau = 1 + std::sqrt(1 + 4 * kappa * kappa);
  const double rho = (tau - std::sqrt(2 * tau)) / (2 * kappa);
  proposal_ = (1 + rho * rho) / (2 * rho);
}

Vec2 VonMises::draw(Lot& lot) const {
  if (kappa_ < kUniformKappa) return portable::direction(2 * std::numbers::pi * lot.uniform());
  double cosine = 1;
  for (int i = 0; i < kProposals; ++i) {
    const double z = portable::direction(std::numbers::pi * lot.uniform()).x;
    cosine = (1 + proposal_ * z) / (proposal_ + z);
    const double c = kappa_ * (proposal_ - cosine), u = 1 - lot.uniform();
    if (c * (2 - c) > u || portable::log(c / u) + 1 - c >= 0) break;
  }
  const double sine = std::sqrt(std::fmax(0.0, 1 - cosine * cosine));
  return {cosine, lot.uniform() < 0.5 ? -sine : sine};
}

}  // namespace quarry
