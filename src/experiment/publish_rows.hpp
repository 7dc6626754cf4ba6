#pragma once

#include <vector>

#include "experiment/experiment.hpp"
#include "experiment/run_directory.hpp"
#include "experiment/run_options.hpp"
#include "record/manifest.hpp"
#include "record/run_record.hpp"

namespace facet {

/// Writes frames.jsonl, metrics/frames.csv and metrics/summary.json of a run. `experiment` says which scores
/// are wanted.
void publish_rows(const RunDirectory& directory, const Experiment& experiment, const Manifest& manifest,
                  const std::vector<FrameRow>& rows);

/// Writes what follows from the rows of a study, metrics/ and timing/ ablation.json or sweep.json, from what
/// the run has stored. `experiment` as it is written, not expanded. Nothing for a run that is no study.
void publish_study(const RunDirectory& directory, const Experiment& experiment, Study study);

/// Counts of the manifest that follow from the rows.
void count_rows(const std::vector<FrameRow>& rows, Manifest& manifest);

}  // namespace facet
