#pragma once

/// @file
/// Aerodynamic surfaces, after the chapter's model: a tensor that maps velocity through the air to force.
///
/// Air flows past a body at rest with `windspeed`, the meteorologist's: it points to where the wind comes
/// FROM, with its speed as length. A body's velocity through the air is then velocity + windspeed. A water
/// current past a keel is the same. Tensors are in body axes; drag is a negative diagonal, lift an entry off
/// the diagonal.
#include <cyclone/force.h>
#include <cyclone/water.h>
#include <cyclone/wind.h>

namespace cyclone {

/// A surface: force = R·A·Rᵀ·(velocity + windspeed), at a point of the body. It may resist with any
/// strength, see ForceGenerator::addResistance.
class CYCLONE_API Aero : public PointForce {
public:
    /// Tensor A in N·s/m and position in m, body coordinates, finite. windspeed in m/s, world coordinates, is
    /// read at each frame and must live as long as the surface acts; null is still air.
    Aero(const Matrix3 &tensor, const Vector3 &position, const Vector3 *windspeed);

    /// Whether the surface feels its own motion about the centre of mass too, rotation × (R·position): the
    /// physically complete form, which damps roll, pitch and yaw. Off by default, as in the chapter.
    void setRotationalFlow(bool on) { rotationalFlow = on; }
    bool getRotationalFlow() const { return rotationalFlow; }

    /// A wind that differs from place to place, read where the surface is, on top of windspeed: the flow is
    /// the velocity + windspeed − the field's. It must live as long as the surface acts; null is none.
    void setWind(const WindField *field) { windField = field; }

    /// Puts the surface into water: a keel, a rudder, a hydrofoil, the bottom of a planing boat. The flow is
    /// that past the water where the surface is, and the force is multiplied by clamp(depth/fullDepth, 0, 1):
    /// out of the water it does nothing. fullDepth in m, positive. The water must live as long as the surface
    /// acts; null is none.
    void setWater(const Water *sea, real fullDepth);

    /// The tensor in use now, body coordinates.
    const Matrix3 &getTensor() const { return tensor; }

    Vector3 getForce(const RigidBody &body) const override {
        Vector3 flow = body.getVelocity();
        if (windspeed != nullptr) flow += *windspeed;
        if (windField != nullptr) flow -= windField->getVelocity(body.getPointInWorldSpace(position));
        if (rotationalFlow) flow += body.getRotation() % body.getDirectionInWorldSpace(position);
        return water == nullptr ? getForceOf(flow, body) : getForceInWater(flow, body);
    }
    void updateForce(RigidBody *body, real duration) override;
    void addResistance(const RigidBody &body, Resistance &sum) const override;

protected:
    /// For derived classes: `function` is whose arguments they are.
    Aero(const char *function, const Matrix3 &tensor, const Vector3 &position, const Vector3 *windspeed);
    void setTensor(const Matrix3 &bodyTensor);

    Matrix3 tensor;
    real tensorSize;  ///< at least the tensor's norm
    const Vector3 *windspeed;
    const WindField *windField = nullptr;
    const Water *water = nullptr;
    real fullDepth = 1;
    bool rotationalFlow = false;

private:
    Vector3 getForceOf(const Vector3 &flow, const RigidBody &body) const {
        return body.getDirectionInWorldSpace(tensor * body.getDirectionInLocalSpace(flow));
    }
    /// By value, lest callers that are in no water keep the vector in memory.
    Vector3 getForceInWater(Vector3 flow, const RigidBody &body) const;
    real wettedPart(const Vector3 &point, real surfaceHeight) const;
};

/// A surface with a control, such as a wing with a flap: the tensor is `min` at control −1, `base` at 0,
/// `max` at +1, and linear in between.
class CYCLONE_API AeroControl : public Aero {
public:
    AeroControl(const Matrix3 &base, const Matrix3 &min, const Matrix3 &max, const Vector3 &position,
                const Vector3 *windspeed);

    /// −1 … 1; clamped. Finite.
    void setControl(real value);
    real getControl() const { return control; }

private:
    Matrix3 base, min, max;
    real control = 0;
};

/// A surface that turns relative to the body, such as a sail or a rudder: force = M·A·Mᵀ·(velocity +
/// windspeed) with M = R·S. Turning does not move the point where the force acts.
class CYCLONE_API AngledAero : public Aero {
public:
    /// As Aero; the tensor is in the surface's own axes.
    AngledAero(const Matrix3 &tensor, const Vector3 &position, const Vector3 *windspeed);

    /// S, from the surface's axes to body axes. Any length but zero; it is made a unit quaternion.
    void setOrientation(const Quaternion &surfaceToBody);
    Quaternion getOrientation() const { return orientation; }

private:
    Matrix3 surfaceTensor;
    Quaternion orientation;
};

}  // namespace cyclone
