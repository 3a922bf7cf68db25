#include "airrace/hoop.h"

namespace airrace {

namespace {

constexpr real RADIUS = 16, RUN_UP = 250;  // m

/// Each hoop faces half way between where one comes from and where one goes.
std::vector<Hoop> layOut(const std::vector<Vector3> &centres) {
    std::vector<Hoop> hoops;
    for (std::size_t n = 0; n < centres.size(); ++n) {
        const Vector3 here = centres[n], next = centres[(n + 1) % centres.size()],
                      last = centres[(n + centres.size() - 1) % centres.size()];
        Vector3 axis = (here - last).unit() + (next - here).unit();
        axis.y = 0;
        hoops.push_back({here, axis.unit(), RADIUS});
    }
    hoops.front().axis = Vector3::X;
    return hoops;
}

}  // namespace

Crossing cross(const Hoop &hoop, const Vector3 &from, const Vector3 &to) {
    const real before = (from - hoop.centre) * hoop.axis, after = (to - hoop.centre) * hoop.axis;
    Crossing crossing;
    if ((before < 0) == (after < 0)) return crossing;
    crossing.way = before < 0 ? Crossing::Way::FORWARDS : Crossing::Way::BACKWARDS;
    crossing.share = before / (before - after);
    crossing.offset = (from + (to - from) * crossing.share - hoop.centre).magnitude();
    return crossing;
}

const std::vector<Hoop> &getCourse() {
    static const std::vector<Hoop> course = layOut({{0, 50, 0},
                                                    {320, 50, 30},
                                                    {600, 80, 200},
                                                    {650, 95, 520},
                                                    {400, 70, 740},
                                                    {50, 40, 650},
                                                    {-250, 60, 480},
                                                    {-560, 60, 410},
                                                    {-780, 85, 170},
                                                    {-620, 65, -130},
                                                    {-290, 40, -60}});
    return course;
}

Vector3 getStart() { return getCourse().front().centre - Vector3(RUN_UP, 0, 0); }

}  // namespace airrace
