/** The page: what is told is drawn, what is chosen is shown. */
import { byId } from "./dom.js";
import { state, changed, connect, onChange, onShutOut, ask } from "./feed.js";
import { select, selection, onSelect } from "./selection.js";
import { mayNot, recognize, startSession } from "./session.js";
import { drawAlerts, startAlerts } from "./alerts.js";
import { drawMap } from "./map.js";
import { drawGoals, startGoals } from "./goals.js";
import { drawDetail } from "./detail.js";
import { isCourse } from "./course.js";
import { drawMembers, startMembers } from "./members.js";
import { drawKnowledge, startKnowledge } from "./knowledge.js";
import { drawPast, startPast } from "./past.js";
import { drawHappened, drawHistory, startHistory } from "./history.js";
import { drawTruth, startTruth } from "./truth.js";
import { drawChat, startChat } from "./chat.js";
import { drawStates } from "./states.js";
import { drawBus, drawBusMessage, startBus } from "./bus.js";
import { drawConversations, drawConversation, startConversations } from "./conversations.js";

const VIEWS = {
  goals: drawGoals, chat: drawChat, members: drawMembers, knowledge: drawKnowledge, history: drawHistory, states: drawStates, bus: drawBus, conversations: drawConversations,
};
/** What stands beside a view that shows more than what is chosen on the map. */
const DETAILS = { history: drawHappened, bus: drawBusMessage, conversations: drawConversation };
const LINK = {
  connecting: "connecting",
  live: "live",
  lost: "The platform does not answer; what is shown is what was told last.",
};

function drawFrame() {
  const { view } = selection();
  for (const name of Object.keys(VIEWS)) {
    byId(name).hidden = name !== view;
    document.querySelector(`[data-view="${name}"]`).setAttribute("aria-pressed", String(name === view));
  }
  const main = document.querySelector("main");
  main.dataset.view = view;
  main.toggleAttribute("data-wide", isCourse());
  byId("home-name").textContent = state.home.label ?? "MAESTRO";
  byId("platform-name").textContent = state.platform ? `platform ${state.platform.platform}` : "";
  const stop = byId("stop");
  const why = mayNot("operator");
  stop.dataset.title ??= stop.title;
  stop.disabled = why !== null;
  stop.title = why ?? stop.dataset.title;
  const link = byId("link");
  link.textContent = LINK[state.live];
  link.className = `link ${state.live}`;
}

function drawView() {
  VIEWS[selection().view]();
}

function drawChosen() {
  (DETAILS[selection().view] ?? drawDetail)();
}

const PARTS = [drawFrame, drawAlerts, drawMap, drawTruth, drawView, drawChosen, drawPast];

function drawAll() {
  PARTS.forEach((part) => part());
}

function theme(name) {
  document.documentElement.dataset.theme = name;
  localStorage.setItem("theme", name);
}

function say(text) {
  const notice = byId("notice");
  notice.textContent = text;
  notice.hidden = text === "";
  if (text) {
    setTimeout(() => { if (notice.textContent === text) { notice.hidden = true; } }, 8000);
  }
}

document.querySelectorAll("[data-view]").forEach((button) =>
  button.addEventListener("click", () => select({ view: button.dataset.view })));
byId("theme").addEventListener("click", () =>
  theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
byId("stop").addEventListener("click", () =>
  ask.stop().then(() => say("Every device was told to go into a safe state."), (failure) => say(failure.message)));
theme(localStorage.getItem("theme") ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));
let leave = () => {};
onShutOut(() => recognize().catch(() => false));
startAlerts();
startGoals();
startMembers();
startKnowledge();
startHistory();
startBus();
startConversations();
startChat();
startTruth();
PARTS.forEach(onChange);
onSelect(drawAll);
// Ages go on.
setInterval(() => { if (!document.hidden) { changed(); } }, 1000);
let isFirst = true;
startSession(() => {
  leave();
  leave = connect();
  if (isFirst) {
    startPast();
    isFirst = false;
  }
});
drawAll();
