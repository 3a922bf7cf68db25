#pragma once

/// Reference solutions that owe nothing to the library's step: tables from files, and a rigid body integrated
/// by the classic Runge-Kutta method.
#include <cyclone/core.h>
#include <gtest/gtest.h>

#include "random.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace reference {

using cyclone::Matrix3;
using cyclone::Quaternion;
using cyclone::real;
using cyclone::Vector3;

/// A file of numbers: comments begin with #, then come a line of the columns' names and the rows.
class Table {
public:
    explicit Table(const std::string &fileName) {
        std::ifstream file(std::string(CYCLONE_TEST_DATA) + "/" + fileName);
        for (std::string line; std::getline(file, line);) {
            if (line.empty() || line[0] == '#') continue;
            const std::vector<std::string> cells = split(line);
            if (columns.empty())
                for (const std::string &name : cells) columns.emplace(name, columns.size());
            else
                addRow(cells);
        }
        if (rows.empty()) ADD_FAILURE() << "no data in " << fileName;
    }

    std::size_t size() const { return rows.size(); }
    real get(std::size_t row, const std::string &column) const { return rows.at(row).at(columns.at(column)); }
    Vector3 getVector(std::size_t row, const std::string &x, const std::string &y,
                      const std::string &z) const {
        return Vector3(get(row, x), get(row, y), get(row, z));
    }

private:
    static std::vector<std::string> split(const std::string &line) {
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        return cells;
    }
    void addRow(const std::vector<std::string> &cells) {
        std::vector<real> numbers;
        for (const std::string &cell : cells) numbers.push_back(std::strtod(cell.c_str(), nullptr));
        rows.push_back(numbers);
    }

    std::map<std::string, std::size_t> columns;
    std::vector<std::vector<real>> rows;
};

/// Random bodies and motions.
class Random : public cyclone_test::Random {
public:
    explicit Random(std::uint64_t seed = 1) : cyclone_test::Random(seed) {}

    /// The logarithm is evenly distributed.
    real logBetween(real low, real high) { return std::exp(between(std::log(low), std::log(high))); }
    int below(int count) { return static_cast<int>(between(0, count)); }
    bool oneIn(int count) { return below(count) == 0; }
};

/// The largest difference between components, the sign of the quaternions being free.
inline real difference(const Quaternion &a, const Quaternion &b) {
    const real same =
        std::max({std::fabs(a.r - b.r), std::fabs(a.i - b.i), std::fabs(a.j - b.j), std::fabs(a.k - b.k)});
    const real opposite =
        std::max({std::fabs(a.r + b.r), std::fabs(a.i + b.i), std::fabs(a.j + b.j), std::fabs(a.k + b.k)});
    return std::min(same, opposite);
}
inline real difference(const Vector3 &a, const Vector3 &b) {
    return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)});
}
inline real difference(const Matrix3 &a, const Matrix3 &b) {
    real largest = 0;
    for (int n = 0; n < 9; ++n) largest = std::max(largest, std::fabs(a.data[n] - b.data[n]));
    return largest;
}

/// The turn by `angle` about a unit axis, by the C library's sine and cosine.
inline Quaternion turnAbout(const Vector3 &axis, real angle) {
    const real s = std::sin(angle / 2);
    return Quaternion(std::cos(angle / 2), axis.x * s, axis.y * s, axis.z * s);
}

/// The state of a rigid body; `spin` is its angular velocity in body axes.
struct Motion {
    Vector3 position, velocity;
    Quaternion orientation;
    Vector3 spin;

    /// From body to world: v·cos + (1 − cos)(n·v)n + sin(n × v), with the half angle's products.
    Vector3 toWorld(const Vector3 &v) const { return turn(v, 1); }
    Vector3 toBody(const Vector3 &v) const { return turn(v, -1); }

private:
    Vector3 turn(const Vector3 &v, real sign) const {
        const real w = orientation.r;
        const Vector3 n(sign * orientation.i, sign * orientation.j, sign * orientation.k);
        return (v * (w * w - n * n) + n * (2 * (n * v)) + (n % v) * (2 * w)) * (1 / (w * w + n * n));
    }
};

/// A force at the centre of mass and a torque about it, world coordinates.
struct Loads {
    Vector3 force, torque;
};

/// A body in principal axes and what acts on it.
struct System {
    real mass = 1;
    Vector3 inertia = Vector3(1, 1, 1);
    std::function<Loads(const Motion &)> loads = [](const Motion &) { return Loads(); };

    /// Newton's and Euler's equations by the classic Runge-Kutta method of fourth order.
    void advance(Motion &motion, real duration, int steps) const {
        const real h = duration / steps;
        for (int n = 0; n < steps; ++n) {
            const Motion a = rate(motion);
            const Motion b = rate(sum(motion, a, h / 2));
            const Motion c = rate(sum(motion, b, h / 2));
            const Motion d = rate(sum(motion, c, h));
            motion = sum(sum(sum(sum(motion, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
        }
    }

private:
    static Motion sum(const Motion &m, const Motion &rate, real h) {
        Motion result = m;
        result.position += rate.position * h;
        result.velocity += rate.velocity * h;
        result.orientation.r += rate.orientation.r * h;
        result.orientation.i += rate.orientation.i * h;
        result.orientation.j += rate.orientation.j * h;
        result.orientation.k += rate.orientation.k * h;
        result.spin += rate.spin * h;
        return result;
    }
    Motion rate(const Motion &m) const {
        const Loads acting = loads(m);
        const Vector3 torque = m.toBody(acting.torque), w = m.spin;
        const Quaternion &q = m.orientation;
        Motion result;
        result.position = m.velocity;
        result.velocity = acting.force * (1 / mass);
        result.orientation = Quaternion(-(q.i * w.x + q.j * w.y + q.k * w.z) / 2,  //
                                        (q.r * w.x + q.j * w.z - q.k * w.y) / 2,   //
                                        (q.r * w.y + q.k * w.x - q.i * w.z) / 2,   //
                                        (q.r * w.z + q.i * w.y - q.j * w.x) / 2);
        result.spin = Vector3((torque.x + (inertia.y - inertia.z) * w.y * w.z) / inertia.x,
                              (torque.y + (inertia.z - inertia.x) * w.z * w.x) / inertia.y,
                              (torque.z + (inertia.x - inertia.y) * w.x * w.y) / inertia.z);
        return result;
    }
};

/// Asks for an error below the bound, and puts it on record (--gtest_output=xml shows it).
inline void expectBelow(real error, real bound, const std::string &what) {
    std::ostringstream text;
    text << error;
    testing::Test::RecordProperty(what, text.str());
    EXPECT_LT(error, bound) << what;
}

/// Asks for an order of convergence, the lesser of the two that errors at the steps h, h/2, h/4 show.
inline void expectOrder(const real (&errors)[3], real least) {
    const real order = std::min(std::log2(errors[0] / errors[1]), std::log2(errors[1] / errors[2]));
    std::ostringstream text;
    text << order;
    testing::Test::RecordProperty("order", text.str());
    EXPECT_GE(order, least) << errors[0] << ' ' << errors[1] << ' ' << errors[2];
}

}  // namespace reference
