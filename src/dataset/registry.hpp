#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dataset/dataset.hpp"
#include "dataset/reader_options.hpp"

namespace facet {

/// Where a data set is and how to read it: one entry of an experiment's `datasets`.
struct DatasetSpec {
  std::string name;
  std::string reader;  ///< name of a reader, see readers()
  std::filesystem::path
      root;  ///< folder or, for benchmarks, a file; unused by readers that make their own frames
  Sensor sensor = Sensor::automatic;  ///< automatic: what the reader or the data set declares
  std::vector<std::string> frames;    ///< ids in the order to read them; empty = all
  std::vector<std::string> kinds;     ///< what each of `frames` shows, for tables; empty, or as many
  std::filesystem::path annotations;  ///< folder with ID.json and ID.objects.png; empty = as the reader finds
  ReaderOptions options;              ///< the names are those of ReaderInfo::options
};

struct DatasetReport;

/// One way to read data sets.
struct ReaderInfo {
  std::string_view name;
  std::string_view doc;  ///< one line
  std::span<const OptionInfo> options;
  bool needs_root;  ///< reads files below DatasetSpec::root
  std::unique_ptr<Dataset> (*open)(const DatasetSpec& spec);
  /// What `verify` adds for this reader (expected frames, checksums); null where there is nothing to add.
  void (*inspect)(const DatasetSpec& spec, DatasetReport& report);
  /// Whether a path may be of its layout: the first reader that says so reads it. Null where that cannot
  /// be seen.
  bool (*recognises)(const std::filesystem::path& path) = nullptr;
};

/// Every reader, in the order they are listed.
std::span<const ReaderInfo> readers();

/// Throws Error{config} naming the known readers where there is none of that name.
const ReaderInfo& find_reader(std::string_view name);

/// Opens a data set: checks the options, lists the frames, reads none of them. Throws Error{config} for a
/// wrong reader or option, Error{data} where the folder is missing or empty or a selected frame does not
/// exist.
std::unique_ptr<Dataset> open_dataset(const DatasetSpec& spec);

}  // namespace facet
