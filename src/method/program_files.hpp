#pragma once

#include <filesystem>

#include "dataset/dataset.hpp"
#include "method/external_params.hpp"

namespace facet {

/// A folder of its own for the life of the object, below the system's folder for temporary files.
class ScratchFolder {
 public:
  /// Throws Error{internal} where none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// What the placeholders of a command stand for: the files of one frame, or the folders of many.
struct ProgramFiles {
  std::filesystem::path depth, color, intrinsics, out;

  /// Folders below `folder`.
  static ProgramFiles folders_in(const std::filesystem::path& folder, const std::filesystem::path& out);
  /// The files of a frame in these folders, NAME.png and NAME.json; `out` without an ending.
  ProgramFiles of_frame(const std::string& name) const;
};

/// Writes what the command asks for into the files of a frame: depth as a 16-bit PNG in the unit of the
/// parameters, 0 = missing; colour as an 8-bit PNG, where the frame has it; the intrinsics as JSON {width,
/// height, fx, fy, cx, cy, depth_unit_m}. Throws Error{data} where depth does not fit into 16 bits.
void write_program_input(const Frame& frame, const ExternalParams& params, const ProgramFiles& files);

/// The command with its placeholders replaced, each as one word of the shell.
std::string filled_command(const ExternalParams& params, const ProgramFiles& files);

/// Throws Error{config} where the command is empty, or lacks {depth} or {out}.
void check_command(const ExternalParams& params, const std::string& method);

}  // namespace facet
