// What people are told at the end of a job: a few lines on the standard error stream.
#pragma once

#include <vector>

#include "kernels/quality/summary.hpp"
#include "pipeline/section/section.hpp"

namespace quarry::cli {

// What became of the lines: how many were kept, split, joined, clipped, dropped, and what else should be
// known.
void tell_lines(const SectionResult& result);

// How many nodes of each class the cleaned lines have, and what was mended.
void tell_nodes(const SectionResult& result);

// Counts and quality; when: what stands before each line.
void tell_quality(const QualitySummary& quality, const char* when = "");

// The sum of the times, and peak memory. With -v, every stage.
void tell_times(const std::vector<StageTime>& times, int threads);

// The same of a section job; with -v, the counts of insertion as well.
void tell_effort(const SectionResult& result, int threads);

}  // namespace quarry::cli
