'use strict';
// The programs of the WebGL painter. Colours are mixed as they are seen on the screen.

const shaders = {
    /// Shared: the sky in a direction, and the haze that takes everything to the horizon.
    air: `
        uniform vec3 zenith, horizon, eye, sun;
        uniform float reach;  // m, of the sight
        vec3 sky(vec3 way) { return mix(horizon, zenith, pow(clamp(way.y, 0.0, 1.0), 0.55)); }
        vec3 haze(vec3 colour, vec3 world) {
            float d = distance(world, eye) / reach;
            return mix(colour, horizon, 1.0 - exp(-d * d));
        }`,

    /// A number of 0 … 1 for each cell, and its smooth interpolation.
    noise: `
        float scatter(vec2 cell) {
            vec3 p = fract(cell.xyx * 0.1031);
            p += dot(p, p.yzx + 33.33);
            return fract((p.x + p.y) * p.z);
        }
        float noise(vec2 p) {
            vec2 cell = floor(p), f = fract(p), s = f * f * (3.0 - 2.0 * f);
            return mix(mix(scatter(cell), scatter(cell + vec2(1, 0)), s.x), mix(scatter(cell + vec2(0, 1)), scatter(cell + vec2(1, 1)), s.x), s.y);
        }`,

    /// The land's colour: fields in rows with hedges between them, furrows and tufts, each gone where a pixel
    /// covers too much of it.
    fields: `
        uniform vec3 fields[4], hedge;
        float seen(float footprint, float size) { return 1.0 - smoothstep(0.25, 0.8, footprint / size); }
        vec3 land(vec2 at, vec3 mean) {
            vec2 w = fwidth(at), size = vec2(${fieldWidth}.0, ${fieldDepth}.0);
            float footprint = max(w.x, w.y), row = floor(at.y / size.y);
            vec2 place = vec2(at.x / size.x + 0.61 * row, at.y / size.y), cell = vec2(floor(place.x), row);
            float kind = scatter(cell + 7.0), way = scatter(cell + 31.0);
            vec3 tint = fields[int(min(kind * 4.0, 3.0))];
            float furrow = sin((way < 0.5 ? at.x + 0.2 * at.y : at.y - 0.15 * at.x) * 2.4) * seen(footprint, 1.2);
            tint *= 1.0 + 0.035 * furrow + 0.16 * (noise(at * 0.9) - 0.5) * seen(footprint, 1.1) + 0.12 * (noise(at * 0.11) - 0.5) * seen(footprint, 9.0);
            vec2 border = min(fract(place), 1.0 - fract(place)) * size;
            float edge = min(border.x, border.y) - 0.6 * noise(at * 0.7);
            tint = mix(tint, hedge, (1.0 - smoothstep(0.1, 0.4 + footprint, edge)) * seen(footprint, 12.0));
            return mix(mean, tint, seen(footprint, 40.0));
        }`,

    /// The sea's height at a place; a train too short for the mesh or the picture is left out bit by bit.
    /// waves: k.x, k.z, amplitude, phase − ω t.
    waves: count => `
        #define WAVES ${count}
        uniform vec4 waves[${Math.max(1, count)}];
        float sea(vec2 at) {
            float y = 0.0;
            for (int i = 0; i < WAVES; ++i) y += waves[i].z * sin(dot(waves[i].xy, at) + waves[i].w);
            return y;
        }`,

    /// The bodies' shadows around the first one, straight below them, from their silhouettes.
    shadow: `
        uniform vec4 shadow;  // middle x, z, half width, softness
        uniform sampler2D silhouette;
        float shadowAt(vec2 at) {
            vec2 uv = (at - shadow.xy) / shadow.z;
            if (max(abs(uv.x), abs(uv.y)) > 1.0) return 0.0;
            float sum = 0.0;
            for (int i = -2; i <= 2; ++i)
                for (int j = -2; j <= 2; ++j)
                    sum += texture(silhouette, uv * 0.5 + 0.5 + vec2(i, j) * shadow.w).r;
            return sum / 25.0;
        }`,

    sky: {
        vertex: () => `
            out vec2 at;
            void main() {
                at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
                gl_Position = vec4(at, 1.0, 1.0);
            }`,
        fragment: () => `${shaders.air}${shaders.noise}
            uniform vec3 right, up, ahead, foam;
            uniform float cloud;
            in vec2 at;
            out vec4 colour;
            float veil(vec2 p) {  // thin high clouds, to tell up from sideways by
                float sum = 0.0, share = 0.5;
                for (int i = 0; i < 5; ++i, share *= 0.5, p = mat2(1.6, 1.2, -1.2, 1.6) * p) sum += share * noise(p);
                return smoothstep(0.38, 0.78, sum);
            }
            void main() {
                vec3 way = normalize(ahead + at.x * right + at.y * up);
                float glow = pow(max(dot(way, sun), 0.0), 24.0) * 0.12;
                float white = way.y > 0.01 ? veil(way.xz / (way.y + 0.15) * vec2(2.4, 3.6)) * smoothstep(0.02, 0.35, way.y) * cloud : 0.0;
                colour = vec4(mix(sky(way) + glow, foam, white), 1.0);
            }`,
    },

    /// Ground and sea: one disc under the scene, its height and its normals from the waves.
    surface: {
        vertex: run => `${shaders.waves(run.waves.length)}
            layout(location = 0) in vec2 place;
            uniform mat4 viewProjection;
            uniform vec2 centre;
            out vec3 world;
            void main() {
                vec2 at = centre + place;
                world = vec3(at.x, sea(at) * (1.0 - smoothstep(150.0, 600.0, length(place))), at.y);
                gl_Position = viewProjection * vec4(world, 1.0);
            }`,
        fragment: run => `${shaders.air}${shaders.waves(run.waves.length)}${shaders.shadow}${shaders.noise}${shaders.fields}
            #define SEA ${run.sea ? 1 : 0}
            uniform vec3 near, far, line, foam, shade;
            uniform vec2 grid;
            uniform float glitter, time, size;
            in vec3 world;
            out vec4 colour;

            float lines(vec2 at, float cell, float width) {
                vec2 g = at / cell, w = fwidth(g);
                vec2 d = abs(fract(g - 0.5) - 0.5) / w;
                float visible = 1.0 - smoothstep(0.12, 0.45, max(w.x, w.y));
                return (1.0 - smoothstep(width - 0.5, width + 0.5, min(d.x, d.y))) * visible;
            }
            vec3 waterNormal(vec2 at) {
                vec2 slope = vec2(0.0);
                for (int i = 0; i < WAVES; ++i) {
                    float phase = dot(waves[i].xy, at) + waves[i].w;
                    slope += waves[i].xy * waves[i].z * cos(phase) * (1.0 - smoothstep(0.6, 2.4, fwidth(phase)));
                }
                for (int i = 0; i < 5; ++i) {  // ripples, too small to move anything
                    float turn = 2.4 * float(i), k = (2.1 + 0.9 * float(i)) / size;
                    vec2 way = vec2(cos(turn), sin(turn));
                    float phase = k * dot(way, at) - (4.5 + 0.75 * float(i)) / sqrt(size) * time + 1.7 * float(i);
                    slope += way * 0.022 * cos(phase) * (1.0 - smoothstep(0.4, 1.8, fwidth(phase)));
                }
                return normalize(vec3(-slope.x, 1.0, -slope.y));
            }
            void main() {
                vec3 base = near, toEye = normalize(eye - world);
                float strength = 0.3;
                if (SEA == 1) {
                    vec3 normal = waterNormal(world.xz);
                    float facing = max(dot(normal, toEye), 0.0);
                    vec3 mirrored = reflect(-toEye, normal);
                    mirrored.y = abs(mirrored.y);
                    vec3 body = mix(far, near, clamp(0.5 * facing + 2.2 * (normal.x + normal.z) + 0.15, 0.0, 1.0));
                    base = mix(body, sky(mirrored), 0.03 + 0.85 * pow(1.0 - facing, 4.0));
                    base += foam * glitter * pow(max(dot(mirrored, sun), 0.0), 260.0);
                    strength = 0.24;
                } else {
                    base = land(world.xz, near);
                }
                float fine = lines(world.xz, grid.x * 0.1, 0.5) * grid.y;
                float drawn = max(max(fine * 0.45, lines(world.xz, grid.x, 0.6)), lines(world.xz, grid.x * 10.0, 1.1) * 1.3);
                base = mix(base, line, min(drawn, 1.3) * strength * 0.75);
                base = mix(base, shade, shadowAt(world.xz) * (SEA == 1 ? 0.35 : 0.5));
                colour = vec4(haze(base, world), 1.0);
            }`,
    },

    /// Flat marks on the ground, which take shadows, and shadows themselves: `darkness` is 1 for those.
    paint: {
        vertex: () => `
            layout(location = 0) in vec3 place;
            layout(location = 2) in vec3 paint;
            uniform mat4 viewProjection;
            out vec3 world, tint;
            void main() {
                world = place + vec3(0.0, 0.02, 0.0);  // clear of the ground
                tint = paint;
                gl_Position = viewProjection * vec4(world, 1.0);
            }`,
        fragment: () => `${shaders.air}${shaders.shadow}
            uniform vec3 shade;
            uniform float ambient, sunlight, darkness, opacity;
            in vec3 world, tint;
            out vec4 colour;
            void main() {
                vec3 lit = tint * (ambient + 0.08 + sunlight * sun.y);
                colour = vec4(haze(mix(lit, shade, max(darkness, shadowAt(world.xz) * 0.5)), world), opacity);
            }`,
    },

    /// Flat-shaded solids, and arrows, which take one colour and little shading.
    solid: {
        vertex: () => `
            layout(location = 0) in vec3 place;
            layout(location = 1) in vec3 front;
            layout(location = 2) in vec3 paint;
            uniform mat4 model, viewProjection;
            out vec3 world, normal, tint;
            void main() {
                world = (model * vec4(place, 1.0)).xyz;
                normal = mat3(model) * front;
                tint = paint;
                gl_Position = viewProjection * vec4(world, 1.0);
            }`,
        fragment: () => `${shaders.air}
            uniform vec4 ink;  // a colour, and how much of it
            uniform float ambient, sunlight, opacity, thin;  // thin: what shines through from behind
            in vec3 world, normal, tint;
            out vec4 colour;
            void main() {
                vec3 n = normalize(gl_FrontFacing ? normal : -normal);
                float facing = dot(n, sun), light = ambient + 0.08 * n.y + sunlight * max(facing, -thin * facing);
                vec3 lit = mix(tint * light, ink.rgb * mix(1.0, light, 0.35), ink.a);
                colour = vec4(haze(lit, world), opacity);
            }`,
    },

    /// The bodies seen from straight above, in white.
    silhouette: {
        vertex: () => `
            layout(location = 0) in vec3 place;
            uniform mat4 model;
            uniform vec3 frame;  // middle x, z, half width
            void main() {
                vec3 world = (model * vec4(place, 1.0)).xyz;
                gl_Position = vec4((world.xz - frame.xy) / frame.z, 0.0, 1.0);
            }`,
        fragment: () => `
            out vec4 colour;
            void main() { colour = vec4(1.0); }`,
    },

    /// Pieces of line, some pixels wide: the way flown, strong up to now and faint after, faded by age.
    trail: {
        vertex: run => `${shaders.waves(run.waves.length)}
            layout(location = 0) in vec4 from;  // x, y, z, time
            layout(location = 1) in vec4 to;
            uniform mat4 viewProjection;
            uniform vec2 picture;  // pixels
            uniform float width, lift;
            out float when;
            vec4 placed(vec3 p) {
                if (${run.sea ? 'true' : 'false'}) p.y = sea(p.xz) + lift;
                return viewProjection * vec4(p, 1.0);
            }
            void main() {
                vec4 a = placed(from.xyz), b = placed(to.xyz);
                float least = 0.02;
                if (a.w < least && b.w > least) a = mix(a, b, (least - a.w) / (b.w - a.w));
                if (b.w < least && a.w > least) b = mix(b, a, (least - b.w) / (a.w - b.w));
                vec2 along = (b.xy / b.w - a.xy / a.w) * picture;
                along = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
                bool second = (gl_VertexID & 2) != 0;
                vec4 end = second ? b : a;
                float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
                end.xy += (vec2(-along.y, along.x) * side + along * (second ? 0.3 : -0.3)) * width / picture * end.w;
                when = second ? to.w : from.w;
                gl_Position = end;
            }`,
        fragment: () => `
            uniform vec3 pen;
            uniform float now, past, future, faintest, fadeTime;
            in float when;
            out vec4 colour;
            void main() {
                float fresh = mix(faintest, 1.0, exp(-abs(when - now) / fadeTime));
                colour = vec4(pen, fresh * (when <= now ? past : future));
            }`,
    },
};
