#pragma once

/// The program around a demonstration: its command line, and its run with or without a terminal.
#include "shell/demo.h"

#include <functional>
#include <iosfwd>
#include <memory>

namespace demo {

/// What a demonstration can make instead of a run: `--name FILE` writes it.
struct Product {
    std::string name, help;
    std::function<void(std::ostream &)> write;
};

/// Does what the command line asks for, and returns the exit status: 0, 2 after a mistake (told in one line
/// on stderr), or 128 + the signal that ended a run in the terminal.
int runDemonstration(Demonstration &demonstration, int argc, const char *const argv[],
                     const std::vector<Product> &products = {});

/// The same for a program of several demonstrations: the command line's `--choice WORD` says which. `make` is
/// given one of the words.
int runDemonstration(const Choice &choice,
                     const std::function<std::unique_ptr<Demonstration>(const std::string &word)> &make,
                     int argc, const char *const argv[]);

}  // namespace demo
