#include "shell/run.h"

#include "base/text.h"
#include "shell/hands.h"
#include "shell/layout.h"
#include "terminal/terminal.h"

#include <cyclone/fixedstep.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace demo {

namespace {

constexpr double FRAME_TIME = 1.0 / 30;  // s
constexpr real NEWS_TIME = 4;            // s
constexpr real LOOK_AT_END = 3;          // s, until a pilot who is done begins again
constexpr Colour NEWS{255, 224, 130}, QUIET{190, 200, 208}, ALARM{255, 150, 130};

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
          hands(d),
          before(s.getFrame()) {
        if (s.getDriver() == Driver::PILOT) say("the pilot has control until you touch one");
    }

    /// False once the user wants to leave.
    bool handle(Key key);
    void advance(real elapsed);
    const CellGrid &draw(int columns, int rows, real elapsed);

private:
    void takeControls();
    void say(const std::string &text);
    std::string getStatus() const;
    std::string getViewpoints() const;
    std::vector<std::string> getHelp() const;
    bool hasPilot() const { return session.getDriver() == Driver::PILOT; }
    /// Of text in a box.
    std::size_t boxColumns() const { return static_cast<std::size_t>(std::max(canvas.columns() - 4, 1)); }
    void printInstruments();
    void drawHorizon();
    void printWreck();
    void printNews();
    void printHelp();

    Session &session;
    Demonstration &demonstration;
    const Profile &profile;
    Stage stage;
    Canvas canvas;
    cyclone::FixedStep clock;
    Hands hands;
    Frame before;  ///< the moment before the last step
    bool paused = false;
    real overFor = 0;                         ///< s since the pilot was done
    std::size_t helpPage = 0, helpPages = 0;  ///< from 1; 0: no help. Of how many it was drawn.
    std::string news;
    real newsLeft = 0;  ///< s
};

bool Show::handle(Key key) {
    key = unshifted(key);
    if (key == keys::ESCAPE) return false;
    if (helpPage > 0) {  // any key
        helpPage = helpPage < helpPages ? helpPage + 1 : 0;
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
            helpPage = 1;
            break;
        case 't':
            if (hasPilot()) {
                takeControls();
            } else {
                session.givePilotControls();
                say("the pilot has control");
            }
            break;
        case 'v':
            hands.springBack = !hands.springBack;
            say(hands.springBack ? "sticks spring back" : "sticks stay where they are put");
            break;
        case 'r':
            takeControls();
            session.restart();
            stage.follow(session.getFrame());
            break;
        default:
            if (!hands.knows(key)) break;
            takeControls();
            hands.stroke(key);
    }
    return true;
}

void Show::takeControls() {
    if (session.getDriver() != Driver::HANDS) say("you have control; T gives it back");
    session.takeControls();
}

void Show::say(const std::string &text) {
    news = text;
    newsLeft = NEWS_TIME;
}

void Show::advance(real elapsed) {
    newsLeft -= elapsed;
    if (paused || helpPage > 0) return clock.reset();
    for (unsigned n = clock.advance(elapsed); n > 0; --n) {
        overFor = session.isOver() ? overFor + profile.step : 0;
        if (overFor > LOOK_AT_END && hasPilot()) session.restart();
        if (session.isOver() && !hasPilot()) takeControls();  // the script has ended
        if (session.getDriver() == Driver::HANDS) hands.advance(profile.step);
        before = session.getFrame();
        session.step();
        stage.follow(session.getFrame());
        for (const Event &event : session.takeEvents()) say(event.text);
    }
}

std::string Show::getStatus() const {
    const std::string driver = hasPilot()                              ? "PILOT"
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
                                              "Esc      leave"};
    lines.insert(lines.end(), general.begin(), general.end());
    if (std::any_of(profile.controls.begin(), profile.controls.end(),
                    [](const Control &control) { return control.springs; }))
        lines.push_back("V        sticks spring back, or stay");
    return lines;
}

/// Of one screen, or of a quarter of a small one.
void Show::printInstruments() {
    const std::vector<std::string> lines =
        broken(demonstration.getHeadUpLine(), static_cast<std::size_t>(canvas.columns()));
    const int most = std::max(canvas.rows() / 4, 1);
    for (int row = 0; row < std::min(static_cast<int>(lines.size()), most); ++row)
        canvas.print(0, row, lines[static_cast<std::size_t>(row)]);
}

/// At the right edge, above the last line, with the numbers below it.
void Show::drawHorizon() {
    const std::optional<Attitude> attitude = demonstration.getAttitude();
    if (!attitude || !demonstration.getWreck().empty()) return;
    const int rows = std::clamp(canvas.rows() / 5, 3, 9), columns = 3 * rows;
    const int left = canvas.columns() - columns, top = canvas.rows() - rows - 2;
    canvas.paste(left, top, paintHorizon(columns, 2 * rows, *attitude));
    const auto degrees = [](real angle) { return 180 / cyclone::REAL_PI * angle; };
    const std::string bank = fixed(std::fabs(degrees(attitude->bank)), 0);
    const std::string side = bank == "0" ? "" : attitude->bank < 0 ? " left" : " right";
    const std::string numbers = signedFixed(degrees(attitude->pitch), 0) + "° " + bank + "°" + side;
    canvas.print(canvas.columns() - static_cast<int>(fromUtf8(numbers).size()), top + rows, numbers);
}

/// Below the middle, where the wreck lies.
void Show::printWreck() {
    const std::string &wreck = demonstration.getWreck();
    if (wreck.empty()) return;
    std::vector<std::string> lines = broken(wreck, boxColumns());
    lines.push_back(hasPilot() ? "The pilot will try again." : "R to try again");
    canvas.printBox(lines, ALARM, canvas.rows() - static_cast<int>(lines.size()) - 4);
}

/// On the last line if there is room beside the status, else above it.
void Show::printNews() {
    const std::string status = getStatus();
    const int columns = canvas.columns(), length = static_cast<int>(status.size());
    canvas.print(std::max(columns - length, 0), -1, status, QUIET);
    if (newsLeft <= 0 || news == demonstration.getWreck()) return;  // the box says so
    const std::vector<std::string> lines = broken(news, static_cast<std::size_t>(columns));
    const bool fits = static_cast<int>(fromUtf8(news).size()) + 2 + length <= columns;
    int row = fits ? -1 : -1 - static_cast<int>(lines.size());
    for (const std::string &line : lines) canvas.print(0, row++, line, NEWS);
}

void Show::printHelp() {
    if (helpPage == 0) return;
    const auto rows = static_cast<std::size_t>(std::max(canvas.rows() - 4, 1));
    const auto pages = paginated(getHelp(), boxColumns(), rows);
    helpPages = pages.size();
    helpPage = std::min(helpPage, helpPages);
    std::vector<std::string> lines = pages[helpPage - 1];
    lines.push_back("");
    lines.push_back(helpPage < helpPages
                        ? "Any key for more, " + std::to_string(helpPage) + " of " + std::to_string(helpPages)
                        : "Any key goes on.");
    canvas.printBox(lines);
}

const CellGrid &Show::draw(int columns, int rows, real elapsed) {
    const Frame frame = interpolated(before, session.getFrame(), clock.getFraction());
    stage.draw(canvas, columns, rows, frame, elapsed);
    printInstruments();
    drawHorizon();
    printWreck();
    printNews();
    printHelp();
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
