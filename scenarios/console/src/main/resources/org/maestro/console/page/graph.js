/** A plan as a graph: steps in columns, each after those that it needs. */
import { draw } from "./dom.js";
import { layers } from "./layers.js";
import { STATES, standing, fraction, doer } from "./plans.js";

const SIZE = { width: 164, height: 66, across: 34, down: 16 };
const EDGE = 8;
const LETTER = 7;

/** What tells names apart stands often at their end. */
function fitting(text, letter = LETTER) {
  const most = Math.floor((SIZE.width - 20) / letter);
  return text.length <= most ? text : `${text.slice(0, most - 5)}…${text.slice(-4)}`;
}

function path(way) {
  const [first, ...others] = way;
  let d = `M ${first.x + SIZE.width} ${first.y + first.tall / 2}`;
  let before = [first.x + SIZE.width, first.y + first.tall / 2];
  others.forEach((item, i) => {
    const [x, y] = [item.x, item.y + item.tall / 2];
    const middle = (before[0] + x) / 2;
    d += ` C ${middle} ${before[1]} ${middle} ${y} ${x} ${y}`;
    if (i < others.length - 1) {
      d += ` H ${x + SIZE.width}`;
      before = [x + SIZE.width, y];
    }
  });
  return d;
}

function edge({ from, to, way }, chosen) {
  const last = way.at(-1);
  const [x, y] = [last.x, last.y + last.tall / 2];
  return draw("g", { class: `need ${chosen === from || chosen === to ? "chosen" : ""}` },
    draw("path", { class: "way", d: path(way) }),
    draw("polygon", { class: "tip", points: `${x},${y} ${x - 8},${y - 4} ${x - 8},${y + 4}` }));
}

function node(step, place, { chosen, time, choose, first }) {
  const [sign, tone] = STATES[step.state];
  const isChosen = step.number === chosen;
  const told = `Step ${step.number}, ${step.text}: ${standing(step, time)}`;
  return draw("g", {
    class: `step ${tone} ${isChosen ? "chosen" : ""}`, transform: `translate(${place.x} ${place.y})`,
    role: "button", tabindex: step.number === first ? 0 : -1, "aria-pressed": String(isChosen), "aria-label": told,
    "data-step": step.number, onclick: () => choose(step.number),
  },
  draw("rect", { class: "box", width: SIZE.width, height: SIZE.height, rx: 7 }, draw("title", {}, `${told}; by ${doer(step.member)}`)),
  draw("text", { class: "who", x: 11, y: 20 }, fitting(`${sign} ${step.number}  ${step.member}`, 8)),
  draw("text", { class: "what", x: 11, y: 38 }, fitting(step.feature)),
  draw("text", { class: "standing", x: 11, y: 55 }, fitting(standing(step, time), 6.2)),
  step.state === "under-way"
    ? [draw("rect", { class: "rest", x: 1, y: SIZE.height - 6, width: SIZE.width - 2, height: 5 }),
      draw("rect", { class: "over", x: 1, y: SIZE.height - 6, width: (SIZE.width - 2) * fraction(step, time), height: 5 })]
    : []);
}

/**
 * @param looks which step is chosen, what time it is, and who is told of another choice
 */
export function graph(plan, looks) {
  const { places, edges, width, height } = layers(plan.steps, SIZE);
  const first = plan.steps.some((step) => step.number === looks.chosen) ? looks.chosen : plan.steps[0].number;
  const [wide, tall] = [width + 2 * EDGE, height + 2 * EDGE];
  return draw("svg", {
    width: wide, height: tall, viewBox: `${-EDGE} ${-EDGE} ${wide} ${tall}`, role: "group",
    "aria-label": `Plan ${plan.number}: ${plan.steps.length} steps; arrow keys go from one to the next`,
    onkeydown: (event) => walk(event, places, edges, looks.choose),
  },
  edges.map((one) => edge(one, looks.chosen)),
  plan.steps.map((step) => node(step, places.get(step.number), { ...looks, first })));
}

/** Along the arrows to the right and left, and up and down in a column. */
function walk(event, places, edges, choose) {
  const at = Number(event.target.closest(".step")?.dataset.step);
  const here = places.get(at);
  if (!here) {
    return;
  }
  const beside = (sign) => [...places.values()].filter((item) => item.x === here.x && (item.y - here.y) * sign > 0)
    .sort((a, b) => (a.y - b.y) * sign)[0]?.number;
  const to = {
    ArrowRight: () => edges.find((edge) => edge.from === at)?.to,
    ArrowLeft: () => edges.find((edge) => edge.to === at)?.from,
    ArrowDown: () => beside(1),
    ArrowUp: () => beside(-1),
    Enter: () => at,
    " ": () => at,
  }[event.key];
  if (to) {
    event.preventDefault();
    choose(to() ?? at);
  }
}
