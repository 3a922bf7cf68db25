#pragma once

/// What a player's keys do to the controls.
#include "shell/demo.h"

namespace demo {

/// A terminal tells when a key is struck, but not when it is let go. So sticks stay where strokes have put
/// them, unless they are to spring back: then a stick that no key has moved for a moment returns to neutral.
class Hands {
public:
    explicit Hands(Demonstration &d) : demonstration(d) {}

    bool springBack = false;

    /// Whether the key belongs to a control; stroke() moves it.
    bool knows(Key key) const;
    void stroke(Key key);

    /// `duration` s of the run's time pass.
    void advance(real duration);

private:
    Demonstration &demonstration;
    real sinceStroke = 0;  ///< s
};

}  // namespace demo
