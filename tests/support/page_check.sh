#!/bin/bash
# Loads a page in headless Chromium, with WebGL, without and on a phone, lets it run for some seconds, and fails on an
# error in the console, an uncaught exception, a fetched resource, a canvas with nothing on it, plots that keep the scene
# waiting, a page wider than its window, or a wind that is never named in the picture.
#
#   page_check.sh PAGE.html...        (CHROMIUM: the browser, by default `chromium`)

set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Runs before the page's own scripts and leaves its findings on the root element.
cat >"$work/watch.html" <<'SCRIPT'
<script>
(() => {
    const faults = [], alive = new Set(), small = document.createElement('canvas');
    small.width = small.height = 48;
    const pen = small.getContext('2d', { willReadFrequently: true });
    const fault = text => faults.push(String(text).replace(/\s+/g, ' '));
    addEventListener('error', event => fault(event.message || 'a resource failed to load'), true);
    addEventListener('unhandledrejection', event => fault(event.reason));
    const say = console.error;
    console.error = (...words) => { fault(words.join(' ')); say(...words); };

    // Where there is a wind, its name must once stand in the picture, below the buttons. (A flat view is so wide that
    // its arrow may be too short for a name.)
    let windSeen = false, plotsFirst = null;
    const lookForWind = () => {
        const name = [...document.querySelectorAll('#labels span')].find(span => !span.hidden && span.textContent.startsWith('wind'));
        const lowest = Math.max(...[...document.querySelectorAll('#stage .pill')].map(pill => pill.getBoundingClientRect().bottom));
        windSeen = windSeen || (name !== undefined && name.getBoundingClientRect().top >= lowest);
    };
    const blows = () => {
        const recording = JSON.parse(document.getElementById('recording').textContent);
        return !recording.flat && recording.windspeed.some(axis => axis !== 0);
    };

    // A canvas can be read in the same frame in which it was painted.
    const look = canvas => {
        if (alive.has(canvas) || !canvas.width || !canvas.height) return;
        pen.clearRect(0, 0, 48, 48);
        pen.drawImage(canvas, 0, 0, 48, 48);
        const pixels = new Uint32Array(pen.getImageData(0, 0, 48, 48).data.buffer);
        if (pixels.some(pixel => pixel !== pixels[0])) alive.add(canvas);
    };
    const later = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = paint => later(now => {
        paint(now);
        document.querySelectorAll('canvas').forEach(look);
        lookForWind();
        if (alive.has(document.getElementById('scene'))) plotsFirst ??= document.querySelectorAll('#plots canvas').length;
    });

    setInterval(() => {
        const canvases = [...document.querySelectorAll('canvas')].filter(canvas => canvas.clientWidth > 0);
        const fetched = performance.getEntriesByType('resource').map(entry => entry.name).filter(name => !name.startsWith('data:'));
        const found = [...faults, ...fetched.map(name => `fetched ${name}`)];
        if (canvases.length === 0) found.push('there is no canvas');
        for (const canvas of canvases)
            if (!alive.has(canvas)) found.push(`empty canvas ${canvas.id || canvas.getAttribute('aria-label') || ''}`);
        if (plotsFirst > 1) found.push(`${plotsFirst} plots came before the scene`);
        if (document.documentElement.scrollWidth > innerWidth) found.push(`wider than the window of ${innerWidth}`);
        if (!windSeen && blows()) found.push('no wind is named');
        document.documentElement.dataset.pageCheck = found.length ? `faults: ${found.join('; ')}` : `ok, ${canvases.length} canvases`;
    }, 100);
})();
</script>
SCRIPT

# check PAGE NAME FLAG...
check() {
    local page=$1 name=$2 dom verdict
    shift 2
    sed -e "0,/<head>/{/<head>/r $work/watch.html
}" "$page" >"$work/page.html"
    dom=$(timeout 120 "${CHROMIUM:-chromium}" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run \
        --disable-background-networking --disable-component-update --disable-sync --user-data-dir="$work/profile-$name" \
        --window-size=900,700 --virtual-time-budget=20000 "$@" --dump-dom "file://$work/page.html" 2>"$work/stderr") || {
        cat "$work/stderr" >&2
        echo "$page: the browser failed" >&2
        return 1
    }
    verdict=$(grep -o -m1 'data-page-check="[^"]*"' <<<"$dom" | cut -d'"' -f2) || verdict='faults: it never ran'
    case $verdict in
        ok*) echo "$page ($name): $verdict" ;;
        *)
            echo "$page ($name): $verdict" >&2
            return 1
            ;;
    esac
}

# On a busy machine a page may be starved of time: it has a second chance.
check_twice() { check "$@" 2>/dev/null || check "$@"; }

[ $# -gt 0 ] || { echo "usage: page_check.sh PAGE.html..." >&2; exit 2; }
status=0
for page in "$@"; do
    [ -r "$page" ] || { echo "page_check.sh: cannot read $page" >&2; exit 2; }
    check_twice "$page" webgl --use-angle=swiftshader --enable-unsafe-swiftshader || status=1
    check_twice "$page" plain --disable-3d-apis || status=1
    check_twice "$page" phone --disable-3d-apis --window-size=390,844 || status=1
done
exit $status
