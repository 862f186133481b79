/** What the platform tells: the latest of everything, and who wants to know. */
const ROOT = "/api/v1";

/** What is told of the home at one time, before anything is. */
function nothing() {
  return {
    home: { things: [] },
    thingByName: new Map(),
    facts: new Map(),
    /** How many more there are that are private. */
    leftOut: 0,
    /** What was known last under a word of a thing, and is not any more: it was seen too long ago. */
    former: new Map(),
    /** The facts under each word, by the first thing that they are about. */
    factsByWord: new Map(),
    goals: [],
    agents: [],
    agentByMember: new Map(),
  };
}

const now = { platform: null, words: [], health: { reasons: [] }, states: null, live: "connecting", ...nothing() };

/** What is shown: what is so now, or what was so at a time. */
export let state = now;

const listeners = new Set();
const storyListeners = new Set();
let isToBeTold = false;
let isTelling = false;

/** Where drawing takes long, it is done less often: it takes a quarter of the time at most. */
let freeAt = 0;
const SHARE = 4;

/** As much is drawn for one picture as does not keep the next one back. */
const PICTURE_MILLIS = 12;

/** Each draws a part of the page, in this order. */
export function onChange(listener) {
  listeners.add(listener);
}

export function onStory(listener) {
  storyListeners.add(listener);
}

/** Told when the picture is seen for which parts were drawn: to lay it out takes its time, too. */
const picture = new MessageChannel();
let seen = () => {};
picture.port1.onmessage = () => seen();

/** A part that fails keeps no other back. */
function tellOne(listener) {
  try {
    listener();
  } catch (failure) {
    reportError(failure);
  }
}

/** What takes too long for one picture goes on with the next. */
function tell(left, spent) {
  const begin = performance.now();
  while (left.length > 0 && performance.now() - begin < PICTURE_MILLIS) {
    tellOne(left.shift());
  }
  seen = () => {
    const taken = spent + performance.now() - begin;
    if (left.length > 0) {
      requestAnimationFrame(() => tell(left, taken));
      return;
    }
    isTelling = false;
    freeAt = performance.now() + (SHARE - 1) * taken;
    if (isToBeTold) {
      tellSoon();
    }
  };
  picture.port2.postMessage(null);
}

function tellSoon() {
  isTelling = true;
  const next = () => requestAnimationFrame(() => {
    isToBeTold = false;
    tell([...listeners], 0);
  });
  const pause = freeAt - performance.now();
  if (pause > 0) {
    setTimeout(next, pause);
  } else {
    next();
  }
}

/** All listeners are told once more, however much has changed meanwhile. */
export function changed() {
  isToBeTold = true;
  if (!isTelling) {
    tellSoon();
  }
}

async function answer(response) {
  if (response.ok) {
    return response.status === 204 ? null : response.json();
  }
  let problem = `The platform answers with the status ${response.status}.`;
  try {
    problem = (await response.json()).problem;
  } catch {
    // There is no sentence of its own.
  }
  throw new Error(problem);
}

/** What a page of ours alone can send, where there are sessions. */
let csrf = null;
let shutOut = () => Promise.resolve(false);

export function authorize(token) {
  csrf = token;
}

/** Told when the platform does not know any more who looks; its answer is whether she is still the same. */
export function onShutOut(listener) {
  shutOut = listener;
}

async function request(path, options = {}, isAgain = false) {
  const sent = csrf;
  let response;
  try {
    response = await fetch(ROOT + path, sent === null ? options : { ...options, headers: { ...options.headers, "X-CSRF-Token": sent } });
  } catch {
    throw new Error("The platform does not answer; see whether it still runs.");
  }
  if (response.status === 401 && path !== "/session") {
    shutOut();
  }
  // She has signed in anew in another page meanwhile: this one has the token of the session before.
  if (response.status === 403 && sent !== null && !isAgain && (await shutOut()) && csrf !== sent) {
    return request(path, options, true);
  }
  return answer(response);
}

function send(method, path, body) {
  return request(path, {
    method,
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(body),
  });
}

export const ask = {
  home: () => request("/home"),
  session: () => request("/session"),
  signIn: (name, password) => send("POST", "/session", { name, password }),
  signOut: () => request("/session", { method: "DELETE" }),
  story: (goal) => request(`/goals/${encodeURIComponent(goal)}/story`),
  plans: (goal) => request(`/goals/${encodeURIComponent(goal)}/plans`),
  bids: (goal, plan) => request(`/goals/${encodeURIComponent(goal)}/bids?plan=${plan}`),
  why: (goal, plan, step) => request(`/goals/${encodeURIComponent(goal)}/story?plan=${plan}&step=${step}`),
  know: (question) => request(`/knowledge?question=${encodeURIComponent(question)}`),
  history: (fact) => request(`/knowledge/history?fact=${encodeURIComponent(fact)}`),
  query: (query) => send("POST", "/queries", { query }),
  state: (goal, { priority = 0, deadline = null, stakes = {} } = {}) => send("POST", "/goals", { goal, priority, deadline_s: deadline, ...stakes }),
  preview: (goal) => send("POST", "/previews", { goal }),
  containers: () => request("/containers"),
  states: () => request("/states"),
  truth: () => request("/truth"),
  answer: (question, text, person) => send("POST", `/questions/${encodeURIComponent(question)}/answer`, { text, person }),
  say: (person, room, text) => send("POST", "/chat", { person, room, text }),
  member: (name) => request(`/members/${encodeURIComponent(name)}`),
  call: (member, feature, parameters) => send("POST", `/members/${encodeURIComponent(member)}/calls`, { feature, parameters }),
  made: (id) => request(`/calls/${encodeURIComponent(id)}`),
  addAgents: (description) => send("POST", "/agents", { description }),
  moveAgent: (agent, to) => send("POST", `/agents/${encodeURIComponent(agent)}/moves`, { to }),
  reconfigureAgent: (agent, description) => send("POST", `/agents/${encodeURIComponent(agent)}/descriptions`, { description }),
  removeAgent: (agent) => request(`/agents/${encodeURIComponent(agent)}`, { method: "DELETE" }),
  cancel: (goal) => request(`/goals/${encodeURIComponent(goal)}`, { method: "DELETE" }),
  endCall: (id) => request(`/calls/${encodeURIComponent(id)}`, { method: "DELETE" }),
  stop: () => request("/safe-state", { method: "POST" }),
  stopMember: (name) => request(`/members/${encodeURIComponent(name)}/safe-state`, { method: "POST" }),
  busMessage: (number) => request(`/bus/${number}`),
  day: (person, date) => request(`/days/${encodeURIComponent(person)}${date === "" ? "" : `?date=${date}`}`),
  kept: () => request("/history"),
  past: (at) => request(`/history/state?at=${encodeURIComponent(at)}`),
  happened: (from, to) => request(`/history/events?from=${encodeURIComponent(from)}&to=${encodeURIComponent(to)}`),
  samples: (series, from, to) => request(`/history/samples?series=${encodeURIComponent(series.join(","))}&from=${from}&to=${to}`),
  conversation: (id) => request(`/conversations/${encodeURIComponent(id)}`),
};

/** Ages go on while nothing is told. */
function dated(row) {
  return { ...row, heard: performance.now() };
}

/** Those of the past stand still. */
export function age(row) {
  return (row.age_s ?? 0) + (row.heard === undefined ? 0 : ((performance.now() - row.heard) / 1000) * (now.platform?.speed ?? 1));
}

function forget(told, name) {
  const fact = told.facts.get(name);
  if (fact) {
    told.facts.delete(name);
    told.factsByWord.get(fact.word).get(fact.arguments[0])?.delete(name);
  }
  return fact;
}

const lastKey = (fact) => `${fact.word} ${fact.arguments[0]}`;

function learn({ facts, factsByWord }, fact) {
  facts.set(fact.fact, fact);
  if (!factsByWord.has(fact.word)) {
    factsByWord.set(fact.word, new Map());
  }
  const byFirst = factsByWord.get(fact.word);
  if (!byFirst.has(fact.arguments[0])) {
    byFirst.set(fact.arguments[0], new Map());
  }
  byFirst.get(fact.arguments[0]).set(fact.fact, fact);
}

function takeHome(told, home) {
  told.home = home;
  told.thingByName = new Map(home.things.map((thing) => [thing.name, thing]));
}

function takeAgents(told, agents) {
  told.agents = agents;
  told.agentByMember = new Map(agents.flatMap((agent) => agent.members.map((member) => [member, agent])));
}

const TAKEN = {
  home: (news) => takeHome(now, news),
  facts: (news) => {
    if (news.all) {
      [now.facts, now.former, now.factsByWord].forEach((map) => map.clear());
    }
    news.gone.forEach((name) => {
      const fact = forget(now, name);
      if (fact && fact.value !== false) {
        now.former.set(lastKey(fact), fact);
      }
    });
    news.facts.forEach((fact) => learn(now, dated(fact)));
    now.leftOut = news.left_out;
  },
  goals: (news) => { now.goals = news.goals.map(dated); },
  health: (news) => { now.health = news; },
  states: (news) => { now.states = news; },
  agents: (news) => takeAgents(now, news.agents.map(dated)),
};

/**
 * From now on what was so is shown, as it was told then; null: what is so now. All parts change in
 * one picture: none shows one time while another says that it is a different one.
 */
export function show(past) {
  if (past === null) {
    state = now;
  } else {
    // What has no past, such as the words of the home, is as it is now.
    state = Object.assign(Object.create(now), nothing(), { goals: past.goals });
    const isOther = past.home !== null && JSON.stringify(past.home) !== JSON.stringify(now.home);
    takeHome(state, isOther ? past.home : now.home);
    past.facts.forEach((fact) => learn(state, fact));
    past.former.forEach((fact) => state.former.set(lastKey(fact), fact));
    takeAgents(state, past.agents);
  }
  listeners.forEach(tellOne);
}

/** A browser keeps few connections to one address: a page that nobody sees leaves its own to others. Returns what ends it. */
function whileSeen(open, left = () => {}) {
  let events = null;
  const leave = () => {
    events?.close();
    events = null;
    left();
  };
  const follow = () => {
    if (document.hidden) {
      leave();
    } else {
      events ??= open();
    }
  };
  const told = [[document, "visibilitychange", follow], [window, "pagehide", leave], [window, "pageshow", follow]];
  told.forEach(([from, name, listener]) => from.addEventListener(name, listener));
  follow();
  return () => {
    told.forEach(([from, name, listener]) => from.removeEventListener(name, listener));
    events?.close();
  };
}

/**
 * Hears one stream of its own for as long as somebody looks at it; what is returned ends that.
 * What is heard above all may be said, and how the link is be told: live, lost, or closed for good.
 */
export function listen(name, heard, { of = "", link = () => {} } = {}) {
  return whileSeen(() => {
    const events = new EventSource(`${ROOT}/events/${name}${of === "" ? "" : `?of=${encodeURIComponent(of)}`}`);
    let isFirst = true;
    events.addEventListener("open", () => {
      isFirst = true;
      link("live");
    });
    events.addEventListener("error", () => link(events.readyState === EventSource.CLOSED ? "closed" : "lost"));
    events.addEventListener(name, (event) => {
      heard(JSON.parse(event.data), isFirst);
      isFirst = false;
      changed();
    });
    return events;
  });
}

function hearAll() {
  const events = new EventSource(`${ROOT}/events`);
  events.addEventListener("open", () => {
    now.live = "live";
    request("/platform").then((platform) => { now.platform = platform; changed(); }).catch(() => {});
    request("/words").then((words) => { now.words = words.words; changed(); }).catch(() => {});
    changed();
  });
  events.addEventListener("error", () => {
    now.live = "lost";
    changed();
    // It does not try again where it was refused: somebody has to sign in.
    if (events.readyState === EventSource.CLOSED) {
      shutOut();
    }
  });
  for (const [name, take] of Object.entries(TAKEN)) {
    events.addEventListener(name, (event) => {
      take(JSON.parse(event.data));
      changed();
    });
  }
  events.addEventListener("story", (event) => {
    const entry = JSON.parse(event.data);
    storyListeners.forEach((listener) => listener(entry));
  });
  return events;
}

/** Hears what happens; what is returned ends that. */
export function connect() {
  return whileSeen(hearAll, () => {
    now.live = "connecting";
    changed();
  });
}

/** What is known under a word, of these things in this order; that it is so stands above that it is not so elsewhere. */
export function known(word, ...things) {
  let denied = null;
  for (const fact of state.factsByWord.get(word)?.get(things[0])?.values() ?? []) {
    if (fact.arguments.length >= things.length && things.every((thing, i) => fact.arguments[i] === thing)) {
      if (fact.value !== false) {
        return fact;
      }
      denied ??= fact;
    }
  }
  return denied;
}

/** The same, or what was known last; that it is so still, nobody says. */
export function knownLast(word, thing) {
  return known(word, thing) ?? state.former.get(`${word} ${thing}`) ?? null;
}

export function isFormer(fact) {
  return !state.facts.has(fact.fact);
}
