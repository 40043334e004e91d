// About how many elements a job of `quarry mesh` makes.
#pragma once

#include "pipeline/cli/mesh_arguments.hpp"

namespace quarry::cli {

// What is asked for, or what the input has room for, read for that; sizes by place are not looked at. Points
// of lines count as elements, too: they take work of their own. Throws Error.
[[nodiscard]] double foresee_elements(MeshArguments mesh);

// A guess without reading: from the bytes of the input.
[[nodiscard]] double elements_of_bytes(double bytes);

}  // namespace quarry::cli
