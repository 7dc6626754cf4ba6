#pragma once

#include "pipeline/enum_names.hpp"
#include "study/ablation_plan.hpp"

namespace facet {

template <>
inline constexpr std::array<std::string_view, 4> enum_names<AblationDesign>{"leave_one_out", "one_in",
                                                                            "cumulative", "factorial"};

}  // namespace facet
