#pragma once

#include <filesystem>

#include "report/document.hpp"

namespace facet {

/// What became of the sequences of a run as films.
struct SequenceFilms {
  Report report;
  bool is_complete = true;  ///< every sequence of every method is a film
};

/// Joins the pictures that a run keeps of its sequences, in the order of time: per sequence and method the
/// film films/METHOD/DATASET.avi at the recorded rate (10 pictures per second where times are not known) and
/// the contact sheet DATASET.png beside it. Writes report/films.html and returns what that page says. Where
/// films cannot be written there are the sheets. Throws Error{not_measured} where the run has no sequence or
/// keeps no pictures of one.
SequenceFilms make_films(const std::filesystem::path& run);

}  // namespace facet
