/** A step of a plan in full, and why its member does it and no other. */
import { make } from "./dom.js";
import { STATES, standing, doer } from "./plans.js";

function fact(name, value) {
  return value === null ? [] : [make("dt", {}, name), make("dd", {}, value)];
}

const at = (seconds) => (seconds === null ? null : `${seconds.toFixed(1)} s`);

/**
 * @param why as it was answered; null before
 */
export function stepDetail(plan, step, why, time) {
  const [sign, tone] = STATES[step.state];
  return [
    make("h3", {}, `Step ${step.number} of plan ${plan.number}: ${step.text}`),
    make("p", { class: `state ${tone}`, "data-sign": sign }, standing(step, time)),
    step.problem ? make("p", { class: "problem" }, step.problem) : null,
    make("dl", { class: "facts" },
      fact("Member", doer(step.member)), fact("Feature", step.feature),
      fact("Price", String(Math.round(step.cost * 100) / 100)),
      fact("Needs", step.after.length === 0 ? "nothing before it" : `step ${step.after.join(", ")}`),
      fact("Begun", at(step.begun_s)), fact("Ended", at(step.ended_s))),
    make("h3", {}, "Why this one and not another"),
    why === null ? make("p", { class: "quiet" }, "Planning it with others …")
      : why.problem ? make("p", { class: "problem" }, why.problem)
        : make("ul", {}, why.story.map((entry) => make("li", {}, entry.text))),
  ];
}
