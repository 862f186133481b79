/** The plans of the goal that is looked at, or the steps of its script, and what was answered for them: read anew as its story goes on. */
import { ask, onChange, onStory, state } from "./feed.js";

/** What happens in one moment is read once. */
const GATHERED = 200;

let read = nothing(null);
let told = () => {};
let timer = null;

function nothing(goal) {
  return { goal, plans: null, script: [], now: 0, heard: 0, problem: null };
}

export function onPlans(listener) {
  told = listener;
}

async function readPlans() {
  const { goal } = read;
  let next;
  try {
    const { plans, script, now_s: now } = await ask.plans(goal);
    next = { goal, plans, script, now, heard: performance.now(), problem: null };
  } catch (failure) {
    next = { ...read, plans: read.plans ?? [], problem: failure.message };
  }
  if (read.goal === goal) {
    read = next;
    told();
  }
}

onStory((entry) => {
  if (entry.goal === read.goal && !timer) {
    timer = setTimeout(() => { timer = null; readPlans(); }, GATHERED);
  }
});

let wasLive = false;

/** What was told while nobody listened is made up for. */
onChange(() => {
  const isLive = state.live === "live";
  if (isLive && !wasLive && read.goal) {
    readPlans();
  }
  wasLive = isLive;
});

/** As far as they are read; no plans at all before. */
export function plansOf(goal) {
  if (read.goal !== goal) {
    read = nothing(goal);
    readPlans();
  }
  return read;
}

/** The platform's time, in its seconds. */
export function now() {
  return read.now + ((performance.now() - read.heard) / 1000) * (state.platform?.speed ?? 1);
}

/** Returns what asks once for what is looked at, and has no answer until it is there. */
function asking() {
  let last = { of: null, answer: null };
  return (of, question) => {
    if (last.of !== of) {
      last = { of, answer: null };
      question().catch((failure) => ({ problem: failure.message })).then((answer) => {
        if (last.of === of) {
          last = { of, answer };
          told();
        }
      });
    }
    return last.answer;
  };
}

const [askedBids, askedWhy] = [asking(), asking()];

/** What was answered when a plan was made. */
export function bidsOf(goal, plan) {
  return askedBids(`${goal} ${plan.number} ${plan.made_s}`, () => ask.bids(goal, plan.number));
}

/** Why a step was given to its member and to no other. */
export function whyOf(goal, plan, step) {
  return askedWhy(`${goal} ${plan.number} ${step.number}`, () => ask.why(goal, plan.number, step.number));
}

export const STATES = {
  waiting: ["…", "wait", "waiting"],
  "under-way": ["▶", "going", "under way"],
  done: ["✓", "good", "done"],
  failed: ["✗", "bad", "failed"],
  "called-off": ["–", "off", "called off"],
  dropped: ["–", "off", "dropped"],
};

const tenth = (seconds) => `${seconds.toFixed(1)} s`;

/** Where a step stands, in words. */
export function standing(step, time) {
  const [, , word] = STATES[step.state];
  if (step.state === "under-way") {
    const since = Math.max(0, time - step.begun_s);
    return `${word}, ${since.toFixed(1)} of ${tenth(step.duration_s)}`;
  }
  if (step.begun_s !== null && step.ended_s !== null) {
    return `${word} after ${tenth(step.ended_s - step.begun_s)}`;
  }
  return step.state === "waiting" ? `${word}, takes ${tenth(step.duration_s)}` : word;
}

/** How much of the time that it was planned to take is over, 0 to 1. */
export function fraction(step, time) {
  return step.duration_s > 0 ? Math.max(0, Math.min(1, (time - step.begun_s) / step.duration_s)) : 0;
}

/** Who acts, and the agent where that has another name. */
export function doer(member) {
  const agent = state.agentByMember.get(member)?.agent;
  return agent && agent !== member ? `${member} (agent ${agent})` : member;
}
