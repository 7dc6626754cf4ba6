#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>

/// Adds `compare`, `gate` and `baseline` to the program. The one that was asked for puts itself into
/// `chosen`, to be called for its exit code.
void add_compare_commands(CLI::App& app, std::function<int()>& chosen);
