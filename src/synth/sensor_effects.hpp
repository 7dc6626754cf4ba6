#pragma once

#include <cstdint>

#include "synth/render.hpp"

namespace facet {

/// Effects that several sensor models share. Depth in metres, 0 = missing.

/// Angle between the line of sight and the normal at every pixel [rad].
Image<float> incidence_angles(const Rendering& scene, const Camera& camera);

/// Removes readings that a second viewpoint `baseline_m` to the right does not see: a nearer point of the
/// row, displaced by its disparity, covers them.
void drop_hidden_from_right(float baseline_m, const Camera& camera, Image<float>& depth);

/// Depth where every outline is displaced by correlated noise of `sigma_px` pixels; smooth surfaces keep
/// their depth.
Image<float> displaced_outlines(const Image<float>& depth, const Image<float>& sigma_px, std::uint64_t seed);

/// Removes readings at random: a share everywhere, and all of them between 75 and 88 deg of incidence
/// increasingly.
void drop_readings(float share, const Image<float>& angles, std::uint64_t seed, Image<float>& depth);

/// A pixel with a neighbour more than 2 % nearer or farther within `radius_px` in its row or column.
Image<std::uint8_t> near_jump(const Image<float>& depth, int radius_px);

}  // namespace facet
