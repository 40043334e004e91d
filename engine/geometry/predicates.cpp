#include "engine/geometry/predicates.hpp"
