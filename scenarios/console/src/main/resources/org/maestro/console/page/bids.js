/** Who was asked when a plan was made: each answer, and who was chosen. */
import { make } from "./dom.js";
import { longTable } from "./list.js";
import { doer } from "./plans.js";

const ANSWERS = {
  exact: "names a price for just this",
  stated: "has stated a price",
  "at-least": "costs at least so much",
  refused: "✗ refused",
  "not-asked": "– was not asked",
};
const PRICED = new Set(["exact", "stated", "at-least"]);

function answer({ answer: kind, cost, reason }) {
  return `${ANSWERS[kind]}${PRICED.has(kind) && cost === null ? ", by a formula" : ""}${reason ? `: ${reason}` : ""}`;
}

const number = (value) => (value === null ? "–" : String(Math.round(value * 100) / 100));
const last = Number.MAX_VALUE;
const stepOf = (bid) => (bid.step ? `${bid.step.number} ${bid.step.text}` : "– in no step");

const COLUMNS = [
  { name: "Step", text: stepOf, value: (bid) => bid.step?.number ?? null, cell: (bid) => (bid.step ? make("button", { class: "row", type: "button" }, stepOf(bid)) : make("span", { class: "quiet" }, stepOf(bid))) },
  { name: "Feature", className: "wide", text: (bid) => bid.feature },
  { name: "Asked", text: (bid) => doer(bid.member) },
  { name: "Answer", text: answer, cell: (bid) => make("span", { class: bid.answer === "refused" ? "refused" : null }, answer(bid)) },
  { name: "Price", className: "number", text: (bid) => number(bid.cost), value: (bid) => bid.cost },
  { name: "Time (s)", className: "number wide", text: (bid) => number(bid.duration_s), value: (bid) => bid.duration_s },
  { name: "Chosen", className: "state", text: (bid) => (bid.chosen ? "✓ chosen" : "–") },
];

/**
 * Returns what draws the bids of a plan into the container: by step, who was chosen first, then the cheaper one.
 * @param choose is told the number of a step
 */
export function bidTable(container, choose) {
  let chosen = null;
  const list = longTable(container, "bids", COLUMNS, {
    isChosen: (bid) => bid.step !== undefined && bid.step.number === chosen,
    choose: (bid) => choose(bid.step?.number ?? null),
  });
  return (plan, bids, step) => {
    chosen = step;
    const byNumber = new Map(plan.steps.map((one) => [one.number, one]));
    const place = (bid) => [bid.step?.number ?? last, bid.chosen ? 0 : 1, bid.cost ?? last];
    list(bids.map((bid) => ({ ...bid, step: byNumber.get(bid.step) }))
      .sort((a, b) => place(a).map((part, i) => part - place(b)[i]).find((difference) => difference !== 0) ?? a.member.localeCompare(b.member)));
  };
}
