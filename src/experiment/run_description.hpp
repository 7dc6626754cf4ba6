#pragma once

#include "experiment/data_lock.hpp"
#include "experiment/frame_work.hpp"
#include "experiment/plan.hpp"
#include "experiment/run_directory.hpp"
#include "record/manifest.hpp"

namespace facet {

/// Hash of everything that decides which results there are: the experiment and the selection of frames.
std::string config_hash(const Experiment& experiment, const RunOptions& options);

/// What tells whether rows of an earlier run are as good as new: configuration, program and back end. Results
/// are the same on every back end, their times are not.
RunIdentity make_identity(const Experiment& experiment, const RunOptions& options, const Plan& plan);

/// The manifest of a run that starts now.
Manifest make_manifest(const Experiment& experiment, const RunOptions& options, const Plan& plan,
                       const RunIdentity& identity);

/// manifest.json, config.resolved.yaml of the experiment as it is written, env.json; points `latest` at it.
void publish_description(const RunDirectory& directory, const Experiment& source, const Manifest& manifest);

/// dataset.lock.json: checksums of what was read.
void publish_lock(const RunDirectory& directory, const Plan& plan, const DataLock& lock);

}  // namespace facet
