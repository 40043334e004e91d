// What people are told at the end of a job: a few lines on the standard error stream.
#pragma once

#include "kernels/quality/summary.hpp"
#include "pipeline/section/section.hpp"

namespace quarry::cli {

// What became of the lines: how many were kept, split, joined, clipped, dropped, and what else should be
// known.
void tell_lines(const SectionResult& result);

// Counts and quality.
void tell_quality(const QualitySummary& quality);

// Times and peak memory. With -v, every stage and the counts of insertion.
void tell_effort(const SectionResult& result, int threads);

}  // namespace quarry::cli
