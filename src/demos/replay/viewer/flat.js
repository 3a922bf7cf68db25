'use strict';
// Paints the same scene on a plain canvas, far things first, where there is no WebGL 2.

const standing = { position: [0, 0, 0], orientation: [1, 0, 0, 0] };

class FlatPainter {
    constructor(canvas, run) {
        Object.assign(this, { pen: canvas.getContext('2d'), run, trail: trailsOf(run).path });
    }

    paint({ view, moment, look, arrows, width, height }) {
        const camera = Mat.look(view.eye, view.target), near = 0.02 * Vec.size(Vec.sub(view.eye, view.target));
        Object.assign(this, { width, height, look, near, time: moment.time });
        this.matrix = Mat.multiply(Mat.perspective(view.fov, width / height, near, 40000), camera);
        if (this.run.space) {
            this.pen.fillStyle = look.space;
            this.pen.fillRect(0, 0, width, height);
        } else {
            this.paintSky(view, camera);
            if (!this.run.sea) this.paintFields(view);
            this.paintGrid(view);
            this.paintMarks();
            this.paintShadow(moment);
        }
        this.paintTrail(moment.time);
        this.paintParts(moment, view.eye);
        for (const arrow of arrows) this.paintArrow(arrow);
    }

    /// The image of a polygon or line, cut off in front of the eye: pixels, or an empty list.
    image(points, closed) {
        const clipped = [], all = points.map(p => Mat.project(this.matrix, p));
        all.forEach((b, i) => {
            const a = all[(i || all.length) - 1];
            if ((closed || i > 0) && (a[3] < this.near) !== (b[3] < this.near)) {
                const s = (this.near - a[3]) / (b[3] - a[3]);
                clipped.push(a.map((value, axis) => mix(value, b[axis], s)));
            }
            if (b[3] >= this.near) clipped.push(b);
        });
        return clipped.map(([x, y, , w]) => [(x / w + 1) / 2 * this.width, (1 - y / w) / 2 * this.height]);
    }

    trace(points, closed) {
        const { pen } = this;
        pen.beginPath();
        this.image(points, closed).forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
        if (closed) pen.closePath();
    }

    paintSky(view, camera) {
        const { pen, width, height, look, run } = this, tall = Math.tan(view.fov / 2);
        const pitch = Math.asin(clamp(-camera[6], -1, 1));
        const horizon = height / 2 * (1 + Math.tan(clamp(pitch, -1.5, 1.5)) / tall);
        const fill = (from, to, first, second) => {
            const gradient = pen.createLinearGradient(0, from, 0, to);
            gradient.addColorStop(0, first);
            gradient.addColorStop(1, second);
            pen.fillStyle = gradient;
        };
        fill(horizon - height, horizon, look.zenith, look.horizon);
        pen.fillRect(0, 0, width, height);
        fill(horizon, horizon + 0.25 * height, look.horizon, run.sea ? look.deep : look.ground);
        pen.fillRect(0, horizon, width, Math.max(0, height - horizon));
    }

    /// Those around, in the colours of the others' mean where they are far off.
    paintFields(view) {
        const { pen, look } = this, reach = 14;
        const column = Math.round(view.target[0] / fieldWidth), row = Math.round(view.target[2] / fieldDepth);
        for (let r = row - reach; r < row + reach; ++r)
            for (let c = column - reach; c < column + reach; ++c) {
                const x = (c - 0.61 * r % 1) * fieldWidth, z = r * fieldDepth, kind = Math.abs(Math.imul(c * 7 + r * 131, 2654435761)) >> 8;
                pen.globalAlpha = clamp(1.6 * (1 - Math.hypot(c - column, r - row) / reach), 0, 1);
                pen.fillStyle = look.fields[kind % 4];
                this.trace([[x, 0, z], [x + fieldWidth, 0, z], [x + fieldWidth, 0, z + fieldDepth], [x, 0, z + fieldDepth]], true);
                pen.fill();
            }
        pen.globalAlpha = 1;
    }

    paintGrid(view) {
        const { pen, look, run } = this, { cell } = gridAt(view, this.height), reach = 24;
        const at = [0, 2].map(axis => Math.round(view.target[axis] / cell) * cell);
        const point = (x, z) => [x, run.surface(x, z, this.time), z];
        pen.strokeStyle = run.sea ? look.foam : look.line;
        pen.lineWidth = 1;
        for (let i = -reach; i <= reach; ++i) {
            pen.globalAlpha = 0.4 * (1 - Math.abs(i) / (reach + 1));
            const line = Array.from({ length: 4 * reach + 1 }, (_, n) => (n / 2 - reach) * cell);
            this.trace(line.map(d => point(at[0] + i * cell, at[1] + d)));
            pen.stroke();
            this.trace(line.map(d => point(at[0] + d, at[1] + i * cell)));
            pen.stroke();
        }
        pen.globalAlpha = 1;
    }

    paintMarks() {
        const { pen, look, run } = this, light = look.ambient + 0.08 + look.sunlight * sun[1];
        for (const { corners, colour } of run.paint) {
            pen.fillStyle = this.shade(colour, light);
            this.trace(corners, true);
            pen.fill();
        }
    }

    shade(colour, light) { return `rgb(${rgb(colour).map(level => Math.round(Math.min(255, 255 * level * light)))})`; }

    paintTrail(now) {
        const { pen, look, run } = this;
        pen.strokeStyle = look.trail;
        pen.lineWidth = 2;
        for (const [a, b, , to] of this.trail) {
            const opacity = (to <= now ? 0.8 : 0.16) * fadedAfter(run, to - now);
            if (opacity < 0.03) continue;
            pen.globalAlpha = opacity;
            this.trace(run.sea ? [a, b].map(p => [p[0], run.surface(p[0], p[2], now), p[2]]) : [a, b]);
            pen.stroke();
        }
        pen.globalAlpha = 1;
    }

    paintShadow(moment) {
        const { pen, look, run } = this;
        pen.fillStyle = look.shadow;
        pen.beginPath();
        const cast = (part, pose) => {
            for (const face of part.faces) {
                const flat = this.placed(pose, face.corners).map(p => [p[0], run.surface(p[0], p[2], this.time), p[2]]);
                if (Vec.normal(flat)[1] < 0) flat.reverse();
                this.image(flat, true).forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
                pen.closePath();
            }
        };
        run.fixtures.forEach(part => cast(part, standing));
        run.parts.forEach((part, index) => { if (!part.ghost) cast(part, moment.poses[index]); });
        pen.globalAlpha = 0.3;
        pen.fill();
        pen.globalAlpha = 1;
    }

    placed(pose, corners) {
        return corners.map(corner => Vec.add(pose.position, Quat.rotate(pose.orientation, corner)));
    }

    paintParts(moment, eye) {
        const { pen, look, run } = this, faces = [];
        const collect = (part, pose) => part.faces.forEach(face => {
            const corners = this.placed(pose, face.corners);
            const middle = Vec.scale(corners.reduce(Vec.add), 1 / corners.length), toEye = Vec.sub(eye, middle);
            let normal = Vec.normal(corners);
            const behind = Vec.dot(normal, toEye) < 0;
            if (behind && !part.twoSided) return;
            if (behind) normal = Vec.scale(normal, -1);
            const facing = Vec.dot(normal, sun), through = part.twoSided ? -0.7 * facing : 0;
            const light = look.ambient + 0.08 * normal[1] + look.sunlight * Math.max(facing, through);
            faces.push({ corners, distance: Vec.size(toEye), colour: this.shade(face.colour, light), opacity: part.ghost ? 0.35 : 1 });
        });
        run.fixtures.forEach(part => collect(part, standing));
        run.parts.forEach((part, index) => collect(part, moment.poses[index]));
        faces.sort((a, b) => b.distance - a.distance);
        pen.lineJoin = 'round';
        pen.lineWidth = 0.7;
        for (const { corners, colour, opacity } of faces) {
            pen.globalAlpha = opacity;
            pen.fillStyle = pen.strokeStyle = colour;
            this.trace(corners, true);
            pen.fill();
            pen.stroke();
        }
        pen.globalAlpha = 1;
    }

    paintArrow(arrow) {
        const { pen } = this, ends = this.image([arrow.tail, Vec.add(arrow.tail, arrow.vector)]);
        if (ends.length < 2) return;
        const [[ax, ay], [bx, by]] = ends, size = Math.hypot(bx - ax, by - ay);
        if (size < 2) return;
        const tip = Math.min(this.height / 50, 0.5 * size), x = (bx - ax) / size, y = (by - ay) / size;
        pen.strokeStyle = pen.fillStyle = arrow.colour;
        pen.lineWidth = Math.max(1.5, this.height / 250);
        pen.beginPath();
        pen.moveTo(ax, ay);
        pen.lineTo(bx - x * tip, by - y * tip);
        pen.stroke();
        pen.beginPath();
        pen.moveTo(bx, by);
        pen.lineTo(bx - x * tip - y * tip * 0.4, by - y * tip + x * tip * 0.4);
        pen.lineTo(bx - x * tip + y * tip * 0.4, by - y * tip - x * tip * 0.4);
        pen.fill();
    }
}
