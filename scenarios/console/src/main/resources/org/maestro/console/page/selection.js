/** What is looked at: one view, and what is chosen in it; it stands in the address, to be sent on. */
const VIEWS = ["goals", "members", "knowledge", "bus", "conversations"];
/** What of a goal. */
export const SHOWN = ["story", "plan", "time", "bids"];
const listeners = new Set();

export function selection() {
  const parameters = new URLSearchParams(location.hash.slice(1));
  return {
    view: VIEWS.includes(parameters.get("view")) ? parameters.get("view") : "goals",
    goal: parameters.get("goal"),
    thing: parameters.get("thing"),
    fact: parameters.get("fact"),
    message: parameters.get("message"),
    conversation: parameters.get("conversation"),
    said: parameters.get("said"),
    show: SHOWN.includes(parameters.get("show")) ? parameters.get("show") : "story",
    plan: parameters.get("plan"),
    step: parameters.get("step"),
  };
}

/** One of these is looked at in full, at a time. */
const CHOSEN = ["goal", "thing", "fact"];

export function select(change) {
  const now = selection();
  const isOther = "goal" in change && change.goal !== now.goal;
  const next = { ...now, ...(isOther ? { plan: null, step: null } : {}), ...change };
  if (CHOSEN.some((kind) => change[kind])) {
    CHOSEN.filter((kind) => !change[kind]).forEach((kind) => { next[kind] = null; });
  }
  const parameters = new URLSearchParams();
  Object.entries(next).filter(([, value]) => value).forEach(([name, value]) => parameters.set(name, value));
  location.hash = parameters.toString();
}

export function onSelect(listener) {
  listeners.add(listener);
}

addEventListener("hashchange", () => listeners.forEach((listener) => listener()));
