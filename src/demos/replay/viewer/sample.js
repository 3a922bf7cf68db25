'use strict';
// A stand-in for a recording while one works on the page itself; the build leaves it out.

function sampleRecording() {
    const frames = 361, times = Array.from({ length: frames }, (_, n) => n / 30), zeros = times.map(() => 0);
    const turn = times.map(t => 2 * Math.PI * t / 12);
    const bank = 0.45, product = turn.map(a => Quat.multiply([Math.cos(a / 2), 0, -Math.sin(a / 2), 0], [Math.cos(bank / 2), Math.sin(bank / 2), 0, 0]));
    const height = times.map(t => 12 + 4 * Math.sin(t * Math.PI / 6));
    const face = (colour, ...corners) => ({ colour, corners: corners.flat() });
    const nose = [1, 0, 0], tail = [-1.1, 0.1, 0], keel = [-0.1, -0.16, 0], ridge = [-0.1, 0.16, 0], left = [-0.1, 0, -0.12], right = [-0.1, 0, 0.12];
    const body = [[nose, ridge, right], [nose, right, keel], [nose, keel, left], [nose, left, ridge],
        [tail, right, ridge], [tail, keel, right], [tail, left, keel], [tail, ridge, left]].map(corners => face('#d8dde2', ...corners));
    const wings = [face('#c8553d', [0.25, 0, 0], [-0.1, 0.06, -1.5], [-0.3, 0.06, -1.5], [-0.3, 0, 0]),
        face('#c8553d', [0.25, 0, 0], [-0.3, 0, 0], [-0.3, 0.06, 1.5], [-0.1, 0.06, 1.5]),
        face('#c8553d', [-0.85, 0.1, 0], [-1.15, 0.5, 0], [-1.3, 0.5, 0], [-1.15, 0.1, 0])];
    return {
        title: 'A sample circle', kind: 'workshop', frames, cuts: [], time: times, terrain: 'land', flat: false, cameras: { distance: 6, height: 0 }, waves: [], fixtures: [], newtonsPerMetre: 20,
        summary: 'Made up by the page, so that one can work on it without a recording.\nlength: 12 s\nradius: 30 m',
        events: [{ time: 3, text: 'highest' }, { time: 9, text: 'lowest' }], windspeed: [4, 0, 1],
        bodies: [{ trail: true, ghost: false, parts: [
            { name: 'body', twoSided: false, onBody: false, faces: body, position: [turn.map(a => 30 * Math.sin(a)), height, turn.map(a => -30 * Math.cos(a))],
                orientation: [0, 1, 2, 3].map(i => product.map(q => q[i])) },
            { name: 'wings', twoSided: true, onBody: true, faces: wings, position: [0, 0, 0], orientation: [1, 0, 0, 0] },
        ] }],
        paint: [face('#6b6e72', [-20, 0, 34], [20, 0, 34], [20, 0, 26], [-20, 0, 26])],
        arrows: [{ name: 'lift', colour: '#1f77a4', tail: [0, 0.1, 0], vector: [turn.map(a => -0.6 * Math.sin(a)), 1.3, turn.map(a => 0.6 * Math.cos(a))] }],
        channels: [{ name: 'altitude', unit: 'm', panel: 'Altitude', values: height }, { name: 'bank', unit: '°', panel: 'Attitude', values: 26 },
            { name: 'pitch', unit: '°', panel: 'Attitude', values: zeros }],
    };
}
