/** Goals: stating them, the list, and how far each is. */
import { make, byId, redraw, choices, seconds, wholeSeconds } from "./dom.js";
import { longTable } from "./list.js";
import { state, age, ask } from "./feed.js";
import { select, selection } from "./selection.js";

const SIGNS = {
  achieved: ["✓", "good"], holding: ["✓", "good"], failed: ["✗", "bad"], cancelled: ["–", ""],
  running: ["▶", ""], waiting: ["…", "wait"], suspended: ["…", "wait"],
};
const LAST = new Set(["achieved", "failed", "cancelled"]);
const MOST_SUGGESTED = 12;

/** What a goal counts as of which nobody says what it is worth. */
const UNWEIGHED = 100;

export function stateOf(goal) {
  const [sign, kind] = SIGNS[goal.state] ?? ["▷", ""];
  return make("span", { class: `state ${kind}`, "data-sign": sign, title: waits(goal) || goal.detail || goal.state }, goal.state);
}

export function isOver(goal) {
  return LAST.has(goal.state);
}

/** What a goal can be, with classes where its things are to stand. */
function templates() {
  const filled = (entry) => `(${[entry.word, ...entry.arguments.map((one) => one.class ?? "thing")].join(" ")})`;
  const of = (kind, form) => state.words.filter((entry) => entry.kind === kind)
    .map((entry) => ({ value: form(filled(entry)), text: entry.meaning ? `${entry.word}: ${entry.meaning}` : entry.word }));
  return [{ value: "", text: "template …" }, ...of("predicate", (text) => text), ...of("number", (text) => `(>= ${text} 1)`)];
}

const rounded = (number) => (number === null ? "unknown" : String(Math.round(number * 10) / 10));

/** How urgent it is by now; what is held and so does not become more urgent. */
function urgency({ worth, ...goal }) {
  if (worth.allowed_s === null) {
    return worth.urgency_from;
  }
  const elapsed = goal.state === "holding" ? 0 : worth.elapsed_s + age(goal) - (goal.age_s ?? 0);
  return Math.min(1, elapsed / worth.allowed_s) * (worth.urgency_to - worth.urgency_from) + worth.urgency_from;
}

/** u·g, by which it stands among goals of its priority; null when nobody says or knows what it is worth. */
function worthOf(goal) {
  return isOver(goal) || (goal.worth?.utility ?? null) === null ? null : goal.worth.utility * urgency(goal);
}

function worthText(goal) {
  const worth = worthOf(goal);
  return worth === null ? "–" : rounded(worth);
}

function worthInWords(goal) {
  if (isOver(goal)) {
    return "is over, and stands before nobody";
  }
  if (!goal.worth) {
    return `counts as ${UNWEIGHED}, as nobody says what it is worth`;
  }
  const { chance, benefit, cost, utility } = goal.worth;
  return `u = ${Math.round(chance * 100) / 100}·${rounded(benefit)} − ${rounded(cost)} = ${rounded(utility)}; g = ${rounded(urgency(goal))}`;
}

const waits = (goal) => goal.waits.map((wait) => `${wait.for} (${wait.holder})`).join(", ");
let listed = null;

function startList() {
  listed = longTable(byId("goal-list"), "goals", [
    { name: "Goal", text: (goal) => `${goal.id} ${goal.goal}`, cell: (goal) => make("button", { class: "row", type: "button", title: goal.goal }, `${goal.id} ${goal.goal}`) },
    { name: "State", text: (goal) => goal.state, shown: (goal) => [goal.state, waits(goal), goal.detail].join("\n"), cell: stateOf },
    { name: "Since", className: "number", text: (goal) => wholeSeconds(age(goal)), value: age },
    { name: "Worth", className: "wide number", text: worthText, value: (goal) => worthOf(goal) ?? UNWEIGHED, shown: (goal) => worthInWords(goal), cell: (goal) => make("span", { title: worthInWords(goal) }, worthText(goal)) },
    { name: "By", className: "wide state", text: (goal) => goal.requester ?? "–" },
    { name: "Waits for", className: "wide quiet", text: (goal) => waits(goal) || (isOver(goal) ? "" : goal.detail ?? "") },
  ], {
    isChosen: (goal) => goal.id === selection().goal,
    choose: (goal) => select({ goal: goal.id }),
  });
}

export function drawGoals() {
  choices(byId("goal-template"), templates());
  const list = byId("goal-list");
  if (state.goals.length === 0) {
    redraw(list, make("p", { class: "empty" },
      "No goal was stated yet. Write one above; the words that this home has are offered as you type."));
    return;
  }
  listed([...state.goals].reverse());
}

function wordAt(input) {
  const before = input.value.slice(0, input.selectionStart ?? input.value.length);
  return /[^\s()]*$/.exec(before)[0];
}

function suggestions(word) {
  if (word.length === 0 || word.startsWith("?")) {
    return [];
  }
  const small = word.toLowerCase();
  const rank = (entry) => (entry.word.toLowerCase().startsWith(small) ? 0 : 1);
  return state.words
    .filter((entry) => entry.word !== word && entry.kind !== "feature" && entry.word.toLowerCase().includes(small))
    .sort((a, b) => rank(a) - rank(b) || a.word.localeCompare(b.word))
    .slice(0, MOST_SUGGESTED);
}

/** Offers the words of the home while one is written. */
function complete(input, list) {
  let offered = [];
  let at = -1;
  const show = () => {
    list.replaceChildren(...offered.map((entry, i) => make("li", {
      role: "option", id: `suggestion-${i}`, "aria-selected": i === at ? "true" : "false",
      onmousedown: (event) => { event.preventDefault(); take(entry); },
    }, make("code", {}, entry.form), make("span", {}, entry.meaning ?? entry.kind))));
    list.hidden = offered.length === 0;
    input.setAttribute("aria-expanded", String(offered.length > 0));
    if (at >= 0) {
      input.setAttribute("aria-activedescendant", `suggestion-${at}`);
      list.children[at].scrollIntoView({ block: "nearest" });
    } else {
      input.removeAttribute("aria-activedescendant");
    }
  };
  const close = () => { offered = []; at = -1; show(); };
  const take = (entry) => {
    const end = input.selectionStart ?? input.value.length;
    const start = end - wordAt(input).length;
    const rest = input.value.slice(end);
    input.value = input.value.slice(0, start) + entry.word + rest;
    input.setSelectionRange(start + entry.word.length, start + entry.word.length);
    close();
    input.focus();
  };
  input.addEventListener("input", () => { offered = suggestions(wordAt(input)); at = -1; show(); });
  input.addEventListener("blur", close);
  input.addEventListener("keydown", (event) => {
    if (offered.length === 0) {
      return;
    }
    if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      at = (at + (event.key === "ArrowDown" ? 1 : -1) + offered.length) % offered.length;
      show();
    } else if ((event.key === "Enter" || event.key === "Tab") && at >= 0) {
      event.preventDefault();
      take(offered[at]);
    } else if (event.key === "Escape") {
      close();
    }
  });
}

/** A plan that nobody has begun. */
function planned(preview) {
  if (preview.verdict !== "plan") {
    return [make("p", { class: "quiet" }, preview.reason)];
  }
  if (preview.steps.length === 0) {
    return [make("p", {}, "It is so already, as far as is known.")];
  }
  return [
    make("p", {}, make("strong", {}, `Would cost ${Math.round(preview.cost * 100) / 100} and take ${seconds(preview.duration_s)}`),
      make("span", { class: "quiet" }, ", by prices as they are described:")),
    make("ol", { class: "plan" }, preview.steps.map((step) => make("li", {}, step.text,
      make("span", { class: "quiet" }, ` ${Math.round(step.cost * 100) / 100}, ${seconds(step.seconds)}`
        + (step.after.length > 0 ? `, after ${step.after.join(", ")}` : ""))))),
  ];
}

/** Where the first thing that is to be named stands. */
function firstPlace(goal) {
  const start = goal.indexOf(" ", goal.startsWith("(>= (") ? 5 : 1) + 1;
  return [start, start + goal.slice(start).search(/[ )]/)];
}

export function startGoals() {
  startList();
  const input = byId("goal-input");
  const problem = byId("goal-problem");
  const template = byId("goal-template");
  complete(input, byId("suggestions"));
  template.addEventListener("change", () => {
    if (template.value) {
      input.value = template.value;
      template.value = "";
      input.focus();
      input.setSelectionRange(...firstPlace(input.value));
    }
  });
  const plan = byId("goal-plan");
  const written = () => {
    problem.textContent = "";
    plan.replaceChildren();
    const goal = input.value.trim();
    problem.textContent = goal === "" ? "Write a goal first, such as (nextTo Cup Bob)." : "";
    return goal;
  };
  byId("goal-preview").addEventListener("click", async () => {
    const goal = written();
    if (goal === "") {
      return;
    }
    plan.textContent = "Planning …";
    try {
      plan.replaceChildren(...planned(await ask.preview(goal)));
    } catch (failure) {
      plan.replaceChildren();
      problem.textContent = failure.message;
    }
  });
  byId("goal-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    const goal = written();
    if (goal === "") {
      return;
    }
    try {
      const deadline = byId("goal-deadline").value;
      const benefit = byId("goal-benefit").value.trim();
      const { id } = await ask.state(goal, {
        priority: Number(byId("goal-priority").value),
        deadline: deadline === "" ? null : Number(deadline),
        stakes: { benefit: benefit === "" ? null : benefit },
      });
      input.value = "";
      byId("goal-priority").value = "0";
      byId("goal-deadline").value = "";
      byId("goal-benefit").value = "";
      select({ goal: id });
    } catch (failure) {
      problem.textContent = failure.message;
    }
  });
}
