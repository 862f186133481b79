/** Who was asked when a plan was made: each answer, and who was chosen. */
import { make } from "./dom.js";
import { longTable } from "./list.js";
import { doer } from "./plans.js";

const ANSWERS = {
  exact: ["✓", "good", "names a price for just this"],
  stated: ["✓", "good", "has stated a price"],
  "at-least": ["✓", "good", "costs at least so much"],
  refused: ["✗", "bad", "refused"],
  "not-asked": ["–", "", "was not asked"],
};

const answer = (bid) => `${ANSWERS[bid.answer][2]}${bid.reason ? `: ${bid.reason}` : ""}`;
const number = (value) => (value === null ? "–" : String(Math.round(value * 100) / 100));
const last = Number.MAX_VALUE;
const stepOf = (bid) => (bid.step ? `${bid.step.number} ${bid.step.text}` : "– in no step");

const COLUMNS = [
  { name: "Step", text: stepOf, value: (bid) => bid.step?.number ?? null, cell: (bid) => make("button", { class: "row", type: "button" }, stepOf(bid)) },
  { name: "Feature", className: "wide", text: (bid) => bid.feature },
  { name: "Asked", text: (bid) => doer(bid.member) },
  { name: "Answer", text: answer, cell: (bid) => make("span", { class: `answer ${ANSWERS[bid.answer][1]}`, "data-sign": ANSWERS[bid.answer][0] }, answer(bid)) },
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
