const { views, scales } = JSON.parse(document.getElementById("data").textContent);
const element = (id) => document.getElementById(id);
const options = { shading: 0, wire: false, seams: true, cones: true, checks: 20 };

// One attribute of every listed corner, `of` writes its numbers at a place of the list.
function gather(corners, size, of) {
  const list = new Float32Array(size * corners.length);
  for (let i = 0; i < corners.length; ++i) of(corners[i], list, size * i);
  return [size, list];
}

// Vertex arrays from the lists of a mesh.
function buildArrays(mesh, { cones, lattice }) {
  const normals = vertexNormals(mesh);
  const [x, y, z] = normalize(mesh.x, mesh.y, mesh.z).lists;
  const round = mesh.image.length === 3;
  const { lists: image, middle, radius } = normalize(...mesh.image);
  const vertex = (h) => mesh.vertexOfPoint[mesh.pointOfCorner[h]];
  const position = (h, list, at) => {
    const i = vertex(h);
    list[at] = x[i], list[at + 1] = y[i], list[at + 2] = z[i];
  };
  const place = (h, list, at) => {
    const i = mesh.pointOfCorner[h];
    for (let k = 0; k < image.length; ++k) list[at + k] = image[k][i];
  };
  const normal = (h, list, at) => {
    const i = 3 * vertex(h);
    list[at] = normals[i], list[at + 1] = normals[i + 1], list[at + 2] = normals[i + 2];
  };
  const colour = (h, list, at) => {
    const face = (h / 3) | 0;
    list[at] = mesh.colours[0][face], list[at + 1] = mesh.colours[1][face];
  };
  const all = Uint32Array.from(mesh.pointOfCorner, (_, h) => h);
  // Halfedge h lies opposite its corner: it runs between the two other ones.
  const edges = (halfedges) => {
    const from = halfedges.map((h) => (h % 3 === 2 ? h - 2 : h + 1));
    const to = halfedges.map((h) => (h % 3 === 0 ? h + 2 : h - 1));
    return { from: gather(from, 3, position), to: gather(to, 3, position),
             fromImage: gather(from, 3, place), toImage: gather(to, 3, place) };
  };
  // A cone has a place in the image at each of its points.
  const sums = new Map(cones);
  const seen = new Set();
  const conic = all.filter((h) => sums.has(vertex(h)) && !seen.has(mesh.pointOfCorner[h]) &&
                                  seen.add(mesh.pointOfCorner[h]));
  return {
    faces: { position: gather(all, 3, position), normal: gather(all, 3, normal),
             image: gather(all, 3, place), colour: gather(all, 2, colour) },
    round, lattice: lattice && { ...lattice, tile: mesh.tile, middle, radius },
    seams: edges(mesh.seams), boundary: edges(mesh.boundary),
    cones: { position: gather(conic, 3, position), image: gather(conic, 3, place),
             sum: gather(conic, 1, (h, list, at) => { list[at] = sums.get(vertex(h)); }) },
  };
}

function showScale() {
  const scale = scales[options.shading - 1];
  element("scale").replaceChildren();
  if (!scale) return;
  const bar = document.createElement("i");
  bar.style.background = `linear-gradient(to right, ${scale.colours.join(", ")})`;
  element("scale").append(String(scale.least), bar,
                          `${scale.greatest}  ${scale.meaning}; beyond, the colour of the end`);
}

// A canvas with a caption, in the row of the second map.
function addPane(id, label) {
  const figure = document.createElement("figure");
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { id, tabIndex: 0 });
  canvas.setAttribute("aria-label", label);
  const caption = document.createElement("figcaption");
  const button = document.createElement("button");
  Object.assign(button, { type: "button", className: "save", textContent: "PNG" });
  button.dataset.of = id;
  caption.append(document.createElement("span"), " ", button);
  figure.append(canvas, caption);
  element("second").append(figure);
  return new SurfaceView(canvas, scales, options);
}

// What the canvas shows, as a file.
function saveView(canvas, view) {
  canvas.toBlob((blob) => saveFile(blob, `${view.mesh}-${view.method}-${canvas.id}.png`));
}

// To the row of the table of runs, where the page has one.
function recordLink(key) {
  if (!document.getElementById(`run-${key}`)) return [];
  const link = document.createElement("a");
  link.href = `#run-${key}`;
  link.textContent = "Its record";
  return [" ", link, "."];
}

function showFacts(view) {
  const count = (number, noun) => `${number} ${noun}${number === 1 ? "" : "s"}`;
  const swatch = (css, colour) => {
    const mark = document.createElement("span");
    mark.className = "swatch " + css;
    mark.style.background = colour;
    return mark;
  };
  const sums = view.cones.map(([, sum]) => (sum / Math.PI).toFixed(3));
  const few = [...new Set(sums)].slice(0, 6).join(", ");
  element("facts").replaceChildren(
    `${count(view.faces, "triangle")}, ${count(view.vertices, "vertex").replace("vertexs", "vertices")}. `,
    swatch("", "#e01f59"), ` ${count(view.seams / 2, "seam edge")}, `,
    swatch("dot", "#ed730d"), " ", swatch("dot", "#8033bf"), ` ${count(view.cones.length, "cone")}`,
    few ? ` (angle sums less and more than 2 pi; in multiples of pi: ${few}${new Set(sums).size > 6 ? ", ..." : ""}).` : ".",
    " Positions and uvs are rounded to 1/65535 of their range here.", ...recordLink(view.key));
}

class Viewer {
  constructor() {
    this.arrays = new Map();  // of the views shown so far
    this.shown = [0, -1];     // the first map, and the one beside it or -1
    const first = { surface: new SurfaceView(element("surface"), scales, options),
                    image: new SurfaceView(element("image"), scales, options) };
    first.image.morph = 1;
    this.rows = [first];
  }

  all(act) {
    for (const { surface, image } of this.rows) [surface, image].forEach(act);
  }

  async arraysOf(index) {
    const view = views[index];
    if (!this.arrays.has(index)) this.arrays.set(index, buildArrays(await readMesh(view), view));
    return this.arrays.get(index);
  }

  async load(row, index) {
    const arrays = await this.arraysOf(index);
    if (this.shown[row] !== index) return;  // another was chosen meanwhile
    this.rows[row].surface.load(arrays);
    this.rows[row].image.load(arrays);
  }

  async show(index) {
    this.shown[0] = index;
    await this.load(0, index);
    showFacts(views[index]);
    element("caption").textContent = views[index].sphere ?
      "Image on the sphere: drag to turn, shift-drag to move, wheel to zoom." :
      "Image in the plane: drag to move, wheel to zoom. Flipped triangles are red.";
  }

  // A second row, which turns and zooms with the first.
  async showBeside(index) {
    this.shown[1] = index;
    element("second").hidden = index < 0;
    if (index < 0) return;
    if (this.rows.length === 1) {
      const [surface, image] = [addPane("surface2", "the surface of the second map"),
                                addPane("image2", "the image of the second map")];
      const [first] = this.rows;
      image.morph = 1;
      surface.morph = first.surface.morph;
      this.rows.push({ surface, image });
      first.surface.link(surface);
      first.image.link(image);
    }
    const { mesh, method } = views[index];
    for (const caption of element("second").querySelectorAll("span")) caption.textContent = `${mesh} - ${method}`;
    await this.load(1, index);
  }
}

async function main() {
  const viewer = new Viewer();
  if (views.every((view) => view.lattice)) options.seams = element("seams").checked = false;  // there are none to see
  views.forEach((view, index) => {
    for (const id of ["choose", "beside"]) element(id).append(new Option(`${view.mesh} - ${view.method}`, index));
  });
  if (views.length < 2) {
    for (const id of ["choose", "beside"]) element(id).parentElement.style.display = "none";
  }
  element("choose").addEventListener("change", () => {
    const index = Number(element("choose").value);
    history.replaceState(null, "", `#map-${views[index].key}`);  // a link to what is shown
    viewer.show(index);
  });
  element("beside").addEventListener("change", () => viewer.showBeside(Number(element("beside").value)));
  const on = (id, act) => element(id).addEventListener("input", () => {
    act(element(id));
    viewer.all((one) => one.draw());
  });
  on("shading", (input) => { options.shading = Number(input.value); showScale(); });
  on("checks", (input) => { options.checks = Number(input.value); });
  on("wire", (input) => { options.wire = input.checked; });
  on("seams", (input) => { options.seams = input.checked; });
  on("cones", (input) => { options.cones = input.checked; });
  on("morph", (input) => { for (const { surface } of viewer.rows) surface.morph = Number(input.value); });
  element("reset").addEventListener("click", () => viewer.all((one) => one.reset()));
  document.querySelector(".viewer").addEventListener("click", ({ target }) => {
    if (!target.matches(".save")) return;
    saveView(element(target.dataset.of), views[viewer.shown[target.dataset.of.endsWith("2") ? 1 : 0]]);
  });
  const follow = () => {
    const index = views.findIndex((view) => location.hash === `#map-${view.key}`);
    if (index < 0) return false;
    element("choose").value = index;
    element("maps").scrollIntoView();
    return viewer.show(index);
  };
  addEventListener("hashchange", follow);
  await (follow() || viewer.show(0));
}
main().catch((error) => {
  console.error(error);
  element("facts").textContent = `The maps cannot be shown: ${error.message}`;
});
