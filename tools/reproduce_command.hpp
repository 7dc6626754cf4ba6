#pragma once

#include <CLI/CLI.hpp>
#include <functional>

/// Adds `reproduce` to the program; where it was asked for it puts itself into `chosen`.
void add_reproduce_command(CLI::App& app, std::function<int()>& chosen);
