/** A question of a script that is answered by choosing or setting instead of words: radio buttons, or a slider. */
import { make, byId } from "./dom.js";
import { state, ask } from "./feed.js";
import { isOver } from "./goals.js";
import { acting } from "./past.js";

let shown = "";

/** The oldest that nobody has answered, whose script goes on. */
function open(entries) {
  const answered = new Set(entries.filter((entry) => entry.kind === "answered").map((entry) => entry.question));
  const goals = new Map(state.goals.map((goal) => [goal.id, goal]));
  const goesOn = (id) => !goals.has(id) || !isOver(goals.get(id));
  return entries.find((entry) => entry.kind === "asked" && (entry.choice || entry.slider) && !answered.has(entry.question) && goesOn(entry.goal)) ?? null;
}

function radioButtons(choice) {
  return make("div", { class: "options" }, choice.map((text, i) =>
    make("div", { class: "option" },
      make("input", { type: "radio", name: "chat-answer", id: `chat-answer-${i}`, value: text, required: true }),
      make("label", { for: `chat-answer-${i}` }, text))));
}

/** Which of the numbers is set stands beside it, and what the ends mean below. */
function slider({ lowest, highest, step, lowest_label: low, highest_label: high }, question) {
  const middle = Number((lowest + Math.round((highest - lowest) / step / 2) * step).toFixed(9));
  const told = make("output", { for: "chat-answer" }, String(middle));
  const input = make("input", {
    type: "range", id: "chat-answer", min: lowest, max: highest, step, value: middle, "aria-label": question, "aria-describedby": "chat-answer-ends",
    oninput: () => { told.textContent = input.value; },
  });
  return [
    make("div", { class: "entry" }, input, told),
    make("p", { id: "chat-answer-ends", class: "ends quiet" },
      make("span", {}, low === "" ? String(lowest) : `${lowest}: ${low}`), make("span", {}, high === "" ? String(highest) : `${highest}: ${high}`)),
  ];
}

/**
 * @param entries of the conversation, oldest first
 * @param person who answers
 */
export function drawQuestion(entries, person) {
  const form = byId("chat-question");
  const asked = open(entries);
  const now = asked === null ? "" : `${asked.number} ${person}`;
  if (now === shown) {
    return;
  }
  shown = now;
  form.hidden = asked === null;
  if (asked === null) {
    form.replaceChildren();
    return;
  }
  const hadFocus = form.contains(document.activeElement);
  const problem = make("p", { class: "problem", role: "alert" });
  form.replaceChildren(
    make("fieldset", {},
      make("legend", {}, asked.text),
      asked.choice ? radioButtons(asked.choice) : slider(asked.slider, asked.text),
      make("button", { type: "submit", ...acting() }, "Answer"),
      problem));
  if (hadFocus) {
    form.querySelector("input").focus();
  }
  form.onsubmit = async (event) => {
    event.preventDefault();
    problem.textContent = "";
    // The name of the radio buttons, or the id of the slider.
    const answer = form.elements["chat-answer"].value;
    try {
      await ask.answer(asked.question, answer, person);
    } catch (failure) {
      problem.textContent = failure.message;
    }
  };
}
