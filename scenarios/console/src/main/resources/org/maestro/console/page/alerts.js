/** What a person should look at: what keeps the platform from its work, who is lost or refused, which goals have failed lately. */
import { make, byId, redraw, seconds } from "./dom.js";
import { state, age } from "./feed.js";
import { select } from "./selection.js";

/** Simulated seconds. */
const LATELY = 600;

function alerts() {
  const members = state.agents.filter((agent) => agent.members.length > 0 && (agent.phase !== "ready" || agent.why));
  const failed = state.goals.filter((goal) => goal.state === "failed" && age(goal) < LATELY);
  const silent = (state.states?.containers ?? []).filter((container) => container.state !== "well");
  return [
    ...state.health.reasons.map((reason) => ({ text: reason })),
    ...silent.map(({ container, state: standing, why }) => ({
      name: container,
      text: `is ${standing}: ${why}`,
      choose: () => select({ view: "states" }),
    })),
    ...members.map((agent) => ({
      name: agent.members.join(" "),
      text: agent.why ? `is refused: ${agent.why}` : `is ${agent.phase}, for ${seconds(age(agent))}`,
      choose: () => select({ view: "members", thing: agent.members[0] }),
    })),
    ...failed.map((goal) => ({
      name: `${goal.id} ${goal.goal}`,
      text: `failed ${seconds(age(goal))} ago${goal.detail ? `: ${goal.detail}` : ""}`,
      choose: () => select({ view: "goals", goal: goal.id }),
    })),
  ];
}

export function drawAlerts() {
  const all = alerts();
  const button = byId("alerts-open");
  button.hidden = all.length === 0;
  button.textContent = all.length === 1 ? "▲ 1 alert" : `▲ ${all.length} alerts`;
  const list = byId("alerts");
  list.hidden = all.length === 0 || button.getAttribute("aria-expanded") !== "true";
  if (!list.hidden) {
    redraw(list, all.map(({ name, text, choose }) => make("li", {},
      choose ? [make("button", { class: "row", type: "button", onclick: choose }, name), ` ${text}`] : text)));
  }
}

export function startAlerts() {
  const button = byId("alerts-open");
  button.addEventListener("click", () => {
    button.setAttribute("aria-expanded", String(button.getAttribute("aria-expanded") !== "true"));
    drawAlerts();
  });
}
