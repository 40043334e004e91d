#include "pipeline/cli/interrupt.hpp"

#include <csignal>

namespace quarry::cli {
namespace {

// Constant-initialised, so that a signal handler finds it ready at any time.
constinit CancellationToken token;

void on_signal(int) { token.cancel(); }

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // nohup has it ignored, and so it stays. Shells ignore SIGINT for what a script runs in the background,
    // but there it comes from someone who means this job.
    struct sigaction before {};
    if (signal == SIGHUP && sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN)
      continue;
    sigaction(signal, &action, nullptr);
  }
}

const CancellationToken& interrupt_token() { return token; }

}  // namespace quarry::cli
