#include "method/registry.hpp"

#include <array>
#include <string>

#include "core/error.hpp"
#include "method/pipeline_method.hpp"
#include "method/stored_predictions.hpp"

namespace facet {

std::span<const MethodKind> method_kinds() {
  static constexpr std::array<MethodKind, 2> table{{
      {"pipeline", "the edge-based surface segmentation pipeline, in any of its modes", true,
       make_pipeline_method},
      {"predictions", "what any program has written into `folder`, in the format of the predictions", false,
       make_stored_predictions},
  }};
  return table;
}

const MethodKind& find_method_kind(const MethodSpec& spec) {
  for (const MethodKind& kind : method_kinds())
    if (kind.name == spec.kind) return kind;
  throw Error(ErrorKind::config, "method '" + spec.name + "': no kind is called '" + spec.kind + "'");
}

std::unique_ptr<Method> make_method(const MethodSpec& spec, const MethodContext& context) {
  return find_method_kind(spec).make(spec, context);
}

}  // namespace facet
