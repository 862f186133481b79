/** A chart of numbers over time: of each moment the mean, between the lowest and the highest. */
import uPlot from "./uplot/dist/uPlot.esm.js";
import { make, draw } from "./dom.js";
import { clockTime } from "./past.js";

const HEIGHT = 140;
const COLOURS = 8;
const WHOLE = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 5000, 10000];
const DASHES = [[], [6, 4], [2, 3]];

function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function tint(i) {
  return `--chart-${(i % COLOURS) + 1}`;
}

function dashes(i) {
  return DASHES[Math.floor(i / COLOURS) % DASHES.length];
}

function rounded(value) {
  return value === null || value === undefined ? "unknown"
    : String(Math.abs(value) >= 100 ? Math.round(value) : Math.round(value * 100) / 100);
}

const path = uPlot.paths.stepped({ align: 1 });

function lines(names) {
  return names.flatMap((name, i) => [
    { label: `${name}, highest`, stroke: "transparent", width: 0, paths: path, points: { show: false } },
    { label: `${name}, lowest`, stroke: "transparent", width: 0, paths: path, points: { show: false } },
    { label: name, stroke: () => colour(tint(i)), width: 2, dash: dashes(i), paths: path, points: { show: false } },
  ]);
}

function axis(more) {
  return { stroke: () => colour("--quiet"), grid: { stroke: () => colour("--line"), width: 1 }, ticks: { show: false }, font: "12px system-ui, sans-serif", ...more };
}

/** The time that is shown, when it is not now. */
function mark(plot, at) {
  if (at !== null && at >= plot.scales.x.min && at <= plot.scales.x.max) {
    const x = Math.round(plot.valToPos(at, "x", true));
    plot.ctx.save();
    plot.ctx.strokeStyle = colour("--wait");
    plot.ctx.lineWidth = 2 * devicePixelRatio;
    plot.ctx.beginPath();
    plot.ctx.moveTo(x, plot.bbox.top);
    plot.ctx.lineTo(x, plot.bbox.top + plot.bbox.height);
    plot.ctx.stroke();
    plot.ctx.restore();
  }
}

/**
 * A chart with its legend. Returns its element and what draws: of each series its name and its lowest, mean and highest
 * values, the seconds at which they begin, and the second that is shown, or null.
 * @param isCount whether it is of whole numbers
 * @param choose is told the second at which it is clicked
 */
export function chart({ title, unit, isCount }, names, choose) {
  let shownAt = null;
  let told = { seconds: [], series: [] };
  const values = names.map(() => make("span", { class: "value" }));
  const legend = make("ul", { class: "legend" }, names.map((name, i) => make("li", {},
    draw("svg", { width: 22, height: 10, "aria-hidden": "true" },
      draw("line", { class: `line-${(i % COLOURS) + 1}`, x1: 0, x2: 22, y1: 5, y2: 5, "stroke-width": 2.5, "stroke-dasharray": dashes(i).join(" ") || null })),
    ` ${name} `, values[i])));
  const picture = make("div", { class: "picture", role: "img", "aria-label": `${title}, ${unit}` });
  const element = make("figure", { class: "chart" }, make("figcaption", {}, title, make("span", { class: "quiet" }, ` ${unit}`)), picture, legend);
  const tell = (index) => told.series.forEach((one, i) => {
    const mean = one.mean[index];
    const spread = mean !== null && mean !== undefined && rounded(one.low[index]) !== rounded(one.high[index])
      ? ` (${rounded(one.low[index])} to ${rounded(one.high[index])})` : "";
    values[i].textContent = rounded(mean) + spread;
  });
  /** What is under the pointer, else what is shown. */
  const index = (plot) => {
    if (plot.cursor.idx !== null && plot.cursor.idx !== undefined) {
      return plot.cursor.idx;
    }
    return shownAt === null ? told.seconds.length - 1 : told.seconds.findLastIndex((second) => second <= shownAt);
  };
  const plot = new uPlot({
    width: 300, height: HEIGHT, legend: { show: false }, padding: [8, 12, 0, 0],
    cursor: { drag: { x: false, y: false }, sync: { key: "time" }, points: { show: false }, y: false },
    scales: { x: { time: true }, y: { range: (self, low, high) => [Math.min(0, low ?? 0), Math.max(1, (high ?? 1) * 1.05)] } },
    axes: [
      axis({ space: 70, size: 26, values: (self, splits) => splits.map((second) => clockTime(second * 1000)) }),
      axis({ size: 52, space: 26, ...(isCount ? { incrs: WHOLE } : {}), values: (self, splits) => splits.map(rounded) }),
    ],
    series: [{}, ...lines(names)],
    bands: names.map((name, i) => ({ series: [3 * i + 1, 3 * i + 2], fill: () => `color-mix(in srgb, ${colour(tint(i))} 22%, transparent)` })),
    hooks: { draw: [(self) => mark(self, shownAt)], setCursor: [(self) => tell(index(self))] },
  }, [[], ...names.flatMap(() => [[], [], []])], picture);
  plot.over.addEventListener("click", () => {
    if (plot.cursor.left >= 0) {
      choose(plot.posToVal(plot.cursor.left, "x"));
    }
  });
  const fit = () => {
    const width = Math.floor(picture.clientWidth);
    if (width > 0 && width !== plot.width) {
      plot.setSize({ width, height: HEIGHT });
    }
  };
  new ResizeObserver(fit).observe(picture);
  return {
    element,
    draw: (seconds, series, at) => {
      told = { seconds, series };
      shownAt = at;
      fit();
      plot.setData([seconds, ...series.flatMap((one) => [one.high, one.low, one.mean])]);
      tell(index(plot));
      picture.setAttribute("aria-label", `${title}, ${unit}: ${names.map((name, i) => `${name} ${values[i].textContent}`).join("; ")}`);
    },
    redraw: () => plot.redraw(false, true),
    end: () => plot.destroy(),
  };
}
