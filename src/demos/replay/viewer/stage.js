'use strict';
// The picture: its canvas and painter, the names at the arrows, and the hand that turns the camera.

/// Whether a box [left, top, width, height] lies within the picture and apart from all others.
function fits(box, width, height, others) {
    const meets = other => box[0] < other[0] + other[2] && other[0] < box[0] + box[2] &&
        box[1] < other[1] + other[3] && other[1] < box[1] + box[3];
    return box[0] >= 4 && box[0] + box[2] <= width - 4 && box[1] >= 0 && box[1] + box[3] <= height && !others.some(meets);
}

class Stage {
    constructor(run, changed) {
        this.run = run;
        this.changed = changed;
        this.element = document.getElementById('stage');
        this.canvas = document.getElementById('scene');
        this.labels = document.getElementById('labels');
        this.scale = document.getElementById('scale');
        this.pills = [...this.element.querySelectorAll('.pill')];
        this.cameras = new Cameras(run);
        if (run.flat) this.element.querySelector('[value=orbit] + span').textContent = 'Flat';
        this.choosePainter();
        this.names = [...run.arrows, { name: 'wind' }].map(() => this.labels.appendChild(document.createElement('span')));
        this.listen();
    }

    choosePainter() {
        this.painter = SolidPainter.on(this.canvas, this.run) || new FlatPainter(this.canvas, this.run);
        this.canvas.addEventListener('webglcontextlost', event => event.preventDefault());
        this.canvas.addEventListener('webglcontextrestored', () => {
            this.painter = SolidPainter.on(this.canvas, this.run);
            this.changed();
        });
    }

    paint(moment, theme, withArrows, now) {
        const { clientWidth, clientHeight } = this.element, sharpness = Math.min(window.devicePixelRatio || 1, 2);
        const width = Math.max(1, Math.round(clientWidth * sharpness)), height = Math.max(1, Math.round(clientHeight * sharpness));
        if (this.canvas.width !== width) this.canvas.width = width;
        if (this.canvas.height !== height) this.canvas.height = height;
        const look = lookAt(this.run, theme), buttons = 2 * this.pills[0].offsetTop + this.pills[0].offsetHeight;
        const view = this.cameras.view(moment, width / height, buttons / (clientHeight || 1), now);
        const arrows = withArrows ? arrowsAt(this.run, moment, look) : [];
        this.painter.paint({ view, moment, look, arrows, width, height });
        this.placeLabels(arrows, view, clientWidth, clientHeight);
        const { cell } = gridAt(view, clientHeight);
        this.scale.textContent = this.run.space ? '' : `grid ${cell < 1000 ? `${cell} m` : `${cell / 1000} km`}`;
    }

    /// A name at each arrow's tip, where there is room, unless the arrow is short.
    placeLabels(arrows, view, width, height) {
        const near = 0.01, matrix = Mat.multiply(Mat.perspective(view.fov, width / height, near, 40000), Mat.look(view.eye, view.target));
        const image = p => {
            const [x, y, , w] = Mat.project(matrix, p);
            return w > near ? [(x / w + 1) / 2 * width, (1 - y / w) / 2 * height] : null;
        };
        const taken = this.pills.map(pill => [pill.offsetLeft, pill.offsetTop, pill.offsetWidth, pill.offsetHeight]);
        this.names.forEach((label, index) => {
            const arrow = arrows[index], tail = arrow && image(arrow.tail), tip = arrow && image(Vec.add(arrow.tail, arrow.vector));
            const text = arrow && `${arrow.name} ${arrow.value}`.trim();
            let box = null;
            if (tail && tip && Math.hypot(tip[0] - tail[0], tip[1] - tail[1]) > 14) {
                const wide = 6.2 * text.length + 6, right = tip[0] + 4, left = tip[0] - wide - 4;
                const sides = tip[0] < tail[0] ? [left, right] : [right, left], top = tip[1] - (tip[1] < tail[1] ? 14 : 2);
                const places = [...sides.map(x => [x, top]), [tip[0] - wide / 2, tip[1] - 22], ...sides.map(x => [x, top + 16])];
                box = places.map(([x, y]) => [x, y, wide, 16]).find(place => fits(place, width, height, taken)) || null;
            }
            label.hidden = !box;
            if (!box) return;
            taken.push(box);
            label.textContent = text;
            label.style.transform = `translate(${box[0].toFixed(1)}px, ${box[1].toFixed(1)}px)`;
        });
    }

    // Turning and zooming

    listen() {
        const { canvas } = this, fingers = new Map();
        const spread = () => {
            const [a, b] = [...fingers.values()];
            return Math.hypot(a.x - b.x, a.y - b.y);
        };
        canvas.addEventListener('pointerdown', event => {
            fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
            canvas.setPointerCapture(event.pointerId);
        });
        canvas.addEventListener('pointermove', event => {
            const finger = fingers.get(event.pointerId);
            if (!finger) return;
            const before = fingers.size === 2 ? spread() : 0, dx = event.clientX - finger.x, dy = event.clientY - finger.y;
            finger.x = event.clientX;
            finger.y = event.clientY;
            if (fingers.size === 1) this.cameras.turn(-0.007 * dx, 0.006 * dy);
            if (before > 0) this.cameras.zoom(before / Math.max(1, spread()));
            this.changed();
        });
        for (const over of ['pointerup', 'pointercancel']) canvas.addEventListener(over, event => fingers.delete(event.pointerId));
        canvas.addEventListener('wheel', event => {
            event.preventDefault();
            this.zoom(Math.exp(clamp(event.deltaY * (event.deltaMode ? 30 : 1), -200, 200) * 0.0015));
        }, { passive: false });
        canvas.addEventListener('dblclick', () => this.reset());
    }

    zoom(factor) {
        this.cameras.zoom(factor);
        this.changed();
    }
    reset() {
        this.cameras.reset();
        this.changed();
    }
}
