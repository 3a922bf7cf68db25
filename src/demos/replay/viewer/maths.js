'use strict';
// Vectors [x, y, z], quaternions [r, i, j, k] and 4×4 matrices, column by column, as WebGL takes them.

const Vec = {
    add: (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]],
    sub: (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]],
    scale: (a, s) => [a[0] * s, a[1] * s, a[2] * s],
    mad: (a, b, s) => [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s],
    dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
    cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
    size: a => Math.hypot(a[0], a[1], a[2]),
    unit: a => Vec.scale(a, 1 / (Vec.size(a) || 1)),
    lerp: (a, b, s) => [a[0] + (b[0] - a[0]) * s, a[1] + (b[1] - a[1]) * s, a[2] + (b[2] - a[2]) * s],
    /// The normal of a polygon (Newell's method).
    normal(corners) {
        let n = [0, 0, 0];
        corners.forEach((p, i) => { n = Vec.add(n, Vec.cross(p, corners[(i + 1) % corners.length])); });
        return Vec.unit(n);
    },
};

const Quat = {
    multiply: (a, b) => [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
        a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]],
    rotate(q, v) {
        const axis = [q[1], q[2], q[3]], t = Vec.scale(Vec.cross(axis, v), 2);
        return Vec.add(Vec.mad(v, t, q[0]), Vec.cross(axis, t));
    },
    /// Along the chord, the short way round.
    nlerp(a, b, s) {
        const sign = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] < 0 ? -1 : 1;
        const q = a.map((value, i) => value + (sign * b[i] - value) * s);
        const size = Math.hypot(...q) || 1;
        return q.map(value => value / size);
    },
};

const Mat = {
    /// From three axes and an origin.
    frame: (x, y, z, o) => [x[0], x[1], x[2], 0, y[0], y[1], y[2], 0, z[0], z[1], z[2], 0, o[0], o[1], o[2], 1],
    ofPose: pose => Mat.frame(Quat.rotate(pose.orientation, [1, 0, 0]), Quat.rotate(pose.orientation, [0, 1, 0]),
        Quat.rotate(pose.orientation, [0, 0, 1]), pose.position),
    multiply(a, b) {
        const m = new Array(16);
        for (let c = 0; c < 4; ++c)
            for (let r = 0; r < 4; ++r)
                m[4 * c + r] = a[r] * b[4 * c] + a[4 + r] * b[4 * c + 1] + a[8 + r] * b[4 * c + 2] + a[12 + r] * b[4 * c + 3];
        return m;
    },
    /// Looking from the eye along −Z of the view, up to the top.
    look(eye, target) {
        const back = Vec.unit(Vec.sub(eye, target)), right = Vec.unit(Vec.cross([0, 1, 0], back));
        const up = Vec.cross(back, right);
        return [right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0,
            -Vec.dot(right, eye), -Vec.dot(up, eye), -Vec.dot(back, eye), 1];
    },
    perspective(fov, aspect, near, far) {
        const f = 1 / Math.tan(fov / 2);
        return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0];
    },
    /// The homogeneous image of a point.
    project: (m, p) => [0, 1, 2, 3].map(r => m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r]),
};

const clamp = (value, least, most) => Math.min(most, Math.max(least, value));
const mix = (a, b, s) => a + (b - a) * s;
