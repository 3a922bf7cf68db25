#include "picture/camera.h"

#include <cmath>
#include <stdexcept>

namespace demo {

namespace {

/// Nearer than this (m) a point counts as not in front of the eye.
constexpr real NEAR = 1e-6;

void check(const Camera &camera) {
    if (!camera.eye.isFinite() || !camera.target.isFinite())
        throw std::invalid_argument("View: the camera's eye and target must be finite");
    if (!(camera.fieldOfView > 0 && camera.fieldOfView < cyclone::REAL_PI))
        throw std::invalid_argument("View: the field of view must be between 0 and pi");
}

}  // namespace

View::View(const Camera &camera, int width, int height) : eye_(camera.eye) {
    check(camera);
    forward_ = (camera.target - camera.eye).unit();
    if (forward_.squareMagnitude() == 0) forward_ = Vector3::X;
    right_ = forward_ % Vector3::UP;
    if (right_.magnitude() < 1e-6) right_ = forward_ % Vector3::X;
    right_.normalise();
    up_ = right_ % forward_;
    scale_ = height / 2.0 / std::tan(camera.fieldOfView / 2);
    centreX_ = width / 2.0;
    centreY_ = height / 2.0;
}

Vector3 View::toView(const Vector3 &point) const {
    const Vector3 offset = point - eye_;
    return Vector3(offset * right_, offset * up_, offset * forward_);
}

Vector3 View::ray(real x, real y) const {
    return forward_ + right_ * ((x - centreX_) / scale_) + up_ * ((centreY_ - y) / scale_);
}

bool View::project(const Vector3 &point, real &x, real &y) const {
    const Vector3 inView = toView(point);
    if (!(inView.z > NEAR)) return false;
    x = pixelX(inView);
    y = pixelY(inView);
    return true;
}

}  // namespace demo
