#pragma once

#include <gtest/gtest.h>
#include <string>

#include "core/error.hpp"

namespace facet {

/// Expects that `action` throws facet::Error of that kind whose message contains `part`.
template <class Action>
void expect_error(ErrorKind kind, const std::string& part, Action&& action) {
  try {
    action();
    ADD_FAILURE() << "no error; expected one with '" << part << "'";
  } catch (const Error& e) {
    EXPECT_EQ(static_cast<int>(e.kind()), static_cast<int>(kind)) << e.what();
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos)
        << "got: " << e.what() << "\nexpected: " << part;
  }
}

}  // namespace facet
