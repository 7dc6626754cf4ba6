#pragma once

#include "core/error.hpp"

/// Of a program that an error has ended.
inline int exit_code_of(facet::ErrorKind kind) {
  switch (kind) {
    case facet::ErrorKind::usage:
      return 2;
    case facet::ErrorKind::config:
      return 3;
    case facet::ErrorKind::data:
      return 4;
    case facet::ErrorKind::not_measured:
      return 6;
    default:
      return 70;
  }
}
