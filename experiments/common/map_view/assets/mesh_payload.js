// What map_payload.h writes: differences folded to unsigned numbers, byte planes, deflate, base64.
async function inflate(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Reads `count` numbers of `planes` bytes at `at`.
function readList(bytes, at, count, planes) {
  const list = planes === 2 ? new Uint16Array(count) : new Uint32Array(count);
  let value = 0;
  for (let i = 0; i < count; ++i) {
    let code = 0;
    for (let plane = planes - 1; plane >= 0; --plane) {
      code = (code << 8) | bytes[at + plane * count + i];
    }
    value += (code >>> 1) ^ -(code & 1);
    list[i] = value;  // modulo 2^16 or 2^32
    value = list[i];
  }
  return list;
}

// The lists of a view, coordinates in the units of the surface and of its image.
async function readMesh(view) {
  const bytes = await inflate(view.data);
  let at = 0;
  const take = (count, planes) => {
    const list = readList(bytes, at, count, planes);
    at += count * planes;
    return list;
  };
  const coordinates = (count, [low, high]) =>
    Float32Array.from(take(count, 2), (step) => low + (step / 65535) * (high - low));
  const [x, y, z] = [0, 1, 2].map((k) => coordinates(view.vertices, view.boxes[k]));
  const image = view.boxes.slice(3).map((box) => coordinates(view.points, box));
  const colours = [0, 1].map(() => Float32Array.from(take(view.faces, 2), (step) => step / 65535));
  const vertexOfPoint = take(view.points, 4);
  const pointOfCorner = take(3 * view.faces, 4);
  const seams = take(view.seams, 4);
  const boundary = take(view.boundary, 4);
  const tile = view.lattice && await inflate(view.lattice.tile);
  return { x, y, z, image, colours, vertexOfPoint, pointOfCorner, seams, boundary, tile };
}

// Moves the middle of the coordinates' box to the origin; the farthest point's distance becomes 1. Returns the
// lists, and the middle and radius that were.
function normalize(...coordinates) {
  const middle = coordinates.map((list) => {
    const low = list.reduce((a, b) => Math.min(a, b), Infinity);
    const high = list.reduce((a, b) => Math.max(a, b), -Infinity);
    return (low + high) / 2;
  });
  const centred = coordinates.map((list, k) => list.map((value) => value - middle[k]));
  const radius = centred[0].reduce(
    (most, _, i) => Math.max(most, Math.hypot(...centred.map((list) => list[i]))), 0) || 1;
  return { lists: centred.map((list) => list.map((value) => value / radius)), middle, radius };
}

// Vertex normals: the sum of the faces' normals times their areas.
function vertexNormals({ x, y, z, vertexOfPoint, pointOfCorner }) {
  const normals = new Float32Array(3 * x.length);
  for (let h = 0; h < pointOfCorner.length; h += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => vertexOfPoint[pointOfCorner[h + k]]);
    const p = [x[b] - x[a], y[b] - y[a], z[b] - z[a]];
    const q = [x[c] - x[a], y[c] - y[a], z[c] - z[a]];
    const normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    for (const vertex of [a, b, c]) {
      for (let k = 0; k < 3; ++k) normals[3 * vertex + k] += normal[k];
    }
  }
  return normals;
}
