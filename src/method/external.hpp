#pragma once

#include <memory>

#include "method/registry.hpp"

namespace facet {

/// Anyone's program as a method. It is told where the depth image, the colour image and the intrinsics of a
/// frame are, and writes OUT.labels.png, and OUT.edges.png and OUT.surfaces.json if it has more (the format
/// of predictions). What it writes and says on its standard error is kept in the context's folder. A frame
/// fails, Error{data}, where the program exits with another status than 0, is killed by a signal, takes
/// longer than allowed (then its process group is killed), or writes no label image, a broken one, or one of
/// another size. The total time of a frame is the program's wall time, start and files included, of a batch
/// its share. Throws Error{config} where the command lacks a placeholder, Error{data} where the folder that
/// it runs in is missing.
std::unique_ptr<Method> make_external_method(const MethodSpec& spec, const MethodContext& context);

/// Where the program runs once per data set: hands it all frames, in folders, and runs it. Frames that cannot
/// be read are left out. What it has written when it fails is used; the frames without output fail. Does
/// nothing where it has run in the context's folder already, without failure and on as many frames.
void run_external_batch(const MethodSpec& spec, const MethodFrames& frames, const MethodContext& context);

}  // namespace facet
