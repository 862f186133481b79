/** Who looks at the page: on a secured site somebody who has signed in, who may what her role says. */
import { byId } from "./dom.js";
import { ask, authorize } from "./feed.js";

const ROLES = ["viewer", "operator", "administrator"];
const MANY = { viewer: "a viewer", operator: "an operator", administrator: "an administrator" };

let who = { secured: false, person: null, role: null, csrf: null };
let enter = () => {};

/** Why who looks may not do what takes this role; null when she may. */
export function mayNot(role) {
  if (who.role === null) {
    return "Sign in first.";
  }
  return ROLES.indexOf(who.role) >= ROLES.indexOf(role) ? null : `It takes ${MANY[role]}; ${who.person} is ${MANY[who.role]} here.`;
}

function draw() {
  const isOut = who.secured && who.person === null;
  document.body.classList.toggle("out", isOut);
  byId("sign-in").hidden = !isOut;
  document.querySelector("main").hidden = isOut;
  byId("person").hidden = !who.secured || isOut;
  byId("person-name").textContent = who.person === null ? "" : `${who.person}, ${who.role}`;
  if (isOut && !byId("sign-in").contains(document.activeElement)) {
    byId("sign-in-name").focus();
  }
}

function take(told) {
  const wasIn = who.role !== null;
  who = told;
  authorize(told.csrf);
  draw();
  if (who.role !== null && !wasIn) {
    enter();
  }
}

/** Asks who looks, as a session may have ended or begun in another page; returns whether she is still the same. */
export async function recognize() {
  const before = who.person;
  take(await ask.session());
  return before !== null && who.person === before;
}

async function signIn(event) {
  event.preventDefault();
  const problem = byId("sign-in-problem");
  problem.textContent = "";
  try {
    take(await ask.signIn(byId("sign-in-name").value.trim(), byId("sign-in-password").value));
    byId("sign-in-password").value = "";
  } catch (failure) {
    problem.textContent = failure.message;
  }
}

/** What was shown was told to somebody else: the page begins anew. */
async function signOut() {
  await ask.signOut();
  location.reload();
}

/** Begins; as soon as somebody is let in, that is told. */
export function startSession(entered) {
  enter = entered;
  byId("sign-in-form").addEventListener("submit", signIn);
  byId("sign-out").addEventListener("click", () => signOut().catch(() => location.reload()));
  const again = () => recognize().catch(() => setTimeout(again, 2000));
  again();
}
