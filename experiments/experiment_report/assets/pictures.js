"use strict";
// A PNG of every chart: its title, the names of its legend that are shown, and the drawing, in the colours of the page.
const kScale = 3, kMargin = 14, kLine = 18;

// The drawing by itself: every element carries what the style sheet says of it.
function standaloneSvg(svg) {
  const copy = svg.cloneNode(true);
  const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
  Object.entries({ xmlns: svg.namespaceURI, width, height }).forEach(([key, value]) => copy.setAttribute(key, value));
  const copies = copy.querySelectorAll("*");
  svg.querySelectorAll("*").forEach((original, i) => {
    const style = getComputedStyle(original);
    for (const name of ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "stroke-linejoin",
                        "stroke-linecap", "font-size", "font-family", "display"]) {
      copies[i].style.setProperty(name, style.getPropertyValue(name));
    }
  });
  return { text: new XMLSerializer().serializeToString(copy), width, height };
}

// The lines that names of a legend take, each with a swatch of its colour.
function legendLines(context, figure, width) {
  const lines = [[]];
  let at = 0;
  for (const button of figure.querySelectorAll(".legend button[aria-pressed='true']")) {
    const name = button.textContent, size = context.measureText(name).width + 30;
    if (at > 0 && at + size > width) {
      lines.push([]);
      at = 0;
    }
    lines[lines.length - 1].push({ name, at, colour: getComputedStyle(button.querySelector("path")).fill });
    at += size;
  }
  return lines.filter((line) => line.length > 0);
}

async function chartPng(figure) {
  const { text, width, height } = standaloneSvg(figure.querySelector(":scope > svg"));
  const drawing = new Image();
  drawing.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  await drawing.decode();
  const canvas = document.createElement("canvas"), context = canvas.getContext("2d");
  context.font = "13px sans-serif";
  const lines = legendLines(context, figure, width);
  const top = kMargin + kLine * (1 + lines.length);
  Object.assign(canvas, { width: kScale * (width + 2 * kMargin), height: kScale * (top + height + kMargin) });
  context.scale(kScale, kScale);
  const { backgroundColor, color } = getComputedStyle(figure);
  context.fillStyle = backgroundColor;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.fillStyle = color;
  context.font = "600 14px sans-serif";
  context.fillText(figure.dataset.title, kMargin, kMargin + 12);
  context.font = "13px sans-serif";
  lines.forEach((line, row) => line.forEach(({ name, at, colour }) => {
    const y = kMargin + kLine * (row + 2) - 6;
    context.fillStyle = colour;
    context.fillRect(kMargin + at, y - 9, 10, 10);
    context.fillStyle = color;
    context.fillText(name, kMargin + at + 14, y);
  }));
  context.drawImage(drawing, kMargin, top, width, height);
  URL.revokeObjectURL(drawing.src);
  return new Promise((done) => canvas.toBlob(done));
}

for (const button of document.querySelectorAll(".chart .save")) {
  const figure = button.closest("figure");
  button.addEventListener("click", async () => saveFile(await chartPng(figure), `${figure.dataset.title}.png`));
}
