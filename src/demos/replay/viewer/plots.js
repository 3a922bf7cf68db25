'use strict';
// The plots beside the scene: one for each panel, all over the same stretch of time, with a cursor at the moment shown.

/// Of a longer run the plots show a stretch around the moment, s, and turn the page this often.
const stretch = 120, page = 60;

const margins = { left: 38, right: 12, top: 8, bottom: 18 };

/// The smallest of 1, 2 or 5 times a power of ten that cuts the range into no more than so many steps.
function roundStep(range, most) {
    const rough = range / most, power = 10 ** Math.floor(Math.log10(rough));
    return [1, 2, 5, 10].map(m => m * power).find(step => step >= 0.999 * rough);
}

/// With as many digits as make sense in such a range, and a true minus.
function valueText(value, range) {
    const digits = clamp(1 - Math.floor(Math.log10(Math.max(range, 1e-9) / 3)), 0, 3);
    return value.toFixed(digits).replace(/^-(?=[0.]*$)/, '').replace('-', '−');
}

/// A whole number of steps, with the digits that the step needs.
function stepText(n, step) {
    return (n * step).toFixed(clamp(-Math.floor(Math.log10(step) + 1e-9), 0, 6)).replace('-', '−');
}

class Plot {
    constructor(run, panel, seek) {
        Object.assign(this, { run, panel });
        this.axes = document.createElement('canvas');
        this.curves = document.createElement('canvas');
        Object.assign(this, { from: run.start, to: run.end });
        this.findRange();
        this.makeElement();
        this.listen(seek);
    }

    findRange() {
        const extents = this.panel.channels.map(({ values }) => [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))]);
        let least = Math.min(...extents.map(e => e[0])), most = Math.max(...extents.map(e => e[1]));
        if (least > 0 && least < 0.5 * most) least = 0;
        const slack = Math.max(0.02 * Math.max(Math.abs(least), Math.abs(most)), 1e-3);
        if (most - least < slack) [least, most] = [least - slack, most + slack];
        this.step = roundStep(most - least, 4);
        const edge = 0.04 * (most - least);
        Object.assign(this, { extents, least: least - (least === 0 ? 0 : edge), most: most + edge });
    }

    makeElement() {
        const { panel } = this, figure = document.createElement('figure'), caption = figure.appendChild(document.createElement('figcaption'));
        const add = (parent, name, text = '') => Object.assign(parent.appendChild(document.createElement(name)), { textContent: text });
        const shared = panel.channels.every(c => c.unit === panel.channels[0].unit) ? panel.channels[0].unit : '';
        const heading = add(caption, 'h2', panel.name);
        if (shared) add(heading, 'small', shared);
        const legend = add(caption, 'ul');
        this.readings = panel.channels.map((channel, index) => {
            const item = add(legend, 'li');
            item.style.setProperty('--series', `var(--series-${index % 5})`);
            if (channel.name.toLowerCase() !== panel.name.toLowerCase()) add(item, 'span', channel.name);
            const reading = add(item, 'b');
            if (!shared && channel.unit) add(item, 'small', channel.unit);
            return reading;
        });
        this.canvas = add(figure, 'canvas');
        this.canvas.setAttribute('role', 'img');
        const words = panel.channels.map(({ name, unit }, index) =>
            `${name} from ${this.extents[index].map(value => valueText(value, this.most - this.least)).join(' to ')} ${unit}`);
        this.canvas.setAttribute('aria-label', `${panel.name} over time. ${words.join(', ')}.`);
        this.element = figure;
    }

    /// A mouse seeks at once; a finger once it goes sideways, or taps: up and down it scrolls.
    listen(seek) {
        const { canvas } = this;
        let from = null, seeking = false;
        const go = event => {
            const across = event.clientX - canvas.getBoundingClientRect().left - margins.left;
            seek(mix(this.from, this.to, clamp(across / (canvas.clientWidth - margins.left - margins.right), 0, 1)));
        };
        canvas.addEventListener('pointerdown', event => {
            from = this.held = event;
            seeking = event.pointerType === 'mouse';
            canvas.setPointerCapture(event.pointerId);
            if (seeking) go(event);
        });
        canvas.addEventListener('pointermove', event => {
            if (!from) return;
            const dx = Math.abs(event.clientX - from.clientX), dy = Math.abs(event.clientY - from.clientY);
            seeking = seeking || (dx > 6 && dx > dy);
            if (seeking) go(event);
        });
        canvas.addEventListener('pointerup', event => {
            if (from && (seeking || Math.abs(event.clientY - from.clientY) < 10)) go(event);
            from = this.held = null;
        });
        canvas.addEventListener('pointercancel', () => { from = this.held = null; });
    }

    /// Turns to the page with this time on it, but not under a hand that seeks.
    turnTo(time) {
        const { run } = this, last = run.end - stretch;
        if (last <= run.start + page / 2 || this.held) return;
        const from = clamp(run.start + page * Math.floor((time - run.start) / page - 0.5), run.start, last);
        if (from === this.from && this.to === from + stretch) return;
        Object.assign(this, { from, to: from + stretch });
        this.width = 0;
    }

    x(time) {
        const { from, to, width } = this;
        return margins.left + (time - from) / (to - from || 1) * (width - margins.left - margins.right);
    }
    y(value) {
        return mix(this.height - margins.bottom, margins.top, (value - this.least) / (this.most - this.least));
    }

    /// Draws axes and curves anew; needed when the size or the theme changes.
    prepare() {
        const sharpness = Math.min(window.devicePixelRatio || 1, 3), style = getComputedStyle(this.element);
        Object.assign(this, { width: this.canvas.clientWidth, height: this.canvas.clientHeight, sharpness });
        this.colour = name => style.getPropertyValue(name).trim();
        this.font = `11px ${style.fontFamily}`;
        for (const canvas of [this.canvas, this.axes, this.curves]) {
            canvas.width = Math.max(1, Math.round(this.width * sharpness));
            canvas.height = Math.max(1, Math.round(this.height * sharpness));
            canvas.getContext('2d').setTransform(sharpness, 0, 0, sharpness, 0, 0);
        }
        this.drawAxes(this.axes.getContext('2d'));
        this.drawCurves(this.curves.getContext('2d'));
    }

    drawAxes(pen) {
        const { run, width, height } = this, right = width - margins.right, bottom = height - margins.bottom;
        const rule = (x1, y1, x2, y2, colour) => {
            pen.strokeStyle = colour;
            pen.beginPath();
            pen.moveTo(x1, y1);
            pen.lineTo(x2, y2);
            pen.stroke();
        };
        pen.font = this.font;
        pen.fillStyle = this.colour('--muted');
        pen.textBaseline = 'middle';
        pen.textAlign = 'right';
        for (let n = Math.ceil(this.least / this.step); n * this.step <= this.most; ++n) {
            const y = Math.round(this.y(n * this.step)) + 0.5;
            rule(margins.left, y, right, y, this.colour(n === 0 ? '--axis' : '--rule'));
            pen.fillText(stepText(n, this.step), margins.left - 7, y);
        }
        pen.textBaseline = 'alphabetic';
        pen.textAlign = 'center';
        const step = roundStep(this.to - this.from || 1, Math.max(2, Math.floor((right - margins.left) / 60)));
        for (let n = Math.ceil(this.from / step); n * step <= this.to + 1e-6; ++n) {
            const x = this.x(n * step), text = stepText(n, step);
            rule(Math.round(x) + 0.5, bottom, Math.round(x) + 0.5, bottom + 3, this.colour('--axis'));
            pen.fillText(n === 0 || (n + 1) * step > this.to + 1e-6 ? `${text} s` : text, Math.min(x, width - 14), height - 3);
        }
        for (const { time } of run.events.filter(event => event.time >= this.from && event.time <= this.to)) rule(this.x(time), margins.top, this.x(time), bottom, this.colour('--event'));
    }

    /// A line is broken where the run was cut and where an angle goes round from one end of its range to the other.
    drawCurves(pen) {
        const { run } = this, first = run.frameAt(this.from), last = run.frameAt(this.to);
        pen.lineWidth = 1.6;
        pen.lineJoin = 'round';
        this.panel.channels.forEach(({ values, unit }, index) => {
            pen.strokeStyle = this.colour(`--series-${index % 5}`);
            pen.beginPath();
            for (let n = first; n <= last; ++n) {
                const value = values[n], around = unit === '°' && n > first && Math.abs(value - values[n - 1]) > 180;
                if (n === first || around || run.cuts.has(n)) pen.moveTo(this.x(run.time[n]), this.y(value));
                else pen.lineTo(this.x(run.time[n]), this.y(value));
            }
            pen.stroke();
        });
    }

    /// What is past is strong, what is to come is faint.
    paint(moment) {
        this.turnTo(moment.time);
        if (this.canvas.clientWidth !== this.width || this.canvas.clientHeight !== this.height) this.prepare();
        if (!this.width) return;
        const pen = this.canvas.getContext('2d'), { width, height, panel } = this, x = this.x(moment.time);
        pen.clearRect(0, 0, width, height);
        pen.drawImage(this.axes, 0, 0, width, height);
        pen.globalAlpha = 0.35;
        pen.drawImage(this.curves, 0, 0, width, height);
        pen.globalAlpha = 1;
        pen.save();
        pen.beginPath();
        pen.rect(0, 0, x, height);
        pen.clip();
        pen.drawImage(this.curves, 0, 0, width, height);
        pen.restore();
        pen.fillStyle = this.colour('--ink');
        pen.fillRect(Math.round(x) - 0.5, margins.top, 1, height - margins.top - margins.bottom);
        panel.channels.forEach(({ values, unit }, index) => {
            const value = this.valueAt(moment, values, unit);
            this.readings[index].textContent = valueText(value, this.most - this.least);
            pen.fillStyle = this.colour(`--series-${index % 5}`);
            pen.strokeStyle = this.colour('--paper');
            pen.lineWidth = 1.5;
            pen.beginPath();
            pen.arc(x, this.y(value), 3.5, 0, 7);
            pen.fill();
            pen.stroke();
        });
    }

    valueAt(moment, values, unit) {
        const value = moment.value(values), nearest = values[moment.frame];
        return unit === '°' && Math.abs(value - nearest) > 1 && Math.abs(values[moment.frame + 1] - nearest) > 180 ? nearest : value;
    }
}
