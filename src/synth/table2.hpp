#pragma once

#include <vector>

#include "synth/families.hpp"

namespace facet {

/// A row of the paper's Table 2: what its scene holds.
struct Table2Row {
  std::string name;  ///< "boxes_1" ...
  std::string kind;  ///< the paper's words
  GraspCounts counts;
};

/// The eight rows: Boxes, Cylinders, Mixed LC and Mixed HC, two each.
const std::vector<Table2Row>& table2_rows();

/// A scene of ours with exactly the row's numbers of graspable objects, faces and edges, found by a seeded
/// search: objects are exchanged one by one, and a layout is accepted only where the counts derived from its
/// geometry, after the void rules, are those of the row, with no length or area within 3 % of a limit. In the
/// HC scenes at least half of the objects touch or hide another. Error{config} where `evaluations` layouts do
/// not suffice.
Layout table2_layout(const Table2Row& row, std::uint64_t seed, const Camera& camera, Size size,
                     int evaluations = 20000);

/// Share of the objects that come within 2 mm of another one, rest on one, or hide a part of one.
double interacting_share(const Layout& layout, const Rendering& exact);

}  // namespace facet
