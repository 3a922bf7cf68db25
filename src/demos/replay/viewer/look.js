'use strict';
// The colours of the scene, by day and by night, and what both painters share.

const looks = {
    light: {
        zenith: '#78aed6', horizon: '#eaf0f1', ground: '#93a670', line: '#6f8353',
        fields: ['#8fa866', '#a3b277', '#7f9a5c', '#b9b17d'], hedge: '#5f7a48', deep: '#3f7f96', shallow: '#79b3bd',
        foam: '#ffffff', trail: '#b3402a', wind: '#33475a', shadow: '#2b3a33', ambient: 0.68, sunlight: 0.34, glitter: 0.3, cloud: 0.75,
        arrow: colour => colour,
    },
    dark: {
        zenith: '#0b131c', horizon: '#2c3d4b', ground: '#1f2a22', line: '#51635a',
        fields: ['#1f2b22', '#253027', '#1a261d', '#2b2d23'], hedge: '#141d17', deep: '#0c2735', shallow: '#1d4a5b',
        foam: '#9fc3cf', trail: '#ff9d7a', wind: '#d5e2ec', shadow: '#04080a', ambient: 0.58, sunlight: 0.34, glitter: 0.2, cloud: 0.14,
        space: '#0a0d16', arrow: colour => lightened(colour, 0.35),
    },
};

/// Space is as dark by day; a flat scene shows its colours as they are.
function lookAt(run, theme) {
    const look = looks[run.space ? 'dark' : theme];
    return run.flat ? { ...look, ambient: 0.9, sunlight: 0.25 } : look;
}

const rgb = hex => [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16) / 255);
const lightened = (hex, much) => '#' + rgb(hex).map(level => Math.round(255 * mix(level, 1, much)).toString(16).padStart(2, '0')).join('');

/// The fields on land: rows of them, each row shifted against the next. All in metres.
const fieldWidth = 64, fieldDepth = 44;

const sun = Vec.unit([0.45, 0.8, 0.35]);

/// The grid's cell, a power of ten in metres, that shows well at the target, and how far the next finer one has
/// faded out: 0 to 1.
function gridAt(view, height) {
    const perMetre = height / (2 * Math.tan(view.fov / 2) * Vec.size(Vec.sub(view.eye, view.target)));
    const decade = Math.log10(40 / perMetre), whole = Math.max(0, Math.ceil(decade));
    return { cell: 10 ** whole, fine: clamp((whole - decade) * 1.4 - 0.2, 0, 1) };
}

/// The wind as an arrow above the vehicle, blowing the way the air goes; null in a calm.
function windArrow(run, moment) {
    const speed = Vec.size(moment.windspeed);
    if (speed < 0.02 * run.strongestWind || speed === 0) return null;
    const vector = Vec.scale(moment.windspeed, -1.1 * run.radius / run.strongestWind);
    const middle = Vec.add(moment.poses[0].position, [0, run.middle[1] + 1.3 * run.radius, 0]);
    return { name: 'wind', tail: Vec.mad(middle, vector, -0.5), vector, value: `${speed.toFixed(1)} m/s` };
}

/// All arrows to be drawn at a moment, each with its value in words where its scale is known.
function arrowsAt(run, moment, look) {
    const arrows = moment.arrows.map(a => {
        const newtons = Vec.size(a.vector) * run.newtonsPerMetre;
        const value = !run.newtonsPerMetre ? '' : `${newtons < 9.95 ? newtons.toFixed(1) : newtons < 9995 ?
            newtons.toFixed(0) : (newtons / 1000).toFixed(0) + ' k'}${newtons < 9995 ? ' ' : ''}N`;
        return { ...a, value, colour: look.arrow(a.colour) };
    });
    const wind = windArrow(run, moment);
    if (wind) arrows.push({ ...wind, colour: look.wind });
    return arrows;
}

/// How strong a trail still is that many seconds from now: it fades, in a long run to next to nothing.
const fadeTime = 12;
const faintest = run => clamp(15 / (run.end - run.start || 1), 0.02, 0.5);
const fadedAfter = (run, seconds) => mix(faintest(run), 1, Math.exp(-Math.abs(seconds) / fadeTime));

/// The ways of all that leave a trail as pieces of line [a, b, timeA, timeB]; and, above land, a plumb line every second.
function trailsOf(run) {
    const all = { path: [], plumbs: [] };
    for (const { root } of run.bodies.filter(body => body.trail)) {
        const { path, plumbs } = trailOf(run, run.parts[root].position);
        all.path.push(...path);
        all.plumbs.push(...plumbs);
    }
    return all;
}

function trailOf(run, p) {
    const at = n => [p[0][n], p[1][n], p[2][n]], path = [], plumbs = [];
    const every = Math.max(1, Math.ceil((run.end - run.start) / 240));
    let last = 0, dropped = run.start;
    for (let n = 1; n < run.count; ++n) {
        if (run.cuts.has(n)) last = n;
        const long = Vec.size(Vec.sub(at(n), at(last))) > 0.02 * run.radius || n === run.count - 1;
        if (n > last && long) {
            path.push([at(last), at(n), run.time[last], run.time[n]]);
            last = n;
        }
        if (!run.sea && !run.space && run.time[n] - dropped >= every) {
            const [x, y, z] = at(n);
            if (y > run.radius) plumbs.push([[x, 0, z], [x, y, z], run.time[n], run.time[n]]);
            dropped += every;
        }
    }
    return { path, plumbs };
}
