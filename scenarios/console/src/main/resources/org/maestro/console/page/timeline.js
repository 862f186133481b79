/** What was done and is to be done, by whom: a row for each member, bars in the platform's seconds. */
import { make, draw } from "./dom.js";
import { STATES, standing } from "./plans.js";

const NAMES = 118;
const LANE = 26;
const HEAD = 40;
const LEAST_PER_SECOND = 6;
const LETTER = 6.6;
const TICKS = [0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1800, 3600];

/** What has begun, of all plans; of the latest also what is to come, when it can be as things are. */
function bars(plans, time) {
  const begun = new Map();
  for (const plan of plans) {
    for (const step of plan.steps.filter((one) => one.begun_s !== null)) {
      // What a later plan has taken over is one and the same.
      begun.set(`${step.text} ${step.begun_s}`, { plan, step, from: step.begun_s, to: step.ended_s ?? Math.max(time, step.begun_s) });
    }
  }
  const latest = plans.filter((plan) => plan.steps.length > 0).at(-1);
  const ends = new Map();
  const planned = [];
  for (const step of latest?.steps ?? []) {
    let end = step.ended_s ?? Math.max(time, step.begun_s + step.duration_s);
    if (step.state === "waiting") {
      const from = Math.max(time, latest.made_s + step.start_s, ...step.after.map((number) => ends.get(number) ?? 0));
      end = from + step.duration_s;
      planned.push({ plan: latest, step, from, to: end });
    } else if (step.state === "under-way" && end > time) {
      planned.push({ plan: latest, step, from: time, to: end, isRest: true });
    }
    ends.set(step.number, end);
  }
  return [...begun.values(), ...planned];
}

/** Members in the order in which they begin; what overlaps is beside each other. */
function rows(all) {
  const byMember = new Map();
  for (const bar of [...all].sort((a, b) => a.from - b.from)) {
    const row = byMember.get(bar.step.member) ?? { member: bar.step.member, ends: [], bars: [] };
    const free = row.ends.findIndex((end) => end <= bar.from + 1e-6);
    const lane = free < 0 ? row.ends.length : free;
    row.ends[lane] = bar.to;
    row.bars.push({ ...bar, lane });
    byMember.set(bar.step.member, row);
  }
  let y = 0;
  return [...byMember.values()].map((row) => {
    const placed = { ...row, y, height: row.ends.length * LANE + 6 };
    y += placed.height;
    return placed;
  });
}

/** Those of which the names do not cover each other. */
function apart(plans, x) {
  let before = -Infinity;
  return plans.filter((plan) => {
    const fits = x(plan) - before > 46;
    before = fits ? x(plan) : before;
    return fits;
  });
}

function drawBar({ plan, step, from, to, lane, isRest }, row, x, { chosen, time, choose, first }) {
  const [sign, tone] = STATES[step.state];
  const [left, width] = [x(from), Math.max(3, x(to) - x(from))];
  const y = row.y + 3 + lane * LANE;
  const isPlanned = isRest || step.state === "waiting";
  const label = `${sign} ${step.number} ${step.feature}`;
  if (isRest) {
    return draw("rect", { class: "bar planned rest", x: left, y: y + 2, width, height: LANE - 4 });
  }
  const name = `${plan.number}/${step.number}`;
  const told = `Plan ${plan.number}, step ${step.number}, ${step.text}: ${standing(step, time)}, from ${from.toFixed(1)} s to ${to.toFixed(1)} s`;
  return draw("g", {
    class: `step ${tone} ${name === chosen ? "chosen" : ""}`, role: "button", tabindex: name === first ? 0 : -1,
    "aria-pressed": String(name === chosen), "aria-label": told, "data-bar": name, onclick: () => choose(plan.number, step.number),
  },
  draw("rect", { class: `bar ${isPlanned ? "planned" : ""}`, x: left, y: y + 2, width, height: LANE - 4, rx: 3 }, draw("title", {}, told)),
  draw("text", { class: "label", x: left + 4, y: y + LANE / 2 + 4 }, width > label.length * LETTER ? label : width > 14 ? sign : ""));
}

/**
 * @param room how wide it may be; wider when it takes long
 * @param looks which plan and step are chosen, what time it is, whether that goes on, and who is told of another choice
 */
export function timeline(plans, room, looks) {
  const all = bars(plans, looks.time);
  const listed = rows(all);
  const begin = Math.min(...plans.map((plan) => plan.asked_s));
  const end = Math.max(...all.map((bar) => bar.to), looks.goesOn ? looks.time : begin) + 0.5;
  const scale = Math.max(LEAST_PER_SECOND, (room - NAMES - 30) / (end - begin));
  const x = (seconds) => (seconds - begin) * scale + 6;
  const [width, height] = [x(end) + 20, listed.reduce((sum, row) => sum + row.height, 0)];
  const tick = TICKS.find((seconds) => seconds * scale > 46) ?? 7200;
  const ticks = Array.from({ length: Math.floor(end / tick) - Math.ceil(begin / tick) + 1 }, (_, i) => (Math.ceil(begin / tick) + i) * tick);
  const size = (wide, tall) => ({ width: wide, height: tall, viewBox: `0 0 ${wide} ${tall}` });
  const first = all.some(({ plan, step }) => `${plan.number}/${step.number}` === looks.chosen) ? looks.chosen
    : `${all[0]?.plan.number}/${all[0]?.step.number}`;
  const line = (className, at) => draw("line", { class: className, x1: x(at), y1: 0, x2: x(at), y2: height });
  const hatch = draw("defs", {}, draw("pattern", { id: "hatch", width: 7, height: 7, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" },
    draw("line", { class: "stroke", x1: 0, y1: 0, x2: 0, y2: 7 })));
  return [
    make("div", { class: "heads" },
      draw("svg", { ...size(NAMES, HEAD), class: "names" }, draw("text", { class: "quiet", x: 4, y: 17 }, "seconds")),
      draw("svg", { ...size(width, HEAD), "aria-hidden": "true" },
        ticks.filter((at) => !looks.goesOn || Math.abs(x(at) - x(looks.time)) > 30)
          .map((at) => draw("text", { class: "quiet", x: x(at), y: 17, "text-anchor": "middle" }, String(at))),
        apart(plans.filter((plan) => plan.made_s !== null), (plan) => x(plan.made_s))
          .map((plan) => draw("text", { class: "quiet", x: x(plan.made_s), y: 34, "text-anchor": "middle" }, `plan ${plan.number}`)),
        looks.goesOn ? draw("text", { class: "now", x: x(looks.time), y: 17, "text-anchor": "middle" }, "now") : [])),
    make("div", { class: "rows" },
      draw("svg", { ...size(NAMES, height), class: "names" },
        listed.flatMap((row) => [
          draw("text", { x: 4, y: row.y + row.height / 2 + 4 },
            row.member.length > 15 ? `${row.member.slice(0, 9)}…${row.member.slice(-5)}` : row.member, draw("title", {}, row.member)),
          draw("line", { class: "between", x1: 0, y1: row.y + row.height, x2: NAMES, y2: row.y + row.height })])),
      draw("svg", {
        ...size(width, height), role: "group", "aria-label": "Steps by who does them; arrow keys go from one to the next",
        onkeydown: (event) => walk(event, looks.choose),
      },
      hatch, ticks.map((at) => line("tick", at)),
      plans.filter((plan) => plan.made_s !== null).map((plan) => line("made", plan.made_s)),
      listed.flatMap((row) => [
        draw("line", { class: "between", x1: 0, y1: row.y + row.height, x2: width, y2: row.y + row.height }),
        ...row.bars.map((bar) => drawBar(bar, row, x, { ...looks, first }))]),
      looks.goesOn ? line("now", looks.time) : [])),
  ];
}

function walk(event, choose) {
  const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1, Enter: 0, " ": 0 }[event.key];
  const here = event.target.closest("[data-bar]");
  if (!here || step === undefined) {
    return;
  }
  event.preventDefault();
  const all = [...event.currentTarget.querySelectorAll("[data-bar]")];
  const next = all[Math.max(0, Math.min(all.length - 1, all.indexOf(here) + step))];
  choose(...next.dataset.bar.split("/").map(Number));
}
