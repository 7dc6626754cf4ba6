#pragma once

#include <array>
#include <string_view>

namespace facet {

/// A row of the paper's Table 2 as printed: what there is, what it found and what [19] found.
struct PaperScene {
  std::string_view kind;
  int objects, objects_found, objects_19;
  int surfaces, surfaces_found;
  int edges, edges_found, edges_19;
};
inline constexpr std::array<PaperScene, 8> paper_table2{{{"Boxes", 3, 3, 3, 6, 6, 17, 17, 14},
                                                         {"Boxes", 3, 3, 3, 8, 8, 20, 20, 17},
                                                         {"Cylinders", 3, 3, 3, 6, 6, 12, 12, 10},
                                                         {"Cylinders", 5, 5, 5, 10, 10, 20, 20, 19},
                                                         {"Mixed - LC", 6, 6, 6, 13, 13, 28, 28, 21},
                                                         {"Mixed - LC", 7, 7, 7, 13, 13, 28, 28, 22},
                                                         {"Mixed - HC", 11, 11, 11, 24, 24, 55, 53, 42},
                                                         {"Mixed - HC", 14, 14, 10, 22, 22, 49, 47, 33}}};
/// Of 102; the table's column of [19] by scene is not legible in the text we have.
inline constexpr int paper_surfaces_19 = 79;

}  // namespace facet
