/** The steps of a script as they are written, and where each stands. */
import { make } from "./dom.js";
import { STATES } from "./plans.js";

const tenth = (seconds) => `${seconds.toFixed(1)} s`;

/** Where a step stands, in words; how long it takes nobody has planned. */
function standing(step, time) {
  const [, , word] = STATES[step.state];
  if (step.begun_s === null) {
    return step.state === "waiting" ? "to come" : word;
  }
  const lasts = (step.ended_s ?? Math.max(time, step.begun_s)) - step.begun_s;
  return step.state === "under-way" ? `${word} for ${tenth(lasts)}` : `${word} after ${tenth(lasts)}`;
}

function line(step, time) {
  const [sign, tone] = STATES[step.state];
  return make("li", { class: `step ${tone}`, "data-path": step.path },
    make("div", { class: "line" },
      make("code", { class: "quiet" }, step.path), make("code", {}, step.text),
      make("span", { class: `state ${tone}`, "data-sign": sign }, standing(step, time))),
    step.problem ? make("p", { class: "problem" }, step.problem) : null);
}

/** Lists in lists, as the steps are in each other. */
export function scriptSteps(steps, time) {
  const lists = [make("ol", { class: "script" })];
  for (const step of steps) {
    while (lists.length <= step.depth) {
      const inner = make("ol");
      (lists.at(-1).lastElementChild ?? lists.at(-1)).append(inner);
      lists.push(inner);
    }
    lists.length = step.depth + 1;
    lists[step.depth].append(line(step, time));
  }
  return lists[0];
}
