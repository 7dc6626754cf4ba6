#include "method/registry.hpp"

#include <array>
#include <string>

#include "core/error.hpp"
#include "method/pipeline_method.hpp"

namespace facet {

std::span<const MethodKind> method_kinds() {
  static constexpr std::array<MethodKind, 1> table{{
      {"pipeline", "the edge-based surface segmentation pipeline, in any of its modes", make_pipeline_method},
  }};
  return table;
}

std::unique_ptr<Method> make_method(const MethodSpec& spec, const MethodContext& context) {
  for (const MethodKind& kind : method_kinds())
    if (kind.name == spec.kind) return kind.make(spec, context);
  throw Error(ErrorKind::config, "method '" + spec.name + "': no kind is called '" + spec.kind + "'");
}

}  // namespace facet
