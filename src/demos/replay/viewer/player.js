'use strict';
// Plays the run: the clock, the controls, the keyboard, the link's wishes.

const $ = id => document.getElementById(id);
const speeds = [0.25, 0.5, 1, 2, 4];

class Player {
    constructor(run) {
        this.run = run;
        this.time = run.start;
        this.playing = false;
        this.speed = 1;
        this.loop = true;
        this.shown = -1;
        this.changed = () => { this.dirty = true; };
        this.tell();
        this.stage = new Stage(run, this.changed);
        this.plots = [];
        this.listenToControls();
        this.listenToKeys();
        this.followTheme();
        this.setCamera(run.flat ? 'orbit' : 'chase');
        if (!matchMedia('(prefers-reduced-motion: reduce)').matches) this.play(true);
        this.obey(location.hash);
        window.addEventListener('hashchange', () => this.obey(location.hash));
        const resized = new ResizeObserver(() => this.show(performance.now()));
        for (const id of ['stage', 'plots']) resized.observe($(id));
        requestAnimationFrame(now => this.tick(now));
    }

    // What the page says in words

    tell() {
        const { run } = this;
        document.title = run.title;
        $('title').textContent = run.title;
        $('kind').textContent = run.kind;
        $('scrub').min = run.start;
        $('scrub').max = run.end;
        this.listEvents();
        this.layOutSummary();
    }

    listEvents() {
        const { events, start, end } = this.run;
        $('eventSection').hidden = events.length === 0;
        for (const event of events) {
            const button = document.createElement('button'), time = document.createElement('time');
            button.type = 'button';
            time.textContent = `${event.time.toFixed(1)} s`;
            button.append(time, event.text);
            button.addEventListener('click', () => this.seek(event.time));
            event.item = $('events').appendChild(document.createElement('li'));
            event.item.append(button);
            const tick = $('ticks').appendChild(document.createElement('i'));
            tick.style.left = `${100 * clamp((event.time - start) / (end - start || 1), 0, 1)}%`;
        }
    }

    /// A line "name: value" becomes a row of a table, any other line a paragraph.
    layOutSummary() {
        const lines = this.run.summary.split('\n').map(line => line.trim()).filter(Boolean);
        $('summarySection').hidden = lines.length === 0;
        let table = null;
        for (const line of lines) {
            const row = /^([^:]{1,40}):\s+(.+)$/.exec(line);
            if (row) {
                table = table || $('summary').appendChild(document.createElement('dl'));
                table.appendChild(document.createElement('dt')).textContent = row[1];
                table.appendChild(document.createElement('dd')).textContent = row[2];
            } else {
                table = null;
                $('summary').appendChild(document.createElement('p')).textContent = line;
            }
        }
    }

    // What can be done

    play(playing) {
        if (playing && this.time >= this.run.end) this.seek(this.run.start);
        this.playing = playing;
        document.body.classList.toggle('playing', playing);
        $('play').setAttribute('aria-label', playing ? 'Pause' : 'Play');
    }

    seek(time) {
        this.time = clamp(time, this.run.start, this.run.end);
        this.changed();
    }
    toEnd() {
        this.play(false);
        this.seek(this.run.end);
    }
    step(frames) {
        this.play(false);
        this.seek(this.run.time[clamp(this.run.frameAt(this.time + 1e-6) + frames, 0, this.run.count - 1)]);
    }

    setSpeed(speed) {
        this.speed = speed;
        $('speed').value = speed;
    }
    changeSpeed(by) { this.setSpeed(speeds[clamp(speeds.indexOf(this.speed) + by, 0, speeds.length - 1)]); }

    setCamera(name) {
        this.stage.cameras.choose(name, performance.now());
        for (const input of document.querySelectorAll('#cameras input')) input.checked = input.value === name;
        this.changed();
    }
    nextCamera() {
        const { names, mode } = this.stage.cameras;
        this.setCamera(names[(names.indexOf(mode) + 1) % names.length]);
    }

    setArrows(shown) {
        $('arrows').checked = shown;
        this.changed();
    }
    setLoop(loop) {
        this.loop = loop;
        $('loop').setAttribute('aria-pressed', loop);
    }

    setTheme(theme) {
        document.documentElement.dataset.theme = theme;
        this.plots.forEach(plot => plot.prepare());
        this.changed();
    }
    get theme() { return document.documentElement.dataset.theme; }
    toggleTheme() {
        this.ownTheme = true;
        this.setTheme(this.theme === 'dark' ? 'light' : 'dark');
    }
    followTheme() {
        const dark = matchMedia('(prefers-color-scheme: dark)');
        const follow = () => { if (!this.ownTheme) this.setTheme(dark.matches ? 'dark' : 'light'); };
        dark.addEventListener('change', follow);
        follow();
    }

    toggleHelp() {
        if ($('help').open) $('help').close(); else $('help').showModal();
    }

    /// A link may say #t=12&camera=side&theme=dark&speed=2&play=0&arrows=0&zoom=0.5&turn=90.
    obey(hash) {
        const wish = new URLSearchParams(hash.slice(1)), number = name => Number(wish.get(name));
        if (wish.has('theme')) this.ownTheme = true;
        if (['light', 'dark'].includes(wish.get('theme'))) this.setTheme(wish.get('theme'));
        if (this.stage.cameras.names.includes(wish.get('camera'))) this.setCamera(wish.get('camera'));
        if (speeds.includes(number('speed'))) this.setSpeed(number('speed'));
        if (wish.has('arrows')) this.setArrows(wish.get('arrows') !== '0');
        if (number('zoom') > 0) this.stage.zoom(number('zoom'));
        if (Number.isFinite(number('turn'))) this.stage.cameras.turn(number('turn') * Math.PI / 180, 0);
        if (wish.has('t') && Number.isFinite(number('t'))) this.seek(number('t'));
        if (wish.has('t') || wish.has('play')) this.play(wish.get('play') === '1');
    }

    // What listens

    listenToControls() {
        $('play').addEventListener('click', () => this.play(!this.playing));
        $('loop').addEventListener('click', () => this.setLoop(!this.loop));
        $('theme').addEventListener('click', () => this.toggleTheme());
        $('helpButton').addEventListener('click', () => this.toggleHelp());
        $('help').addEventListener('click', event => { if (event.target === $('help')) $('help').close(); });
        $('speed').addEventListener('change', () => this.setSpeed(Number($('speed').value)));
        $('arrows').addEventListener('change', this.changed);
        $('scrub').addEventListener('input', () => this.seek(Number($('scrub').value)));
        $('cameras').addEventListener('change', event => this.setCamera(event.target.value));
    }

    listenToKeys() {
        const second = event => (event.shiftKey ? 5 : 1);
        const keys = {
            ' ': () => this.play(!this.playing), 'arrowleft': e => this.seek(this.time - second(e)), 'arrowright': e => this.seek(this.time + second(e)),
            'arrowup': () => this.stage.zoom(0.9), 'arrowdown': () => this.stage.zoom(1 / 0.9), ',': () => this.step(-1), '.': () => this.step(1),
            '[': () => this.changeSpeed(-1), '-': () => this.changeSpeed(-1), ']': () => this.changeSpeed(1), '+': () => this.changeSpeed(1),
            '=': () => this.changeSpeed(1), 'home': () => this.seek(this.run.start), 'end': () => this.toEnd(),
            'c': () => this.nextCamera(), 'r': () => this.stage.reset(), 'a': () => this.setArrows(!$('arrows').checked), 'l': () => this.setLoop(!this.loop),
            't': () => this.toggleTheme(), 'h': () => this.toggleHelp(), '?': () => this.toggleHelp(),
        };
        document.addEventListener('keydown', event => {
            const key = event.key.toLowerCase(), { target } = event, own = target.matches('select, [type=radio]');
            if (event.ctrlKey || event.altKey || event.metaKey || !keys[key]) return;
            if ($('help').open && key !== 'h') return;
            if (key === ' ' && target.matches('button, select, [type=checkbox], [type=radio]')) return;
            if (key.startsWith('arrow') && own) return;
            event.preventDefault();
            keys[key](event);
        });
    }

    // The clock

    tick(now) {
        requestAnimationFrame(later => this.tick(later));
        const passed = clamp((now - (this.before ?? now)) / 1000, 0, 0.2);
        this.before = now;
        if (this.playing) this.advance(passed * this.speed);
        if (!this.dirty && !this.stage.cameras.gliding) return;
        this.dirty = false;
        this.show(now);
        this.addPlot();
    }

    /// One after each picture, so that a long run plays while its channels are still being unpacked.
    addPlot() {
        const panel = this.run.panels[this.plots.length];
        if (!panel) return;
        const plot = new Plot(this.run, panel, time => this.seek(time));
        this.plots.push(plot);
        $('plots').append(plot.element);
        this.changed();
    }

    advance(seconds) {
        const { start, end } = this.run, time = this.time + seconds;
        if (time < end) this.seek(time);
        else if (this.loop && end > start) this.seek(start);
        else {
            this.seek(end);
            this.play(false);
        }
    }

    show(now) {
        const { run, time } = this, moment = run.at(time);
        this.stage.paint(moment, this.theme, $('arrows').checked, now);
        for (const plot of this.plots) plot.paint(moment);
        $('scrub').value = time;
        $('scrub').style.setProperty('--done', `${100 * (time - run.start) / (run.end - run.start || 1)}%`);
        $('scrub').setAttribute('aria-valuetext', `${time.toFixed(1)} seconds`);
        $('clock').textContent = `${time.toFixed(1)} / ${run.end.toFixed(1)} s`;
        this.showEvents(time);
    }

    /// The last event stands under the scene for three seconds.
    showEvents(time) {
        const past = this.run.events.filter(event => event.time <= time + 1e-6), last = past[past.length - 1];
        const text = last && time - last.time < 3 ? last.text : '';
        if ($('caption').textContent !== text) $('caption').textContent = text;
        for (const event of this.run.events) event.item.classList.toggle('now', event === last);
    }
}

const recorded = $('recording').textContent.trim();
new Player(new Run(recorded ? JSON.parse(recorded) : sampleRecording()));
