#pragma once

/// What a run leaves behind, and the page that plays it back.
///
/// Make a Recording of what is to be seen, append a frame some thirty times a second, write the page at the
/// end.
#include "picture/scene.h"

#include <iosfwd>
#include <utility>

namespace demo {

/// A quantity to plot. Channels that name the same panel are drawn in it together, on one axis: give them one
/// unit.
struct Channel {
    std::string name, unit, panel;
};

/// What stays the same throughout a run.
struct Subject {
    std::string title;
    std::string kind;  ///< a word or two above the title, such as "flight"
    Scene scene;
    std::vector<Channel> channels;
};

/// A run: its subject, its frames, its events and, once it is over, a summary in plain lines: "name: value"
/// becomes a row of a table, any other line a paragraph. What doesn't fit the subject or isn't finite throws
/// std::invalid_argument and leaves the recording as it was.
class Recording {
public:
    /// The subject needs at least one body, and each body a part.
    explicit Recording(Subject subject);

    /// One value for each channel, in their order. Times must advance.
    void append(Frame frame, const std::vector<real> &values);
    void addEvent(real time, std::string text);
    void setSummary(std::string text) { summary = std::move(text); }

    const Subject &getSubject() const { return subject; }
    const std::vector<Frame> &getFrames() const { return frames; }
    /// A channel's values, one for each frame.
    const std::vector<real> &getValues(std::size_t channel) const { return columns[channel]; }
    const std::vector<Event> &getEvents() const { return events; }
    const std::string &getSummary() const { return summary; }

private:
    Subject subject;
    std::vector<Frame> frames;
    std::vector<std::vector<real>> columns;  ///< of each channel
    std::vector<Event> events;
    std::string summary;
};

/// Writes one self-contained HTML page; the stream's state says whether it could be written. Positions in it
/// are true to a millimetre (5 m or less from the body), orientations to 0.01°, times to 10 µs in the first
/// minute, a channel to 1/100 000 of its range. Throws std::invalid_argument when no frame was recorded.
void writePage(std::ostream &out, const Recording &recording);

}  // namespace demo
