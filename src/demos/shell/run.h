#pragma once

/// The two ways to run a session.
#include "picture/stage.h"
#include "shell/session.h"

#include <iosfwd>

namespace demo {

/// A picture to be taken on the way.
struct Still {
    std::ostream *out = nullptr;  ///< null: none
    real time = 0;                ///< s; if the run is shorter, at its end
    Viewpoint viewpoint = Viewpoint::SIDE;
    real zoom = 1;
};

/// Takes the picture, with the trails up to then.
class Photographer {
public:
    /// The scene must outlive the photographer.
    Photographer(const Still &still, const Scene &scene);

    /// Shows him a moment, in order; he takes the first that is not before the picture's time.
    void show(const Frame &frame);
    /// Takes this moment, the run's last, if he has taken none.
    void finish(const Frame &frame);

private:
    void take(const Frame &frame);

    Still still;
    Stage stage;
};

/// Runs to the end without a terminal, and prints a table with a line a second, the events and the report.
/// Without `seconds`: until the session is over, or for the profile's duration. Else that long: a pilot who
/// is done begins again. `progress`: for how far it is; may be null. Throws std::runtime_error if `out` can't
/// be written.
void runHeadless(Session &session, Demonstration &demonstration, std::optional<real> seconds,
                 const Still &still, std::ostream &out, std::ostream *progress);

/// Runs in the terminal until it is closed or the user leaves; returns the exit status.
int runInteractive(Session &session, Demonstration &demonstration, const Still &still);

}  // namespace demo
