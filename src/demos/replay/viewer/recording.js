'use strict';
// The recording as the page carries it, and the run at any moment of it.

/// A column of numbers: one number for all frames, a plain array, 16-bit steps or single precision.
function decodeColumn(column, count) {
    if (typeof column === 'number') return new Float64Array(count).fill(column);
    if (Array.isArray(column)) return Float64Array.from(column);
    const text = atob(column.u16 || column.f32), bytes = new Uint8Array(text.length);
    for (let n = 0; n < text.length; ++n) bytes[n] = text.charCodeAt(n);
    const view = new DataView(bytes.buffer), values = new Float64Array(count);
    if (column.f32) for (let n = 0; n < count; ++n) values[n] = view.getFloat32(4 * n, true);
    else for (let n = 0; n < count; ++n) values[n] = column.least + column.step * view.getUint16(2 * n, true);
    return values;
}

/// A channel, which is unpacked once somebody asks for its values.
class ChannelOfRun {
    constructor({ name, unit, panel, values }, decode) { Object.assign(this, { name, unit, panel, unpack: () => decode(values) }); }
    get values() { return this.unpacked ??= this.unpack(); }
}

/// The channels by panel, in the order in which the panels first appear.
function panelsOf(channels) {
    const panels = new Map();
    for (const channel of channels) {
        if (!panels.has(channel.panel)) panels.set(channel.panel, { name: channel.panel, channels: [] });
        panels.get(channel.panel).channels.push(channel);
    }
    return [...panels.values()];
}

class Run {
    constructor(data) {
        const decode = column => decodeColumn(column, data.frames);
        Object.assign(this, {
            title: data.title, kind: data.kind, summary: data.summary, sea: data.terrain === 'sea', space: data.terrain === 'space',
            flat: data.flat, cameras: data.cameras, count: data.frames,
            newtonsPerMetre: data.newtonsPerMetre, cuts: new Set(data.cuts), time: decode(data.time),
            windspeed: data.windspeed.map(decode),
            parts: [], bodies: [],
            fixtures: data.fixtures.map(part => ({ ...part, faces: part.faces.map(Run.face) })),
            paint: data.paint.map(Run.face),
            arrows: data.arrows.map(a => ({ ...a, tail: a.tail.map(decode), vector: a.vector.map(decode) })),
            channels: data.channels.map(channel => new ChannelOfRun(channel, decode)),
            waves: data.waves.map(wave => {
                const k = 2 * Math.PI / wave.wavelength;
                return {
                    amplitude: wave.amplitude, phase: wave.phase, frequency: wave.frequency,
                    k: [k * Math.cos(wave.direction), k * Math.sin(wave.direction)],
                };
            }),
        });
        data.bodies.forEach(body => this.addBody(body, decode));
        this.start = this.time[0];
        this.end = this.time[this.count - 1];
        this.events = data.events.filter(e => e.time >= this.start - 1 && e.time <= this.end + 1)
            .sort((a, b) => a.time - b.time);
        this.panels = panelsOf(this.channels);
        this.measure();
    }

    /// All parts stand in one row, as do a moment's poses; `root` is the place there of the body's first.
    addBody({ trail, ghost, parts }, decode) {
        const root = this.parts.length;
        this.bodies.push({ root, trail });
        for (const part of parts)
            this.parts.push({
                ...part, root, ghost, position: part.position.map(decode), orientation: part.orientation.map(decode),
                faces: part.faces.map(Run.face),
            });
    }

    static face({ colour, corners }) {
        return { colour, corners: Array.from({ length: corners.length / 3 }, (_, n) => corners.slice(3 * n, 3 * n + 3)) };
    }

    /// The first body's size, its middle in its own frame, and the strongest wind.
    measure() {
        const first = this.at(this.start), body = first.poses[0];
        const back = body.orientation.map((value, i) => i ? -value : value);
        const least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity];
        this.parts.forEach((part, index) => {
            if (part.root !== 0 || (index > 0 && !part.onBody)) return;
            const pose = first.poses[index];
            for (const corner of part.faces.flatMap(face => face.corners)) {
                const world = Vec.add(pose.position, Quat.rotate(pose.orientation, corner));
                Quat.rotate(back, Vec.sub(world, body.position)).forEach((value, axis) => {
                    least[axis] = Math.min(least[axis], value);
                    most[axis] = Math.max(most[axis], value);
                });
            }
        });
        const solid = most[0] >= least[0];
        this.middle = solid ? Vec.lerp(least, most, 0.5) : [0, 0, 0];
        this.radius = solid ? Math.max(Vec.size(Vec.sub(most, least)) / 2, 0.1) : 1;
        this.strongestWind = 0;
        for (let n = 0; n < this.count; ++n)
            this.strongestWind = Math.max(this.strongestWind, Math.hypot(...this.windspeed.map(c => c[n])));
    }

    /// The last frame at or before the time.
    frameAt(time) {
        let low = 0, high = this.count - 1;
        while (low < high) {
            const middle = (low + high + 1) >> 1;
            if (this.time[middle] <= time) low = middle; else high = middle - 1;
        }
        return low;
    }

    /// Everything at a time: positions between frames on the line, orientations along the chord.
    at(time) {
        const n = this.frameAt(time), next = Math.min(n + 1, this.count - 1);
        const whole = this.time[next] - this.time[n];
        const s = whole > 0 && !this.cuts.has(next) ? clamp((time - this.time[n]) / whole, 0, 1) : 0;
        const value = column => mix(column[n], column[next], s);
        const poses = [];
        for (const part of this.parts) {
            const pose = {
                position: part.position.map(value),
                orientation: Quat.nlerp(part.orientation.map(c => c[n]), part.orientation.map(c => c[next]), s),
            };
            poses.push(part.onBody ? Run.compose(poses[part.root], pose) : pose);
        }
        const arrows = this.arrows.map(a => ({
            name: a.name, colour: a.colour, vector: a.vector.map(value),
            tail: Run.compose(poses[0], { position: a.tail.map(value), orientation: [1, 0, 0, 0] }).position,
        }));
        return { time, frame: n, poses, arrows, windspeed: this.windspeed.map(value), value };
    }

    static compose(body, pose) {
        return {
            position: Vec.add(body.position, Quat.rotate(body.orientation, pose.position)),
            orientation: Quat.multiply(body.orientation, pose.orientation),
        };
    }

    /// The height of the sea: y = a sin(k·x − ω t + phase), summed over the waves.
    surface(x, z, time) {
        let y = 0;
        for (const w of this.waves) y += w.amplitude * Math.sin(w.k[0] * x + w.k[1] * z - w.frequency * time + w.phase);
        return y;
    }
}
