'use strict';
// Paints the scene with WebGL 2.

class SolidPainter {
    /// null where the browser has no WebGL 2.
    static on(canvas, run) {
        const gl = canvas.getContext('webgl2', { antialias: true, alpha: false, stencil: true, powerPreference: 'low-power' });
        return gl && new SolidPainter(gl, run);
    }

    constructor(gl, run) {
        Object.assign(this, { gl, run, programs: {}, uniforms: {} });
        for (const name of ['sky', 'surface', 'paint', 'solid', 'silhouette', 'trail']) this.build(name);
        this.parts = run.parts.map(part => this.mesh(SolidPainter.triangles(part.faces)));
        this.fixtures = run.fixtures.map(part => this.mesh(SolidPainter.triangles(part.faces)));
        this.marks = this.mesh(SolidPainter.triangles(run.paint));
        this.casts = this.mesh(SolidPainter.triangles(run.fixtures.flatMap(part => part.faces).map(SolidPainter.flattened)));
        this.shaft = this.mesh(SolidPainter.triangles(SolidPainter.prism(1)));
        this.head = this.mesh(SolidPainter.triangles(SolidPainter.prism(0)));
        this.disc = this.makeDisc();
        const { path, plumbs } = trailsOf(run);
        this.path = this.pieces(path);
        this.plumbs = this.pieces(plumbs);
        this.shadow = this.makeShadow(512);
        this.nothing = gl.createVertexArray();
    }

    // Making

    build(name) {
        const { gl, run } = this, program = gl.createProgram();
        for (const [type, source] of [[gl.VERTEX_SHADER, 'vertex'], [gl.FRAGMENT_SHADER, 'fragment']]) {
            const shader = gl.createShader(type);
            gl.shaderSource(shader, `#version 300 es\nprecision highp float;\n${shaders[name][source](run)}`);
            gl.compileShader(shader);
            if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost())
                throw new Error(`${name} ${source}: ${gl.getShaderInfoLog(shader)}`);
            gl.attachShader(program, shader);
        }
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
            throw new Error(`${name}: ${gl.getProgramInfoLog(program)}`);
        this.programs[name] = program;
        this.uniforms[name] = new Map();
        const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) || 0;
        for (let i = 0; i < count; ++i) {
            const info = gl.getActiveUniform(program, i);
            this.uniforms[name].set(info.name.replace('[0]', ''),
                { location: gl.getUniformLocation(program, info.name), type: info.type });
        }
    }

    /// Nine numbers a corner: place, normal, colour.
    static triangles(faces) {
        const numbers = [];
        for (const { corners, colour } of faces) {
            const normal = Vec.normal(corners), paint = rgb(colour);
            for (let i = 2; i < corners.length; ++i)
                for (const corner of [corners[0], corners[i - 1], corners[i]]) numbers.push(...corner, ...normal, ...paint);
        }
        return numbers;
    }

    /// A face's shadow on the land, straight below it.
    static flattened(face) { return { ...face, corners: face.corners.map(([x, , z]) => [x, 0, z]) }; }

    /// A unit prism along +X: a cylinder, or with a top of width 0 a cone.
    static prism(top) {
        const faces = [], sides = 12, colour = '#ffffff';
        const ring = (i, x, r) => [x, r * Math.cos(2 * Math.PI * i / sides), r * Math.sin(2 * Math.PI * i / sides)];
        for (let i = 0; i < sides; ++i) {
            faces.push({ colour, corners: [ring(i, 0, 1), ring(i + 1, 0, 1), ring(i + 1, 1, top), ring(i, 1, top)] });
            faces.push({ colour, corners: [[0, 0, 0], ring(i + 1, 0, 1), ring(i, 0, 1)] });
        }
        return faces;
    }

    /// A vertex array of floats; `layout` lists how many belong to each attribute.
    vertices(numbers, layout, divisor = 0) {
        const { gl } = this, array = gl.createVertexArray(), stride = layout.reduce((a, b) => a + b, 0);
        gl.bindVertexArray(array);
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
        let offset = 0;
        layout.forEach((size, attribute) => {
            gl.enableVertexAttribArray(attribute);
            gl.vertexAttribPointer(attribute, size, gl.FLOAT, false, 4 * stride, 4 * offset);
            gl.vertexAttribDivisor(attribute, divisor);
            offset += size;
        });
        return { array, count: numbers.length / stride };
    }
    mesh(numbers) { return this.vertices(numbers, [3, 3, 3]); }
    pieces(list) { return this.vertices(list.flatMap(([a, b, from, to]) => [...a, from, ...b, to]), [4, 4], 1); }

    /// Rings that grow wider outwards, to the horizon.
    makeDisc() {
        const { gl } = this, sectors = 160, radii = [0];
        for (let step = 0.4, r = 0; r < 30000; step *= step < 0.8 ? 1.01 : 1.05) radii.push(r += step);
        const numbers = [], indices = [];
        for (const r of radii)
            for (let i = 0; i < sectors; ++i) numbers.push(r * Math.cos(2 * Math.PI * i / sectors), r * Math.sin(2 * Math.PI * i / sectors));
        for (let ring = 0; ring + 1 < radii.length; ++ring)
            for (let i = 0; i < sectors; ++i) {
                const a = ring * sectors + i, b = ring * sectors + (i + 1) % sectors;
                indices.push(a, a + sectors, b, b, a + sectors, b + sectors);
            }
        const disc = this.vertices(numbers, [2]);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(indices), gl.STATIC_DRAW);
        return { array: disc.array, count: indices.length };
    }

    makeShadow(size) {
        const { gl } = this, texture = gl.createTexture(), frame = gl.createFramebuffer();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, size, size, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
        for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR],
            [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) gl.texParameteri(gl.TEXTURE_2D, name, value);
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        return { texture, frame, size };
    }

    // Painting

    /// Sets what the program asks for out of `values`, and leaves the rest as it is.
    use(name, values) {
        const { gl } = this;
        if (this.current !== name) gl.useProgram(this.programs[name]);
        this.current = name;
        for (const key in values) {
            const uniform = this.uniforms[name].get(key);
            if (!uniform) continue;
            const { location, type } = uniform, value = values[key];
            if (type === gl.FLOAT_MAT4) gl.uniformMatrix4fv(location, false, value);
            else if (type === gl.FLOAT_VEC4) gl.uniform4fv(location, value);
            else if (type === gl.FLOAT_VEC3) gl.uniform3fv(location, value);
            else if (type === gl.FLOAT_VEC2) gl.uniform2fv(location, value);
            else if (type === gl.SAMPLER_2D) gl.uniform1i(location, value);
            else gl.uniform1f(location, value);
        }
    }

    paint({ view, moment, look, arrows, width, height }) {
        const { gl, run } = this, distance = Vec.size(Vec.sub(view.eye, view.target));
        const near = run.flat ? 0.5 * distance : clamp(0.05 * distance, 0.02 * run.radius, 2);
        const camera = Mat.look(view.eye, view.target);
        const viewProjection = Mat.multiply(Mat.perspective(view.fov, width / height, near, 40000), camera);
        const pixel = 2 * Math.tan(view.fov / 2) / height;
        const shared = {
            reach: run.space ? 1e9 : Math.max(1500, 8 * distance),
            viewProjection, eye: view.eye, sun, zenith: rgb(run.space ? look.space : look.zenith),
            horizon: rgb(run.space ? look.space : look.horizon), ambient: look.ambient, sunlight: look.sunlight,
            foam: rgb(look.foam), cloud: run.space ? 0 : look.cloud, picture: [width, height], opacity: 1, ink: [0, 0, 0, 0], time: moment.time,
            waves: run.waves.length ? run.waves.flatMap(w => [...w.k, w.amplitude, w.phase - w.frequency * moment.time]) : [0, 0, 0, 0],
        };
        const matrices = moment.poses.map(Mat.ofPose);
        const shadow = this.castShadow(moment, matrices);

        gl.viewport(0, 0, width, height);
        gl.clear(gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
        this.paintSky(shared, camera, view.fov, width / height);
        gl.enable(gl.DEPTH_TEST);
        if (!run.space) {
            this.paintSurface(shared, view, look, shadow, height);
            this.paintMarks(shared, look, shadow);
            if (!run.sea) this.paintCasts(shared, look);
        }
        this.paintFixtures(shared);
        this.paintParts(shared, matrices);
        this.paintTrail(shared, look, moment.time, height);
        this.paintArrows(shared, arrows, view.eye, pixel);
        gl.disable(gl.DEPTH_TEST);
    }

    castShadow(moment, matrices) {
        const { gl, run, shadow } = this, body = moment.poses[0].position;
        const high = Math.max(0, body[1] / run.radius - 1), half = 1.25 * run.radius;
        gl.bindFramebuffer(gl.FRAMEBUFFER, shadow.frame);
        gl.viewport(0, 0, shadow.size, shadow.size);
        gl.clearColor(0, 0, 0, 1);
        gl.clear(gl.COLOR_BUFFER_BIT);
        run.parts.forEach((part, index) => {
            if (part.ghost) return;
            this.use('silhouette', { model: matrices[index], frame: [body[0], body[2], half] });
            this.draw(this.parts[index]);
        });
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        return [body[0], body[2], half, clamp(0.003 + 0.0006 * high, 0.003, 0.02)];
    }

    paintSky(shared, camera, fov, aspect) {
        const row = r => [camera[r], camera[4 + r], camera[8 + r]], tall = Math.tan(fov / 2);
        this.use('sky', { ...shared, right: Vec.scale(row(0), tall * aspect), up: Vec.scale(row(1), tall), ahead: Vec.scale(row(2), -1) });
        this.gl.bindVertexArray(this.nothing);
        this.gl.drawArrays(this.gl.TRIANGLES, 0, 3);
    }

    paintSurface(shared, view, look, shadow, height) {
        const { gl, run } = this, grid = gridAt(view, height);
        gl.bindTexture(gl.TEXTURE_2D, this.shadow.texture);
        gl.enable(gl.POLYGON_OFFSET_FILL);
        gl.polygonOffset(1, 4);
        const [near, far] = run.sea ? [look.shallow, look.deep] : [look.ground, look.ground];
        this.use('surface', {
            ...shared, near: rgb(near), far: rgb(far), line: rgb(run.sea ? look.foam : look.line), shade: rgb(look.shadow),
            fields: look.fields.flatMap(rgb), hedge: rgb(look.hedge), glitter: look.glitter, grid: [grid.cell, grid.fine], shadow, silhouette: 0, size: Math.max(0.4, 0.3 * run.radius),
            centre: [0, 2].map(axis => (view.eye[axis] + view.target[axis]) / 2),
        });
        gl.bindVertexArray(this.disc.array);
        gl.drawElements(gl.TRIANGLES, this.disc.count, gl.UNSIGNED_INT, 0);
        gl.disable(gl.POLYGON_OFFSET_FILL);
    }

    /// The later upon the earlier.
    paintMarks(shared, look, shadow) {
        const { gl } = this;
        gl.depthMask(false);
        this.use('paint', { ...shared, shade: rgb(look.shadow), shadow, silhouette: 0, darkness: 0 });
        this.draw(this.marks);
        gl.depthMask(true);
    }

    /// The fixtures' shadows, each spot darkened once.
    paintCasts(shared, look) {
        const { gl } = this;
        gl.depthMask(false);
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
        gl.enable(gl.STENCIL_TEST);
        gl.stencilFunc(gl.EQUAL, 0, 255);
        gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
        this.use('paint', { ...shared, shade: rgb(look.shadow), darkness: 1, opacity: 0.35 });
        this.draw(this.casts);
        gl.disable(gl.STENCIL_TEST);
        gl.disable(gl.BLEND);
        gl.depthMask(true);
    }

    paintFixtures(shared) {
        this.use('solid', shared);
        const model = Mat.frame([1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]);
        this.run.fixtures.forEach((part, index) => this.paintPart(part, this.fixtures[index], model));
    }

    /// Last what one sees through.
    paintParts(shared, matrices) {
        const { gl, run } = this;
        this.use('solid', shared);
        for (const ghost of [false, true]) {
            if (ghost) {
                this.use('solid', { opacity: 0.35 });
                gl.enable(gl.BLEND);
                gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
                gl.depthMask(false);
            }
            run.parts.forEach((part, index) => { if (part.ghost === ghost) this.paintPart(part, this.parts[index], matrices[index]); });
        }
        gl.depthMask(true);
        gl.disable(gl.BLEND);
    }

    paintPart(part, mesh, model) {
        const { gl } = this;
        if (!part.twoSided) gl.enable(gl.CULL_FACE);
        this.use('solid', { model, thin: part.twoSided ? 0.7 : 0 });
        this.draw(mesh);
        gl.disable(gl.CULL_FACE);
    }

    paintTrail(shared, look, now, height) {
        const { gl } = this, unit = height / 700;
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
        gl.depthMask(false);
        const pen = { ...shared, pen: rgb(look.trail), now, fadeTime, faintest: faintest(this.run), lift: 0.02 * this.run.radius };
        this.use('trail', { ...pen, width: Math.max(1, 1.1 * unit), past: 0.3, future: 0 });
        this.drawPieces(this.plumbs);
        this.use('trail', { ...pen, width: Math.max(1.4, 2.2 * unit), past: 0.8, future: 0.16 });
        this.drawPieces(this.path);
        gl.depthMask(true);
        gl.disable(gl.BLEND);
    }

    /// First, faintly, what of them is hidden; then what is seen. In a flat scene they lie on top.
    paintArrows(shared, arrows, eye, pixel) {
        const { gl } = this;
        gl.enable(gl.BLEND);
        this.use('solid', { ...shared, thin: 0 });
        const passes = this.run.flat ? [[gl.ALWAYS, 1]] : [[gl.GREATER, 0.22], [gl.LESS, 1]];
        for (const [test, opacity] of passes) {
            gl.depthFunc(test);
            gl.depthMask(opacity === 1);
            for (const arrow of arrows) this.paintArrow(arrow, Vec.size(Vec.sub(arrow.tail, eye)) * pixel, opacity);
        }
        gl.depthFunc(gl.LESS);
        gl.depthMask(true);
        gl.disable(gl.BLEND);
    }

    paintArrow(arrow, pixel, opacity) {
        const length = Vec.size(arrow.vector);
        if (length < 2 * pixel) return;
        const along = Vec.unit(arrow.vector), across = Vec.unit(Vec.cross(along, Math.abs(along[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
        const other = Vec.cross(along, across), unit = pixel * this.gl.drawingBufferHeight / 700;
        const tip = Math.min(15 * unit, 0.5 * length), scale = tip / (15 * unit);
        const model = (from, size, radius) => Mat.frame(Vec.scale(along, size), Vec.scale(across, radius), Vec.scale(other, radius),
            Vec.mad(arrow.tail, along, from));
        const ink = [...rgb(arrow.colour), 1];
        this.use('solid', { model: model(0, length - tip, 1.7 * unit * scale), ink, opacity });
        this.draw(this.shaft);
        this.use('solid', { model: model(length - tip, tip, 5.5 * unit * scale) });
        this.draw(this.head);
    }

    draw(mesh) {
        this.gl.bindVertexArray(mesh.array);
        this.gl.drawArrays(this.gl.TRIANGLES, 0, mesh.count);
    }
    drawPieces(pieces) {
        this.gl.bindVertexArray(pieces.array);
        this.gl.drawArraysInstanced(this.gl.TRIANGLE_STRIP, 0, 4, pieces.count);
    }
}
