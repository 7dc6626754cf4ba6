#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/sensor.hpp"
#include "method/backend.hpp"
#include "method/method.hpp"
#include "method/method_spec.hpp"
#include "prediction/predicted_parts.hpp"

namespace facet {

/// What a method is told about the data and the machine.
struct MethodContext {
  Sensor dataset_sensor = Sensor::kinect_v1;  ///< stands in where the parameters say `auto`
  std::uint64_t seed = 1;
  int threads = 1;                    ///< inside one frame
  std::filesystem::path folder = {};  ///< takes what a program leaves; empty: nothing is kept
  Backend backend = Backend::cpu;     ///< of the pipeline; other methods run on the CPU
};

/// What a run hands to a method before its first frame.
struct MethodFrames {
  const Dataset& dataset;
  std::vector<std::size_t> frames;  ///< of the data set that will be asked for
};

/// One kind of method: the card that `facet list methods` prints, and how to make one.
struct MethodKind {
  std::string_view name;
  std::string_view doc;          ///< one line
  std::string_view source;       ///< where the algorithm is from
  std::string_view licence;      ///< of what runs
  std::string_view folder = {};  ///< meaning of the key `folder`; empty: there is none
  bool computes_here = true;     ///< its times are measured; otherwise it has none, or those of a program
  bool has_stages = false;       ///< its times are those of the pipeline's stages too
  /// What it yields; nothing where only its predictions tell.
  std::optional<PredictedParts> (*yields)(const MethodSpec& spec);
  std::unique_ptr<Method> (*make)(const MethodSpec& spec, const MethodContext& context);
  /// Runs once per data set before its frames, where there is anything to do; null otherwise.
  void (*prepare)(const MethodSpec& spec, const MethodFrames& frames, const MethodContext& context) = nullptr;
  std::string_view absent = {};  ///< what this build lacks for it, and how to get that; empty: nothing
};

/// Every kind, in the order they are listed.
std::span<const MethodKind> method_kinds();

/// Throws Error{config} where no kind has that name.
const MethodKind& find_method_kind(const MethodSpec& spec);

/// Throws Error{not_measured} where this build lacks what the method needs.
void require_available(const MethodSpec& spec);

/// Throws Error{config} for an unknown kind or a parameter out of range, Error{not_measured} where this build
/// lacks what it needs.
std::unique_ptr<Method> make_method(const MethodSpec& spec, const MethodContext& context);

}  // namespace facet
