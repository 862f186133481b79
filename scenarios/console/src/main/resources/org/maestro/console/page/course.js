/** The course of a goal beside its story: its plans as graphs, all steps on a time line, and who was asked. */
import { make, byId, redraw, choices } from "./dom.js";
import { state } from "./feed.js";
import { select, selection, SHOWN } from "./selection.js";
import { plansOf, bidsOf, whyOf, now, onPlans } from "./plans.js";
import { stepDetail } from "./step.js";
import { graph } from "./graph.js";
import { timeline } from "./timeline.js";
import { scriptSteps } from "./script.js";
import { bidTable } from "./bids.js";

const BESIDE = new Set(["goals", "members", "knowledge"]);
const NAMES = { story: "Story", plan: "Plan", time: "Time line", bids: "Bids" };

/** What of a goal is to be looked at. */
export function tabs() {
  const { show } = selection();
  return make("span", { class: "tabs", role: "group", "aria-label": "What of the goal" }, SHOWN.map((name) =>
    make("button", { type: "button", "aria-pressed": String(name === show), "data-show": name, onclick: () => select({ show: name }) }, NAMES[name])));
}

const head = make("div", { class: "head" });
const chooser = make("select", { id: "course-plan", onchange: () => select({ plan: chooser.value, step: null }) });
const about = make("p", { class: "about quiet" });
const choosing = make("span", { class: "choosing" }, make("label", { for: "course-plan" }, "Plan"), chooser);
const which = make("div", { class: "which more" }, choosing, about);
const picture = make("div", { class: "picture", tabindex: 0, role: "region" });
const aside = make("div", { class: "aside", tabindex: 0, role: "region", "aria-label": "The chosen step" });
const script = make("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Steps of the script" });
const list = make("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Bids" });
const body = make("div", { class: "body" });
const frame = make("div", { class: "course" }, head, which, body);
const drawBids = bidTable(list, (step) => select({ step, plan: chosenPlan().number }));

/** What is pressed is not drawn anew before it is let go: it would be no click. */
let isHeld = false;
frame.addEventListener("pointerdown", () => { isHeld = true; });
["pointerup", "pointercancel"].forEach((name) => addEventListener(name, () => {
  if (isHeld) {
    setTimeout(() => { isHeld = false; drawCourse(); });
  }
}));

let drawn = "";
let isOver = () => false;

/** The plan that is chosen, or the latest; one without steps only where no other is there. */
function chosenPlan() {
  const { goal, plan } = selection();
  const plans = plansOf(goal).plans ?? [];
  return plans.find((one) => String(one.number) === plan) ?? plans.filter((one) => one.steps.length > 0).at(-1) ?? plans.at(-1);
}

const chosenStep = (plan) => plan?.steps.find((step) => String(step.number) === selection().step);

const LEGEND = "Seconds of the platform's clock. ✓ done, ▶ under way, ✗ failed, – called off; hatched: to come, as it is planned now.";

/** What was tried after the plan that is shown as the latest. */
function afterwards(goal, plans, plan) {
  const last = plans.at(-1);
  return last === plan || selection().plan ? "" : ` ${isOver(goal) ? "No plan came of" : "Being made:"} ${last.number}${last.cause ? `, because ${last.cause}` : ""}.`;
}

function drawWhich(goal, plans, plan) {
  which.hidden = !plan;
  choosing.hidden = selection().show === "time";
  if (!plan || choosing.hidden) {
    about.textContent = LEGEND;
    return;
  }
  const because = (one) => (one.cause ? `: ${one.cause.length > 60 ? `${one.cause.slice(0, 59)}…` : one.cause}` : "");
  choices(chooser, [{ value: "", text: "the latest" }, ...plans.map((one) => ({ value: String(one.number), text: `${one.number}${because(one)}` }))]);
  chooser.value = plans.some((one) => String(one.number) === selection().plan) ? selection().plan : "";
  about.textContent = `Plan ${plan.number}${plan.cause ? `, because ${plan.cause}` : ""}. `
    + (plan.made_s === null ? "" : `It costs ${Math.round(plan.cost * 100) / 100}, and was to take ${plan.duration_s.toFixed(1)} s`
      + `${plan.purpose === "see" ? ", to see that the goal is reached" : ""}.`)
    + (plan.not_asked > 0 ? ` ${plan.not_asked} others describe higher prices, and were not asked.` : "")
    + afterwards(goal, plans, plan)
    + (selection().show === "bids" ? " A member is asked for a feature; why one of a lower price did not get a step, that step tells under Plan." : "");
  about.title = about.textContent;
}

/** Where there is nothing to draw: what to do instead. */
function emptiness(goal, { plans, script: steps, problem }, plan) {
  if (problem) {
    return make("p", { class: "problem", role: "alert" }, problem);
  }
  if (plans === null) {
    return make("p", { class: "empty" }, "…");
  }
  if (steps.length > 0) {
    return make("p", { class: "empty" }, "This goal is a script: Plan shows its steps, and its story tells who did what for each.");
  }
  if (!plan) {
    return make("p", { class: "empty" }, isOver(goal)
      ? "No plan is kept of this goal: plans are kept of the latest goals, and not beyond a restart. Its story tells what happened."
      : "No plan was made yet; it is drawn here as soon as there is one. The story tells what the goal waits for.");
  }
  return make("p", { class: "empty" }, plan.made_s !== null ? "Nothing has to be done by this plan: as far as is known it is so already."
    : isOver(goal) || plan !== plans.at(-1) ? "No plan came of this. Bids shows who was asked, the story why none was found."
      : "This plan is being made; Bids shows who was asked, as soon as all have answered.");
}

/** Only what is to look otherwise is made anew, so that it can be marked and copied meanwhile. */
function drawIfNew(part, looks, made) {
  const now = looks.join(" ");
  if (part.dataset.looks !== now) {
    part.dataset.looks = now;
    redraw(part, made());
  }
}

function drawPicture(goal, read, plan, time) {
  const { show } = selection();
  const step = chosenStep(plan);
  const goesOn = !isOver(goal);
  const why = step ? whyOf(goal, plan, step) : null;
  picture.setAttribute("aria-label", show === "plan" ? "Plan as a graph" : "Time line");
  aside.hidden = show === "time" && !step;
  aside.classList.toggle("none", !step);
  put(picture, aside);
  const looks = [goal, plan.number, step?.number, read.heard, state.agents.length, goesOn ? Math.floor(performance.now() / 1000) : ""];
  drawIfNew(picture, [show, picture.clientWidth, ...looks], () => (show === "plan"
    ? graph(plan, { chosen: step?.number, time, choose: (number) => select({ plan: plan.number, step: number }) })
    : timeline(read.plans, picture.clientWidth, {
      chosen: step ? `${plan.number}/${step.number}` : null, time, goesOn,
      choose: (number, chosen) => select({ plan: number, step: chosen }),
    })));
  drawIfNew(aside, [why === null, ...(step?.state === "under-way" ? looks : looks.slice(0, -1))], () => (step ? stepDetail(plan, step, why, time)
    : make("p", { class: "empty" }, "Choose a step to see why it was given to that member, and not to another.")));
}

/** Parts that stay keep how far they are scrolled. */
function put(...parts) {
  if (body.children.length !== parts.length || parts.some((part, i) => body.children[i] !== part)) {
    body.replaceChildren(...parts);
  }
}

/** What is under way goes on by the second. */
function drawScript(goal, read, time) {
  put(script);
  drawIfNew(script, [goal, read.heard, isOver(goal) ? "" : Math.floor(performance.now() / 1000)], () => scriptSteps(read.script, time));
}

function drawBody(goal, read, plan, time) {
  const { show } = selection();
  const { plans } = read;
  if (show === "plan" && read.script.length > 0) {
    drawScript(goal, read, time);
    return;
  }
  if (show === "bids" && plan) {
    const answer = bidsOf(goal, plan);
    const bids = answer?.bids ?? [];
    if (bids.length === 0) {
      put(make("p", { class: answer?.problem ? "problem" : "empty" }, answer === null ? "…"
        : answer.problem ?? "Nobody has answered for this plan: either all is so already, or nobody can help; the story tells which."));
    } else {
      put(list);
      const step = chosenStep(plan)?.number ?? null;
      const looks = [goal, plan.number, plan.made_s, bids.length, step, state.agents.length].join(" ");
      if (list.dataset.looks !== looks) {
        list.dataset.looks = looks;
        drawBids(plan, bids, step);
      }
    }
  } else if (show === "time" && plans?.some((one) => one.steps.some((step) => step.begun_s !== null || step.state === "waiting"))) {
    drawPicture(goal, read, plan, time);
  } else if (show === "plan" && plan?.steps.length > 0) {
    drawPicture(goal, read, plan, time);
  } else {
    put(emptiness(goal, read, plan));
  }
}

/** What is to be seen comes into sight once, when it is chosen or first drawn; the keys go on from there. */
function bringIntoSight() {
  const step = picture.querySelector(".step.chosen") ?? picture.querySelector(".step.going");
  if (!step) {
    return;
  }
  const [at, room] = [step.getBoundingClientRect(), picture.getBoundingClientRect()];
  if (at.left < room.left || at.right > room.right) {
    picture.scrollLeft += at.left - room.left - (room.width - at.width) / 2;
  }
  if (at.top < room.top || at.bottom > room.bottom) {
    picture.scrollTop += at.top - room.top - (room.height - at.height) / 2;
  }
  if (picture.contains(document.activeElement) && document.activeElement !== picture) {
    step.focus({ preventScroll: true });
  }
}

/** Whether it is looked at, beside a view that has the map; plans and bids are told as they are now. */
export function isCourse() {
  const { view, goal, show, at } = selection();
  return Boolean(goal) && at === null && show !== "story" && BESIDE.has(view);
}

/** Draws it if it is looked at; else says so. */
export function drawCourse() {
  const { goal, plan: number, step, show } = selection();
  if (!isCourse()) {
    drawn = "";
    return false;
  }
  if (isHeld) {
    return true;
  }
  const detail = byId("detail");
  if (frame.parentElement !== detail) {
    detail.replaceChildren(frame);
    drawn = "";
  }
  const read = plansOf(goal);
  const plan = chosenPlan();
  const time = now();
  redraw(head, courseHead(goal));
  drawWhich(goal, read.plans ?? [], plan);
  drawBody(goal, read, plan, time);
  const looks = [goal, show, number, step, read.plans === null].join(" ");
  if (looks !== drawn) {
    drawn = looks;
    bringIntoSight();
  }
  return true;
}

let courseHead = () => null;

/**
 * @param heading what is above it, of a goal
 * @param over whether a goal is over
 */
export function startCourse(heading, over) {
  courseHead = heading;
  isOver = over;
  onPlans(drawCourse);
  addEventListener("resize", () => drawCourse());
}
