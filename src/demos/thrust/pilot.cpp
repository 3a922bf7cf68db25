#include "thrust/pilot.h"

#include <algorithm>

namespace thrust {

namespace {

using cyclone::real_clamp;

constexpr real SPEED = 3, SPEED_WITH_POD = 2, SPEED_TO_RING = 0.8;  // m/s, along the way
constexpr real LIFT = 3;  // m: straight down to the ring, and straight up from there
// rad/s: how softly it follows the marker.
constexpr real LEAD_FREQUENCY = 0.8, LEAD_FREQUENCY_WITH_POD = 0.4;
constexpr real LONGEST_LEAD = 9;  // m, between the two
constexpr real CORNER = 2.5;      // m: how near the lead goes to each place on the way
constexpr real LOST = 12;         // m from the lead: somebody else has flown
constexpr real CLEARANCE = 14;    // m above the map, where the way ends

// Of the ship about where it should be, and of the pod, rad/s; and their damping, of critical.
constexpr real SHIP_FREQUENCY = 0.9, POD_FREQUENCY = 0.35, DAMPING = 0.9;
constexpr real MOST_ACCELERATION = 1.2, MOST_POD_ACCELERATION = 0.7;  // m/s²
constexpr real STEEPEST = 1.0;                                        // rad off the vertical

Vector3 limited(const Vector3 &v, real most) {
    const real size = v.magnitude();
    return size > most ? v * (most / size) : v;
}

/// The acceleration of a damped spring.
Vector3 pulled(const Vector3 &offset, const Vector3 &velocityOffset, real frequency) {
    return offset * (frequency * frequency) + velocityOffset * (2 * DAMPING * frequency);
}

}  // namespace

Pilot::Pilot(const Level &level)
    : wayIn(level.way), exit(level.start.x, level.height + CLEARANCE, 0), gravity(level.gravity) {}

void Pilot::startOver(const Ship &ship) {
    isOnWayBack = false;
    heading = throttle = 0;
    way = wayIn;
    way.push_back(ship.getRodEnd() + Vector3::UP * LIFT);
    way.push_back(ship.getRodEnd());
    joinWay(ship);
}

/// From here on the way is that of the rod's middle.
void Pilot::turnBack(const Ship &ship) {
    isOnWayBack = true;
    way = {ship.getPod().getPosition() + Vector3::UP * (LIFT + Ship::ROD_LENGTH / 2)};
    way.insert(way.end(), wayIn.rbegin(), wayIn.rend());
    way.push_back(exit);
    joinWay(ship);
}

void Pilot::joinWay(const Ship &ship) {
    marker = placeOf(ship);
    lead = {marker, Vector3(), Vector3()};
    const auto nearer = [this](const Vector3 &a, const Vector3 &b) {
        return (a - marker).squareMagnitude() < (b - marker).squareMagnitude();
    };
    next = static_cast<std::size_t>(std::min_element(way.begin(), way.end(), nearer) - way.begin());
}

Vector3 Pilot::placeOf(const Ship &ship) const {
    const Vector3 place = ship.getBody().getPosition();
    return isOnWayBack ? (place + ship.getPod().getPosition()) * 0.5 : place;
}

void Pilot::fly(const Ship &ship, real duration) {
    if (ship.isHooked() && !isOnWayBack) turnBack(ship);
    if ((placeOf(ship) - lead.position).magnitude() > LOST) joinWay(ship);
    const bool isLastLeg = next + 1 >= way.size();
    advanceLead(isOnWayBack ? SPEED_WITH_POD : isLastLeg ? SPEED_TO_RING : SPEED, duration);
    push(ship, isOnWayBack ? forceWithPod(ship) : forceAlone(ship));
}

void Pilot::advanceLead(real speed, real duration) {
    if (next < way.size()) {
        const Vector3 &corner = way[next];
        if ((marker - lead.position).magnitude() < LONGEST_LEAD)
            marker = (corner - marker).magnitude() < speed * duration
                         ? corner
                         : marker + (corner - marker).unit() * (speed * duration);
        if (marker == corner && (lead.position - corner).magnitude() < CORNER) ++next;
    }
    const real f = isOnWayBack ? LEAD_FREQUENCY_WITH_POD : LEAD_FREQUENCY;
    lead.acceleration = (marker - lead.position) * (f * f) - lead.velocity * (2 * f);
    lead.velocity += lead.acceleration * duration;
    lead.position += lead.velocity * duration;
}

Vector3 Pilot::forceAlone(const Ship &ship) const {
    const cyclone::RigidBody &body = ship.getBody();
    const Vector3 wanted = lead.acceleration + pulled(lead.position - body.getPosition(),
                                                      lead.velocity - body.getVelocity(), SHIP_FREQUENCY);
    return (limited(wanted, MOST_ACCELERATION) + Vector3::UP * gravity) * Ship::MASS;
}

Vector3 Pilot::forceWithPod(const Ship &ship) const {
    const cyclone::RigidBody &body = ship.getBody(), &pod = ship.getPod();
    const Vector3 place = lead.position - Vector3::UP * (Ship::ROD_LENGTH / 2);
    const Vector3 podWanted =
        limited(lead.acceleration +
                    pulled(place - pod.getPosition(), lead.velocity - pod.getVelocity(), POD_FREQUENCY),
                MOST_POD_ACCELERATION);
    const Vector3 rod = podWanted + Vector3::UP * gravity;
    const Vector3 above = pod.getPosition() + rod.unit() * Ship::ROD_LENGTH;
    const Vector3 wanted = podWanted + pulled(above - body.getPosition(),
                                              pod.getVelocity() - body.getVelocity(), SHIP_FREQUENCY);
    return (limited(wanted, MOST_ACCELERATION) + Vector3::UP * gravity) * Ship::MASS + rod * Ship::POD_MASS;
}

/// Turns the nose to where the force should go, and burns as far as it points there.
void Pilot::push(const Ship &ship, Vector3 force) {
    force.y = std::max(force.y, 0.1 * gravity * Ship::MASS);
    heading = real_clamp(cyclone::real_atan2(force.x, force.y), -STEEPEST, STEEPEST);
    const Vector3 nose = ship.getBody().getDirectionInWorldSpace(Vector3::X);
    throttle = real_clamp(force * nose / Ship::MAX_PUSH, 0, 1);
}

}  // namespace thrust
