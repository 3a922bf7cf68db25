#include <cyclone/print.h>

#include <locale>
#include <ostream>
#include <sstream>
#include <string>

namespace cyclone {

namespace {

/// Without a locale; and it throws when memory runs out.
void makePlain(std::ios &stream) {
    stream.imbue(std::locale::classic());
    stream.exceptions(std::ios::badbit);
}

/// With so many digits.
std::string textOf(real number, int digits) {
    std::ostringstream text;
    makePlain(text);
    text.precision(digits);
    text << number;
    return text.str();
}

bool readsBackAs(real number, const std::string &text) {
    std::istringstream stream(text);
    makePlain(stream);
    real found = 0;
    return stream >> found && found == number;
}

std::string textOf(real number) {
    if (number != number) return "nan";
    for (int digits = 15; digits < 17; ++digits) {
        std::string text = textOf(number, digits);
        if (readsBackAs(number, text)) return text;
    }
    return textOf(number, 17);
}

std::string withSign(real number) {
    const std::string text = textOf(number);
    return text[0] == '-' ? text : '+' + text;
}

std::string textOf(const Vector3 &v) {
    return '(' + textOf(v.x) + ", " + textOf(v.y) + ", " + textOf(v.z) + ')';
}

std::string textOf(const Quaternion &q) {
    return textOf(q.r) + withSign(q.i) + 'i' + withSign(q.j) + 'j' + withSign(q.k) + 'k';
}

std::string textOfRows(const real *entries, int columns) {
    std::string text = "[";
    for (int n = 0; n < 3 * columns; ++n)
        text += (n == 0 ? "" : n % columns == 0 ? "; " : " ") + textOf(entries[n]);
    return text + ']';
}

}  // namespace

std::ostream &operator<<(std::ostream &stream, const Vector3 &v) { return stream << textOf(v); }

std::ostream &operator<<(std::ostream &stream, const Quaternion &q) { return stream << textOf(q); }

std::ostream &operator<<(std::ostream &stream, const Matrix3 &m) { return stream << textOfRows(m.data, 3); }

std::ostream &operator<<(std::ostream &stream, const Matrix4 &m) { return stream << textOfRows(m.data, 4); }

std::ostream &operator<<(std::ostream &stream, const RigidBody &body) {
    std::string mass = "immovable";
    if (body.hasFiniteMass()) mass = textOf(body.getMass()) + " kg";
    const char *const sleep = body.hasFaulted() ? ", faulted" : body.getAwake() ? "" : ", asleep";
    return stream << mass + " at " + textOf(body.getPosition()) + ", orientation " +
                         textOf(body.getOrientation()) + ", velocity " + textOf(body.getVelocity()) +
                         ", rotation " + textOf(body.getRotation()) + sleep;
}

}  // namespace cyclone
