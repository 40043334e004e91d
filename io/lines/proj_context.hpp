// PROJ's objects with an owner, and quiet: what it cannot do is told by whoever asked for it.
#pragma once

#include <memory>

#include <proj.h>

namespace quarry {

struct ProjDeleter {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
  void operator()(PJ* object) const { proj_destroy(object); }
};
using ProjContext = std::unique_ptr<PJ_CONTEXT, ProjDeleter>;
using ProjObject = std::unique_ptr<PJ, ProjDeleter>;

// Without network: results depend on what is installed alone.
[[nodiscard]] inline ProjContext make_proj_context() {
  ProjContext context(proj_context_create());
  proj_log_level(context.get(), PJ_LOG_NONE);
  proj_context_set_enable_network(context.get(), 0);
  return context;
}

}  // namespace quarry
