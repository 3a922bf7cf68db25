'use strict';
// Four ways to look at the run. Each camera is an azimuth, an elevation and a distance; what they are measured from
// differs. Nothing depends on the moments before, so that one can jump about in time.

const homes = {
    chase: { azimuth: Math.PI, elevation: 0.26, distance: 4.2 },
    orbit: { azimuth: 2.5, elevation: 0.34, distance: 4.6 },
    side: { azimuth: Math.PI / 2, elevation: 0.07, distance: 4.2 },
    ground: { azimuth: Math.PI / 2, elevation: 0, distance: 1 },
};

/// A flat scene is orbited from its front, from so many times further off through so much longer a lens.
const flatness = 40;

class Cameras {
    constructor(run) {
        this.run = run;
        this.mode = 'chase';
        this.settings = {};
        this.homes = run.flat ? { ...homes, orbit: { azimuth: Math.PI / 2, elevation: 0, distance: flatness * run.cameras.distance / run.radius } } : homes;
        for (const mode in homes) this.reset(mode);
        this.headings = this.smoothHeadings();
        this.heights = this.smooth(Float64Array.from({ length: run.count }, (_, n) => run.parts[0].position[1][n]), 1.5);
        const p = run.parts[0].position;
        this.standpoint = [p[0][0], 0, p[2][0]];
        this.highestWave = run.waves.reduce((sum, wave) => sum + Math.abs(wave.amplitude), 0);
        this.shift = null;
    }

    get names() { return Object.keys(homes); }
    reset(mode = this.mode) { this.settings[mode] = { ...this.homes[mode] }; }

    /// Changes the camera; the view glides from the one to the other.
    choose(mode, now) {
        if (mode === this.mode) return;
        this.shift = this.last && { from: this.last, start: now };
        this.mode = mode;
    }
    get gliding() { return this.shift !== null; }

    turn(azimuth, elevation) {
        const s = this.settings[this.mode];
        s.azimuth -= azimuth;
        s.elevation = clamp(s.elevation + elevation, -0.2, 1.5);
    }
    zoom(factor) {
        const s = this.settings[this.mode], home = this.homes[this.mode];
        s.distance = clamp(s.distance * factor, home.distance * 0.2, home.distance * 40);
    }

    /// The compass course of the nose in each frame, without the jumps at ±π, calmed over a second.
    smoothHeadings() {
        const { run } = this, q = run.parts[0].orientation, raw = new Float64Array(run.count);
        let last = 0;
        for (let n = 0; n < run.count; ++n) {
            const nose = Quat.rotate(q.map(c => c[n]), [1, 0, 0]);
            if (Math.hypot(nose[0], nose[2]) > 0.2) {
                const heading = Math.atan2(nose[2], nose[0]);
                last = heading + 2 * Math.PI * Math.round((last - heading) / (2 * Math.PI));
            }
            raw[n] = last;
        }
        return this.smooth(raw, 1.2);
    }

    /// A running mean over a stretch of time, never across a cut.
    smooth(values, seconds) {
        const { run } = this, smoothed = new Float64Array(run.count);
        const sums = [0];
        for (const value of values) sums.push(sums[sums.length - 1] + value);
        const cuts = [0, ...[...run.cuts].sort((a, b) => a - b), run.count];
        for (let n = 0, piece = 0; n < run.count; ++n) {
            while (n >= cuts[piece + 1]) ++piece;
            const reach = Math.min(seconds / 2, run.time[n] - run.time[cuts[piece]], run.time[cuts[piece + 1] - 1] - run.time[n]);
            const first = run.frameAt(run.time[n] - reach), last = run.frameAt(run.time[n] + reach);
            smoothed[n] = (sums[last + 1] - sums[first]) / (last + 1 - first);
        }
        return smoothed;
    }

    /// Eye, target and field of view (vertical, rad) for a moment; `aspect` is the picture's width over its height,
    /// `headroom` the share of the height that buttons take at the top: the scene stands in what is left.
    view(moment, aspect, headroom, now) {
        const { run } = this, body = moment.poses[0].position;
        const isFlat = run.flat && this.mode === 'orbit', middle = isFlat ? run.cameras.height : run.middle[1];
        const target = Vec.add(body, [0, middle, 0]);
        if (run.sea) target[1] = moment.value(this.heights) + middle;
        const tall = isFlat ? Math.tan(0.425) / flatness : Math.tan(0.36);
        const fov = 2 * Math.atan(tall / Math.min(1, aspect) ** 0.7);
        const view = this.mode === 'ground' ? this.fromGround(target, fov, aspect) : this.around(moment, target, fov);
        const lower = [0, headroom * Math.tan(view.fov / 2) * Vec.size(Vec.sub(view.eye, view.target)), 0];
        for (const end of ['eye', 'target']) view[end] = Vec.add(view[end], lower);
        if (!run.space) view.eye[1] = Math.max(view.eye[1], this.highestWave + 0.06 * run.radius + 0.05);
        this.last = this.glide(view, now);
        return this.last;
    }

    around(moment, target, fov) {
        const s = this.settings[this.mode];
        const azimuth = s.azimuth + (this.mode === 'orbit' ? 0 : moment.value(this.headings));
        const away = [Math.cos(azimuth) * Math.cos(s.elevation), Math.sin(s.elevation), Math.sin(azimuth) * Math.cos(s.elevation)];
        return { eye: Vec.mad(target, away, s.distance * this.run.radius), target, fov };
    }

    /// Standing beside the start, turning to follow; the lens draws the vehicle nearer, but never all the way.
    fromGround(target, widest, aspect) {
        const s = this.settings.ground, { radius } = this.run;
        const azimuth = s.azimuth + this.headings[0], reach = 8 * radius;
        const eye = [this.standpoint[0] + reach * Math.cos(azimuth), this.highestWave + Math.max(1.7, 0.4 * radius),
            this.standpoint[2] + reach * Math.sin(azimuth)];
        eye[1] += s.elevation * reach;
        const distance = Vec.size(Vec.sub(target, eye));
        const filling = 2 * Math.atan(1.8 * radius / distance / Math.min(1, aspect));
        return { eye, target, fov: clamp(s.distance * filling ** 0.75 * widest ** 0.25, 0.02, 1.7) };
    }

    glide(view, now) {
        if (!this.shift) return view;
        const s = clamp((now - this.shift.start) / 600, 0, 1), eased = s * s * (3 - 2 * s);
        const { from } = this.shift;
        if (s === 1) this.shift = null;
        return {
            eye: Vec.lerp(from.eye, view.eye, eased), target: Vec.lerp(from.target, view.target, eased),
            fov: mix(from.fov, view.fov, eased),
        };
    }
}
