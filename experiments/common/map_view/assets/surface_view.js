// Vertex arrays of one program: attributes by name, as [numbers an element, data].
class Batch {
  constructor(gl, program, attributes, divisor) {
    this.gl = gl;
    this.program = program;
    this.array = gl.createVertexArray();
    this.buffers = [];
    this.count = 0;
    gl.bindVertexArray(this.array);
    for (const [name, [size, data]] of Object.entries(attributes)) {
      const place = gl.getAttribLocation(program, name);
      const buffer = gl.createBuffer();
      this.buffers.push(buffer);
      this.count = data.length / size;
      if (place < 0) continue;
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 0, 0);
      gl.vertexAttribDivisor(place, divisor);
    }
  }

  use(uniforms) {
    const { gl, program } = this;
    gl.useProgram(program);
    gl.bindVertexArray(this.array);
    for (const [name, value] of Object.entries(uniforms)) {
      const place = gl.getUniformLocation(program, name);
      if (place === null) continue;
      if (["shading", "wire", "scales", "tile", "lattice"].includes(name)) gl.uniform1i(place, value);
      else if (name === "turn") gl.uniformMatrix3fv(place, false, value);
      else if (typeof value === "number") gl.uniform1f(place, value);
      else gl[`uniform${value.length}f`](place, ...value);
    }
  }

  free() {
    this.gl.deleteVertexArray(this.array);
    for (const buffer of this.buffers) this.gl.deleteBuffer(buffer);
  }
}

// The product of two 3 x 3 matrices, columns first.
function multiply(a, b) {
  const product = new Float32Array(9);
  for (let i = 0; i < 3; ++i) {
    for (let j = 0; j < 3; ++j) {
      for (let k = 0; k < 3; ++k) product[3 * j + i] += a[3 * k + i] * b[3 * j + k];
    }
  }
  return product;
}

function rotation(axis, angle) {
  const c = Math.cos(angle), s = Math.sin(angle);
  return new Float32Array(axis === 0 ? [1, 0, 0, 0, c, s, 0, -s, c] : [c, 0, -s, 0, 1, 0, s, 0, c]);
}

// One canvas that shows a mesh: dragging turns it (flat: moves it), the wheel zooms.
class SurfaceView {
  constructor(canvas, scales, options) {
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw Error("This browser offers no WebGL 2.");
    Object.assign(this, { canvas, gl, options, morph: 0, round: false, batches: [], linked: [] });
    this.programs = [
      linkProgram(gl, kFaceVertex, kFaceFragment), linkProgram(gl, kEdgeVertex, kPlainFragment),
      linkProgram(gl, kPointVertex, kPointFragment)];
    this.loadScales(scales);
    this.reset();
    this.listen();
  }

  reset() {
    this.turn = multiply(rotation(0, 0.35), rotation(1, -0.5));
    this.camera = [0, 0, 0.96, 0];
    this.drawLinked();
  }

  // This view and another show the same from here on, whichever is turned, moved or zoomed.
  link(other) {
    this.linked.push(other);
    other.linked.push(this);
    this.drawLinked();
  }

  drawLinked() {
    this.draw();
    for (const other of this.linked) {
      Object.assign(other, { turn: this.turn, camera: [...this.camera] });
      other.draw();
    }
  }

  loadScales(scales) {
    const { gl } = this;
    const pixels = scales.flatMap(({ colours }) =>
      colours.flatMap((c) => [1, 3, 5].map((i) => parseInt(c.slice(i, i + 2), 16)).concat(255)));
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, scales[0].colours.length, scales.length, 0, gl.RGBA,
                  gl.UNSIGNED_BYTE, new Uint8Array(pixels));
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  }

  // The pattern of a lattice, over one period.
  loadTile({ side, tile }) {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE1);
    if (!this.tile) this.tile = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.tile);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, side, side, 0, gl.RED, gl.UNSIGNED_BYTE, tile);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.REPEAT);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.REPEAT);
    gl.activeTexture(gl.TEXTURE0);
  }

  // Whole numbers of periods to a cell, so that they go on across seams.
  latticeUniforms() {
    if (!this.lattice) return { lattice: 0, tile: 1 };
    const { middle, radius, slope, to_periods: toPeriods } = this.lattice;
    const periods = Math.max(1, Math.round(this.options.checks / radius));
    return { lattice: 1, tile: 1, frame: [...middle, radius, periods], toPeriods, slope };
  }

  // Faces, seams, boundary and cones as vertex arrays; the lattice, where there is one.
  load({ faces, seams, boundary, cones, round, lattice }) {
    this.round = round;
    this.lattice = lattice;
    if (lattice) this.loadTile(lattice);
    for (const batch of this.batches) batch.free();
    const [face, edge, point] = this.programs;
    this.batches = [new Batch(this.gl, face, faces, 0), new Batch(this.gl, edge, boundary, 1),
                    new Batch(this.gl, edge, seams, 1), new Batch(this.gl, point, cones, 0)];
    this.draw();
  }

  draw() {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.paint();
    });
  }

  paint() {
    const { gl, canvas, options } = this;
    const scale = window.devicePixelRatio || 1;
    const width = Math.round(canvas.clientWidth * scale), height = Math.round(canvas.clientHeight * scale);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    const style = getComputedStyle(canvas);
    const [background, ink] = [style.backgroundColor, style.color].map(
      (colour) => colour.match(/\d+/g).slice(0, 3).map((c) => c / 255));
    gl.clearColor(...background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    if (this.batches.length === 0) return;
    const place = { turn: this.turn, camera: this.camera, aspect: width / height, morph: this.morph,
                    round_: this.round ? 1 : 0, towards: 0 };
    const [faces, boundary, seams, cones] = this.batches;
    faces.use({ ...place, shading: options.shading, wire: options.wire ? 1 : 0, checks: options.checks, scales: 0,
                ...this.latticeUniforms() });
    gl.drawArrays(gl.TRIANGLES, 0, faces.count);
    const edge = { ...place, towards: 0.01, pixel: [2 / width, 2 / height] };
    boundary.use({ ...edge, width: 0.8 * scale, tint: ink });
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, boundary.count);
    if (options.seams) {
      seams.use({ ...edge, towards: 0.012, width: 1.2 * scale, tint: [0.88, 0.12, 0.35] });
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, seams.count);
    }
    if (options.cones) {
      cones.use({ ...place, towards: 0.02, width: 11 * scale });
      gl.drawArrays(gl.POINTS, 0, cones.count);
    }
    canvas.dataset.faces = faces.count / 3;
  }

  drag(dx, dy, move) {
    if (move || (this.morph > 0.5 && !this.round)) {
      const size = Math.min(this.canvas.clientWidth, this.canvas.clientHeight) * this.camera[2];
      this.camera[0] -= (2 * dx) / size;
      this.camera[1] += (2 * dy) / size;
    } else {
      this.turn = multiply(multiply(rotation(0, dy * 0.01), rotation(1, dx * 0.01)), this.turn);
    }
    this.drawLinked();
  }

  zoom(factor) {
    this.camera[2] = Math.min(Math.max(this.camera[2] * factor, 0.05), 500);
    this.drawLinked();
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
      if (event.buttons) this.drag(event.movementX, event.movementY, event.shiftKey || event.buttons === 2);
    });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * 0.0015));
    }, { passive: false });
    canvas.addEventListener("dblclick", () => this.reset());
    canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [-12, 0], ArrowRight: [12, 0], ArrowUp: [0, -12], ArrowDown: [0, 12] }[event.key];
      if (step) this.drag(...step, event.shiftKey);
      else if (event.key === "+" || event.key === "-") this.zoom(event.key === "+" ? 1.2 : 1 / 1.2);
      else return;
      event.preventDefault();
    });
    new ResizeObserver(() => this.draw()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
  }
}
