#pragma once

/// Where the picture is seen from, and the perspective that follows from it.
#include "picture/scene.h"

namespace demo {

/// Looks from `eye` towards `target` (world, m), with the world's up (+Y) upwards in the picture; straight up
/// or down, with +X upwards. With `target` at `eye` it looks along +X.
struct Camera {
    Vector3 eye{-10, 3, 0}, target;
    real fieldOfView = 0.9;  ///< vertical, rad, between 0 and π
};

/// A camera's perspective onto a picture of width × height square pixels; pixel coordinates run from the top
/// left corner, so that the middle of the first pixel is (0.5, 0.5).
class View {
public:
    View() : View(Camera(), 1, 1) {}
    /// Throws std::invalid_argument if the camera is not finite or its field of view is not between 0 and π.
    View(const Camera &camera, int width, int height);

    const Vector3 &eye() const { return eye_; }

    /// World to view coordinates: x to the right, y up, z forward from the eye, m.
    Vector3 toView(const Vector3 &point) const;

    /// The world direction seen at a pixel position; its component along the line of sight is 1.
    Vector3 ray(real x, real y) const;

    /// The pixel position of a point in view coordinates, which must lie in front of the eye (z > 0).
    real pixelX(const Vector3 &inView) const { return centreX_ + scale_ * inView.x / inView.z; }
    real pixelY(const Vector3 &inView) const { return centreY_ - scale_ * inView.y / inView.z; }

    /// Pixels per unit of x/z and of y/z; and the middle of the picture, where both are 0.
    real scale() const { return scale_; }
    real centreX() const { return centreX_; }
    real centreY() const { return centreY_; }

    /// Puts the pixel position of a world point into x and y; false, and nothing put, if it isn't in front of
    /// the eye.
    bool project(const Vector3 &point, real &x, real &y) const;

private:
    Vector3 eye_, right_, up_, forward_;
    real scale_, centreX_, centreY_;
};

}  // namespace demo
