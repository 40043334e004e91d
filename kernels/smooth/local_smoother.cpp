#include "kernels/smooth/local_smoother_code.hpp"

namespace quarry {

template class LocalSmoother<PlaneModel>;
template class LocalSmoother<SpaceModel>;

}  // namespace quarry
