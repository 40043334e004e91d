// Cleaning of raw line work on one thread and on two, or on those of bench/thread_counts.hpp, beside GEOS's
// SnapRoundingNoder on as many raw segments. Prints a table; for docs/results-cleaning.md, and the seconds by
// threads for docs/results-kernels.md.
//
//   linework_bench [REPEATS [LARGEST]]      LARGEST: the most raw segments, by default a million
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/geos_noder.hpp"
#include "bench/synthetic_network.hpp"
#include "bench/thread_counts.hpp"
#include "engine/base/heap.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry::bench {
namespace {

constexpr std::uint32_t kSizes[] = {10'000, 100'000, 1'000'000};
// The most that GEOS is given: it takes minutes for more.
constexpr std::uint32_t kMostForPeer = 100'000;

// A network and what it is cleaned with: lengths that follow the shortest fracture, as they follow the wanted
// edge of a mesh that is to show it.
struct Network {
  explicit Network(std::uint32_t count) : lines(draw_network(count, false)) {
    const double shortest = 0.7 * lines.box().longer_side() / std::sqrt(static_cast<double>(count));
    options = {.snap = 0.05 * shortest, .min_edge = 0.1 * shortest, .tolerance = 0.05 * shortest};
    outline = box_outline(lines, options.snap);
  }
  LineSet lines;
  CleanOptions options;
  Outline outline;
};

// Seconds by the wall, one a repeat.
struct Times {
  std::vector<double> peer;
  std::vector<std::vector<double>> own;  // by number of threads, in the order of thread_counts()
  std::size_t peer_pieces = 0;
  CleanCounts counts;
  std::size_t pieces = 0;
};

void time_peer([[maybe_unused]] const Network& network, [[maybe_unused]] Times& times) {
#ifdef QUARRY_GEOS_NODER
  if (network.lines.lines.size() > kMostForPeer) return;
  // Its cells reach as far from their middles as the snapping distance does.
  const GeosNoder noder(network.lines, 2 * network.options.snap);
  const Stopwatch watch;
  times.peer_pieces = noder.node();
  times.peer.push_back(watch.seconds());
#endif
}

void time_own(const Network& network, std::int64_t threads, std::vector<double>& seconds, Times& times) {
  parallel::with_threads(static_cast<int>(threads), [&] {
    const Stopwatch watch;
    const CleanedLines cleaned = clean_lines(network.lines, network.outline, network.options);
    seconds.push_back(watch.seconds());
    times.counts = cleaned.counts;
    times.pieces = cleaned.lines.pieces.size();
  });
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? std::nan("") : values[values.size() / 2];
}

// The median of the ratios of what was measured in the same repeat.
double median_ratio(const std::vector<double>& over, const std::vector<double>& under) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(over.size(), under.size()); ++i) ratios.push_back(over[i] / under[i]);
  return median(ratios);
}

std::string text_of(double value, int digits) {
  return std::isnan(value) ? "" : fmt::format("{:.{}f}", value, digits);
}

void print_row(const Network& network, const Times& times, const Times* smaller) {
  std::string row = fmt::format("| {} | {} | {} | {} |", network.lines.lines.size(), times.counts.crossings,
                                times.pieces, text_of(median(times.peer), 2));
  for (std::size_t i = 0; i < times.own.size(); ++i)
    row += fmt::format(" {:.3f} | {} | {} |", median(times.own[i]),
                       text_of(median_ratio(times.peer, times.own[i]), 1),
                       smaller == nullptr ? "" : text_of(median_ratio(times.own[i], smaller->own[i]), 1));
  std::printf("%s\n", row.c_str());
  std::fflush(stdout);
}

void run(int repeats, double largest) {
  const std::vector<std::int64_t> threads = thread_counts();
  std::vector<Network> networks;
  for (const std::uint32_t size : kSizes)
    if (size <= largest) networks.emplace_back(size);
  std::vector<Times> times(networks.size());
  for (Times& each : times) each.own.resize(threads.size());
  // In turn, so that other work on the machine meets all alike.
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t i = 0; i < networks.size(); ++i) {
      time_peer(networks[i], times[i]);
      for (std::size_t k = 0; k < threads.size(); ++k)
        time_own(networks[i], threads[k], times[i].own[k], times[i]);
    }
  }
  std::string head = "| raw segments | crossings | pieces | GEOS, s |";
  std::string rule = "|---|---|---|---|";
  for (const std::int64_t count : threads) {
    head += fmt::format(" {} thread{}, s | times as fast as GEOS | times the row above |", count,
                        count == 1 ? "" : "s");
    rule += "---|---|---|";
  }
  std::printf("%s\n%s\n", head.c_str(), rule.c_str());
  for (std::size_t i = 0; i < networks.size(); ++i)
    print_row(networks[i], times[i], i == 0 ? nullptr : &times[i - 1]);
}

}  // namespace
}  // namespace quarry::bench

int main(int count, char** values) {
  quarry::keep_freed_memory();
  quarry::bench::run(count > 1 ? std::atoi(values[1]) : 3, count > 2 ? std::atof(values[2]) : 1e6);
}
