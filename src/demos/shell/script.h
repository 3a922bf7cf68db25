#pragma once

/// Recorded inputs: a text that says which control has which value from which moment on.
///
///     # what follows a # is a comment
///     aircraft glider        the program's variant, where it has several; it must be the one that runs
///     seed 7                 the run's seed and settings, where given
///     wind 2.5
///     0 throttle 1           seconds, control, value
///     2.4 pitch 0.3
///     31 restart             back to the start
///     60 end                 the run ends here
#include "shell/demo.h"

#include <optional>

namespace demo {

struct Script {
    struct Change {
        std::uint64_t step = 0;  ///< takes effect before this step of the run, counted from 0
        std::size_t control = 0;
        real value = 0;
    };
    /// A Change of this control is a restart.
    static constexpr std::size_t RESTART = static_cast<std::size_t>(-1);

    std::optional<std::uint64_t> seed;
    std::vector<std::optional<real>> settings;  ///< one for each of the profile's
    std::vector<Change> changes;                ///< in order of their steps
    std::optional<std::uint64_t> end;           ///< in steps
};

/// Throws std::runtime_error with the number of the line and what is wrong with it.
Script readScript(const std::string &text, const Profile &profile);

/// Writes what readScript reads, to the last bit.
std::string writeScript(const Script &script, const Profile &profile);

}  // namespace demo
