// Corner attributes are not shared between triangles: colours are flat, and gl_VertexID says which
// corner it is, for the wireframe.
const kPlace = `
  uniform mat3 turn; uniform vec4 camera; uniform float aspect, morph, round_, towards;
  // camera: centre x and y, zoom; an image in the plane turns to lie flat before the viewer, one on
  // the sphere (round_ = 1) turns with the surface.
  vec3 seen(vec3 image) { return mix(image, turn * image, round_); }
  vec4 place(vec3 on, vec3 image) {
    vec3 p = mix(turn * on, seen(image), morph);
    vec2 q = (p.xy - camera.xy) * camera.z;
    return vec4(q.x / max(aspect, 1.0) , q.y * min(aspect, 1.0), (-p.z - towards) * 0.2, 1.0);
  }`;

const kFaceVertex = `#version 300 es
  in vec3 position; in vec3 normal; in vec3 image; in vec2 colour;
  out vec3 facing; out vec3 spot; flat out vec2 value; out vec3 corner;
  ${kPlace}
  void main() {
    gl_Position = place(position, image);
    facing = mix(turn * normalize(normal), mix(vec3(0.0, 0.0, 1.0), turn * image, round_), morph);
    spot = image; value = colour;
    int k = gl_VertexID % 3;
    corner = vec3(k == 0, k == 1, k == 2);
  }`;

const kFaceFragment = `#version 300 es
  precision highp float;
  in vec3 facing; in vec3 spot; flat in vec2 value; in vec3 corner;
  uniform int shading, wire, lattice; uniform float checks, morph, round_; uniform sampler2D scales, tile;
  uniform vec4 frame, toPeriods; uniform float slope;
  out vec4 colour;
  float square(float t, float width) {  // a wave between 0 and 1, its steps a pixel wide
    float s = abs(fract(t) * 2.0 - 1.0) - 0.5;
    return clamp(s / max(2.0 * width, 1e-6) + 0.5, 0.0, 1.0);
  }
  vec3 base() {
    if (shading == 1) return texture(scales, vec2(value.x, 0.25)).rgb;
    if (shading == 2) return texture(scales, vec2(value.y, 0.75)).rgb;
    if (shading == 3) return vec3(0.75, 0.77, 0.8);
    const vec3 dark = vec3(0.24, 0.42, 0.62), light = vec3(0.95, 0.93, 0.88);
    if (lattice == 1) {  // distances to the edges of the pattern, over one period; frame: middle, radius, periods a cell
      vec2 cells = (spot.xy * frame.z + frame.xy) * frame.w, across = fwidth(spot.xy * frame.z * frame.w);
      float width = max(max(across.x, across.y), 1e-6);
      float distance = (texture(tile, mat2(toPeriods) * cells).r - 0.5) / slope;
      float blurred = mix(clamp(distance / width + 0.5, 0.0, 1.0), 0.5, smoothstep(0.35, 1.0, width));
      return mix(light, dark, blurred);
    }
    vec2 t = spot.xy * checks, width = fwidth(t);
    if (round_ == 1.0) {  // Mercator's squares: as many whole ones round the equator as fit
      vec3 s = normalize(spot);
      float many = ceil(checks / 4.0) / 3.14159265;
      t = vec2(atan(s.y, s.x), atanh(clamp(s.z, -0.9999, 0.9999))) * many;
      width = vec2(min(fwidth(t.x), fwidth(atan(-s.y, -s.x) * many)), fwidth(t.y));
    }
    float a = square(t.x, width.x), b = square(t.y, width.y);
    float blur = smoothstep(0.35, 1.0, max(width.x, width.y));  // too small to see: grey
    return mix(dark, light, mix(a + b - 2.0 * a * b, 0.5, blur));
  }
  void main() {
    vec3 n = normalize(facing);
    float dim = shading == 1 || shading == 2 ? 0.7 : 0.42;  // colours that mean something stay near
    float light = mix(dim + (1.0 - dim) * abs(dot(n, normalize(vec3(0.3, 0.5, 0.9)))), 1.0, morph * (1.0 - round_));
    colour = vec4(base() * light, 1.0);
    if (morph == 1.0 && !gl_FrontFacing) colour.rgb = vec3(0.85, 0.1, 0.1);  // flipped
    if (wire == 1) {
      vec3 width = max(fwidth(corner), 1e-6), edge = corner / width;
      float fade = 1.0 - smoothstep(0.08, 0.5, max(width.x, max(width.y, width.z)));
      float on = 1.0 - smoothstep(0.4, 1.2, min(edge.x, min(edge.y, edge.z)));
      colour.rgb = mix(colour.rgb, vec3(0.07), mix(0.12, 0.65, fade) * on);
    }
  }`;

// An edge is a strip of two triangles of constant width in pixels, towards the viewer.
const kEdgeVertex = `#version 300 es
  in vec3 from; in vec3 to; in vec3 fromImage; in vec3 toImage;
  uniform vec2 pixel; uniform float width;
  ${kPlace}
  void main() {
    vec4 a = place(from, fromImage), b = place(to, toImage);
    vec2 along = (b.xy - a.xy) / pixel;
    along = length(along) > 0.0 ? normalize(along) : vec2(1.0, 0.0);
    float side = float(gl_VertexID % 2) * 2.0 - 1.0;
    bool end = gl_VertexID > 1;
    gl_Position = end ? b : a;
    gl_Position.xy += (vec2(-along.y, along.x) * side + along * (end ? 0.5 : -0.5)) * width * pixel;
  }`;

const kPointVertex = `#version 300 es
  in vec3 position; in vec3 image; in float sum;
  uniform float width; out float angle;
  ${kPlace}
  void main() { gl_Position = place(position, image); gl_PointSize = width; angle = sum; }`;

const kPlainFragment = `#version 300 es
  precision highp float; uniform vec3 tint; out vec4 colour;
  void main() { colour = vec4(tint, 1.0); }`;

// Cones of less than a full angle are orange, of more violet, ringed in white.
const kPointFragment = `#version 300 es
  precision highp float; in float angle; out vec4 colour;
  void main() {
    float r = length(gl_PointCoord - 0.5);
    if (r > 0.5) discard;
    vec3 fill = angle < 6.2831853 ? vec3(0.93, 0.45, 0.05) : vec3(0.5, 0.2, 0.75);
    colour = vec4(r > 0.36 ? vec3(1.0) : fill, 1.0);
  }`;

function linkProgram(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw Error(gl.getProgramInfoLog(program));
  return program;
}
