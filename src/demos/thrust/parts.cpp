#include "thrust/parts.h"

#include "base/random.h"
#include "picture/solids.h"

namespace thrust {

namespace {

constexpr Colour HULL{235, 240, 248}, WINDOW{90, 200, 250}, FIN{240, 120, 60}, FLAME{255, 190, 60},
    CORE{255, 245, 200}, POD{120, 235, 140}, BAND{40, 110, 70}, ROD{190, 205, 220}, ROCK{112, 88, 128},
    DEEP{70, 56, 84}, EDGE{215, 180, 255}, STAR{150, 160, 190};
constexpr int STARS = 250;
constexpr real STARS_BEYOND = 40, STARS_Z = -8;                     // m
constexpr real THICKNESS = 0.5, NOZZLE = -0.8, FLAME_LENGTH = 1.6;  // m
constexpr real POINTER_AWAY = 2.8;                                  // m, from the ship
constexpr real ROCK_FRONT = 0.8, ROCK_BACK = -4, EDGE_WIDTH = 0.25,
               EDGE_OVERLAP = 0.08;  // m; z of the rock's faces

/// A flat solid about the plane z = 0; corners counter-clockwise seen from +Z, convex.
void addPlate(Part &part, const std::vector<Vector3> &corners, real thickness, Colour colour) {
    const auto ring = [&](real z) {
        std::vector<Vector3> lifted(corners.rbegin(), corners.rend());
        for (Vector3 &corner : lifted) corner.z = z;
        return lifted;
    };
    addLoft(part, {ring(-thickness / 2), ring(thickness / 2)}, colour);
}

Part makeHull() {
    Part part;
    part.name = "hull";
    part.twoSided = true;
    const std::vector<Vector3> &s = Ship::getSilhouette();
    addPlate(part, {s[0], s[1], s[2], s[4], s[5], s[7], s[8]}, THICKNESS, HULL);
    addPlate(part, {{0.75, -0.2, 0}, {0.75, 0.2, 0}, {0.3, 0.3, 0}, {0.3, -0.3, 0}}, 1.2 * THICKNESS, WINDOW);
    return part;
}

Part makeFin(const std::string &name, std::size_t root, std::size_t tip, std::size_t end) {
    Part part;
    part.name = name;
    part.twoSided = true;
    const std::vector<Vector3> &s = Ship::getSilhouette();
    addPlate(part, {s[root], s[tip], s[end]}, THICKNESS, FIN);
    return part;
}

/// Its tip at the nozzle; pushed out of the hull as the engine burns.
Part makeFlame() {
    Part part;
    part.name = "flame";
    part.twoSided = true;
    addPlate(part, {{0, 0.25, 0}, {-FLAME_LENGTH, 0, 0}, {0, -0.25, 0}}, 0.2, FLAME);
    addPlate(part, {{0, 0.12, 0}, {-FLAME_LENGTH / 2, 0, 0}, {0, -0.12, 0}}, 0.3, CORE);
    return part;
}

std::vector<Vector3> makeRing(const Vector3 &middle, real radius) {
    std::vector<Vector3> corners;
    for (int n = 0; n < 10; ++n) {
        const real angle = 2 * cyclone::REAL_PI * n / 10;
        corners.push_back(middle + Vector3(cyclone::real_cos(angle), cyclone::real_sin(angle), 0) * radius);
    }
    return corners;
}

Part makePod() {
    Part part;
    part.name = "pod";
    part.twoSided = true;
    addPlate(part, makeRing(Vector3(), Ship::POD_RADIUS), THICKNESS, POD);
    addPlate(part, makeRing(Vector3(), 0.5 * Ship::POD_RADIUS), 1.2 * THICKNESS, BAND);
    return part;
}

Part makeRod() {
    Part part;
    part.name = "rod";
    part.twoSided = true;
    addBar(part, {Ship::POD_RADIUS, 0, 0}, {Ship::ROD_LENGTH, 0, 0}, 0.12, ROD);
    addPlate(part, makeRing({Ship::ROD_LENGTH, 0, 0}, 0.25), 0.3, POD);
    return part;
}

Part makePointer() {
    Part part;
    part.name = "pointer";
    part.twoSided = true;
    addPlate(part, {{0.9, 0, 0}, {-0.9, 0.6, 0}, {-0.5, 0, 0}}, 0.1, POD);
    addPlate(part, {{0.9, 0, 0}, {-0.5, 0, 0}, {-0.9, -0.6, 0}}, 0.1, POD);
    return part;
}

/// Along `direction`, which lies in the plane.
Quaternion towards(const Vector3 &direction) {
    return Quaternion::fromAxisAngle(Vector3::Z, cyclone::real_atan2(direction.y, direction.x));
}

/// Beside the ship, on the way to the ring, and with the pod to the sky; gone with the ship.
Pose posePointer(const Ship &ship) {
    const Vector3 &place = ship.getBody().getPosition();
    const Vector3 way = ship.isHooked() ? Vector3::UP : (ship.getRodEnd() - place).unit();
    if (ship.isBroken()) return NOWHERE;
    return {place + way * POINTER_AWAY, towards(way)};
}

Pose poseOf(const cyclone::RigidBody &body) { return {body.getPosition(), body.getOrientation()}; }

}  // namespace

std::vector<Body> makeBodies() {
    return {{{makeHull(), makeFin("port fin", 2, 3, 4), makeFin("starboard fin", 5, 6, 7), makeFlame()},
             true,
             false},
            {{makePod()}, false, false},
            {{makeRod()}, false, false},
            {{makePointer()}, false, false}};
}

std::vector<Pose> getPoses(const Ship &ship) {
    const cyclone::RigidBody &body = ship.getBody(), &pod = ship.getPod();
    std::vector<Pose> poses;
    for (std::size_t n = 0; n < Ship::WRECK_PARTS; ++n)
        poses.push_back(poseOf(ship.isBroken() ? ship.getWreck(n) : body));
    // The less it burns the deeper the flame is in the hull; without a push all of it.
    const real throttle = ship.getThrottle();
    const Vector3 nozzle(throttle > 0 ? NOZZLE + 0.5 * (1 - throttle) : NOZZLE + FLAME_LENGTH, 0, 0);
    const cyclone::RigidBody &hull = ship.isBroken() ? ship.getWreck(0) : body;
    poses.push_back({hull.getPointInWorldSpace(nozzle), hull.getOrientation()});

    poses.push_back(poseOf(pod));
    const Vector3 end = ship.isHooked() ? body.getPosition() : ship.getRodEnd();
    poses.push_back({pod.getPosition(), towards(end - pod.getPosition())});
    poses.push_back(posePointer(ship));
    return poses;
}

namespace {

/// Far behind, so that one sees the ship move where there is no rock.
Part makeStars(const Level &level) {
    Part part;
    part.name = "stars";
    part.twoSided = true;
    Random random(1);
    for (int n = 0; n < STARS; ++n) {
        const Vector3 low(random.between(-STARS_BEYOND, level.width + STARS_BEYOND),
                          random.between(0, level.height + STARS_BEYOND), STARS_Z);
        const real size = random.between(0.1, 0.25);
        addFace(part,
                {low, low + Vector3(size, 0, 0), low + Vector3(size, size, 0), low + Vector3(0, size, 0)},
                STAR);
    }
    return part;
}

}  // namespace

std::vector<Part> makeRock(const Level &level) {
    Part front, depth, edge;
    front.name = "rock";
    depth.name = "walls";
    edge.name = "edge";
    for (Part *part : {&front, &depth, &edge}) part->twoSided = true;
    const auto at = [](Vector3 point, real z) {
        point.z = z;
        return point;
    };
    for (std::vector<Vector3> corners : level.rock) {
        for (Vector3 &corner : corners) corner.z = ROCK_FRONT;
        addFace(front, corners, ROCK);
    }
    for (const Wall &wall : level.walls) {
        addFace(depth,
                {at(wall.from, ROCK_FRONT), at(wall.from, ROCK_BACK), at(wall.to, ROCK_BACK),
                 at(wall.to, ROCK_FRONT)},
                DEEP);
        const Vector3 along = (wall.to - wall.from).unit();
        const Vector3 inwards = Vector3(-along.y, along.x, 0) * EDGE_WIDTH;
        // A little longer than the wall: around a corner the pieces meet.
        const Vector3 from = at(wall.from - along * EDGE_OVERLAP, ROCK_FRONT + 0.05);
        const Vector3 to = at(wall.to + along * EDGE_OVERLAP, ROCK_FRONT + 0.05);
        addFace(edge, {from, to, to + inwards, from + inwards}, EDGE);
    }
    return {makeStars(level), front, depth, edge};
}

}  // namespace thrust
