#include "shell/run.h"

#include "terminal/terminal.h"

#include <cyclone/fixedstep.h>

#include <algorithm>
#include <chrono>

namespace demo {

namespace {

constexpr double FRAME_TIME = 1.0 / 30;  // s
constexpr real NEWS_TIME = 4;            // s
constexpr Colour NEWS{255, 224, 130}, QUIET{190, 200, 208};

/// '=' is '+' without Shift, and '_' is '-' with it.
Key unshifted(Key key) { return key == '=' ? U'+' : key == '_' ? U'-' : key; }

class Show {
public:
    Show(Session &s, Demonstration &d)
        : session(s),
          demonstration(d),
          profile(d.getProfile()),
          stage(d.getScene()),
          clock(profile.step),
          before(s.getFrame()) {
        if (s.getDriver() == Driver::PILOT) say("the pilot has control until you touch one");
    }

    /// False once the user wants to leave.
    bool handle(Key key);
    void advance(real elapsed);
    const CellGrid &draw(int columns, int rows, real elapsed);

private:
    void changeControl(Key key);
    void say(const std::string &text);
    std::string getStatus() const;
    std::string getViewpoints() const;
    std::vector<std::string> getHelp() const;

    Session &session;
    Demonstration &demonstration;
    const Profile &profile;
    Stage stage;
    Canvas canvas;
    cyclone::FixedStep clock;
    Frame before;  ///< the moment before the last step
    bool paused = false, help = false;
    std::string news;
    real newsLeft = 0;  ///< s
};

bool Show::handle(Key key) {
    key = unshifted(key);
    if (key == keys::ESCAPE) return false;
    if (help) {
        help = false;  // any key
        return true;
    }
    switch (key) {
        case 'c':
            stage.nextViewpoint();
            break;
        case 'f':
            stage.showForces = !stage.showForces;
            break;
        case '.':
            stage.zoom = std::min(stage.zoom * 1.25, 8.0);
            break;
        case ',':
            stage.zoom = std::max(stage.zoom / 1.25, 0.125);
            break;
        case 'p':
            paused = !paused;
            break;
        case 'h':
            help = true;
            break;
        case 't':
            if (session.getDriver() == Driver::PILOT) {
                session.takeControls();
                say("you have control");
            } else {
                session.givePilotControls();
                say("the pilot has control");
            }
            break;
        case 'r':
            session.takeControls();
            session.restart();
            break;
        default:
            changeControl(key);
    }
    return true;
}

void Show::changeControl(Key key) {
    if (key == profile.centre) {
        session.takeControls();
        demonstration.centreControls();
        return;
    }
    for (std::size_t n = 0; n < profile.controls.size(); ++n) {
        const Control &control = profile.controls[n];
        if (key != control.less && key != control.more) continue;
        if (session.getDriver() != Driver::HANDS) say("you have control; T gives it back");
        session.takeControls();
        demonstration.setControl(
            n, demonstration.getControl(n) + (key == control.more ? control.stroke : -control.stroke));
    }
}

void Show::say(const std::string &text) {
    news = text;
    newsLeft = NEWS_TIME;
}

void Show::advance(real elapsed) {
    newsLeft -= elapsed;
    if (paused || help) return clock.reset();
    for (unsigned n = clock.advance(elapsed); n > 0; --n) {
        if (session.isOver() && session.getDriver() == Driver::PILOT) session.restart();
        if (session.isOver()) session.takeControls();  // the script has ended
        before = session.getFrame();
        session.step();
        for (const Event &event : session.takeEvents()) say(event.text);
    }
}

std::string Show::getStatus() const {
    const std::string driver = session.getDriver() == Driver::PILOT    ? "PILOT"
                               : session.getDriver() == Driver::SCRIPT ? "SCRIPT"
                                                                       : "YOU";
    return (paused ? "PAUSED  " : "") + driver + "  " + Stage::getName(stage.viewpoint) + " camera  H help";
}

std::string Show::getViewpoints() const {
    std::string names;
    for (const Viewpoint viewpoint : demonstration.getScene().cameras.viewpoints)
        names += (names.empty() ? "" : ", ") + Stage::getName(viewpoint);
    return names;
}

std::vector<std::string> Show::getHelp() const {
    std::vector<std::string> lines = profile.help;
    const std::vector<std::string> general = {"",
                                              "T        the pilot takes over, or hands over",
                                              "R        restart",
                                              "C        camera: " + getViewpoints(),
                                              ". ,      closer, farther",
                                              "F        forces as arrows",
                                              "P        pause",
                                              "Esc      leave",
                                              "",
                                              "Any key goes on."};
    lines.insert(lines.end(), general.begin(), general.end());
    return lines;
}

const CellGrid &Show::draw(int columns, int rows, real elapsed) {
    const Frame frame = interpolated(before, session.getFrame(), clock.getFraction());
    stage.draw(canvas, columns, rows, frame, elapsed);
    canvas.print(0, 0, demonstration.getHeadUpLine());
    if (newsLeft > 0) canvas.print(0, -1, news, NEWS);
    const std::string status = getStatus();
    canvas.print(std::max(columns - static_cast<int>(status.size()), 0), -1, status, QUIET);
    if (help) canvas.printBox(getHelp());
    return canvas.cells();
}

}  // namespace

int runInteractive(Session &session, Demonstration &demonstration, const Still &still) {
    using Clock = std::chrono::steady_clock;
    Show show(session, demonstration);
    Photographer photographer(still, demonstration.getScene());
    bool leaving = false;
    Terminal terminal;
    Clock::time_point last = Clock::now();
    while (!leaving && terminal.isOpen()) {
        for (Key key; (key = terminal.readKey()) != keys::NONE;) leaving = leaving || !show.handle(key);
        const Clock::time_point now = Clock::now();
        const real elapsed = std::chrono::duration<real>(now - last).count();
        last = now;
        show.advance(elapsed);
        photographer.show(session.getFrame());
        terminal.show(show.draw(terminal.columns(), terminal.rows(), elapsed));
        terminal.wait(FRAME_TIME);
    }
    photographer.finish(session.getFrame());
    return terminal.exitStatus();
}

}  // namespace demo
