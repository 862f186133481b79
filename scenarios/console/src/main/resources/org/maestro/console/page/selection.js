/** What is looked at: one view, and what is chosen in it; it stands in the address, to be sent on. */
const VIEWS = ["goals", "chat", "members", "knowledge", "history", "states", "bus", "conversations"];
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
    /** The instant that is shown; null for now. */
    at: parameters.get("at"),
    /** Who speaks in the chat, and where. */
    person: parameters.get("person"),
    room: parameters.get("room"),
    /** Whether simulated truth is drawn. */
    truth: parameters.get("truth"),
  };
}

/** One of these is looked at in full, at a time. */
const CHOSEN = ["goal", "thing", "fact"];

/** What is passed over quickly, such as times, leaves no step to go back to. */
export function select(change, { isPassing = false } = {}) {
  const now = selection();
  const isOther = "goal" in change && change.goal !== now.goal;
  const next = { ...now, ...(isOther ? { plan: null, step: null } : {}), ...change };
  if (CHOSEN.some((kind) => change[kind])) {
    CHOSEN.filter((kind) => !change[kind]).forEach((kind) => { next[kind] = null; });
  }
  const parameters = new URLSearchParams();
  Object.entries(next).filter(([, value]) => value).forEach(([name, value]) => parameters.set(name, value));
  if (isPassing) {
    history.replaceState(null, "", `#${parameters}`);
    tell();
  } else {
    location.hash = parameters.toString();
  }
}

function tell() {
  listeners.forEach((listener) => listener());
}

export function onSelect(listener) {
  listeners.add(listener);
}

addEventListener("hashchange", tell);
