/** A member in full: what it is at, what waits, and a form for each of its features. */
import { make, redraw } from "./dom.js";
import { ask, state } from "./feed.js";
import { acting } from "./past.js";

const OFTEN_MILLIS = 1000;
const NUMBERS = new Set(["decimal", "double", "float", "integer", "int", "long", "short", "nonNegativeInteger", "positiveInteger"]);

let shown = { name: null, told: null, problem: null };
let asked = 0;
let isAsking = false;

async function inquire(name) {
  isAsking = true;
  asked = performance.now();
  try {
    const told = await ask.member(name);
    if (shown.name === name) {
      shown = { name, told, problem: null };
    }
  } catch (failure) {
    if (shown.name === name) {
      shown = { name, told: null, problem: failure.message };
    }
  }
  isAsking = false;
}

/** What it is at, in a line; empty before it was told. */
export function memberLine() {
  const { told, problem } = shown;
  if (problem) {
    return make("p", { class: "problem" }, problem);
  }
  if (told === null) {
    return null;
  }
  const calls = (ids) => (ids.length === 0 ? "nothing" : ids.join(", "));
  const { name } = shown;
  const stop = (event) => {
    const button = event.currentTarget;
    ask.stopMember(name).then(() => { button.textContent = "Told to be safe"; }, (failure) => { shown.problem = failure.message; });
  };
  return make("p", { class: "at" },
    make("button", { type: "button", class: "danger", ...acting(), title: acting().title ?? `${name} into a safe state, now`, onclick: stop }, "Safe state"), " At: ", make("code", {}, calls(told.running)), " · waiting: ", make("code", {}, calls(told.queue)),
    " · answers calls in ", told.round_trip_ms === null ? "– (not called yet)" : `${told.round_trip_ms.toFixed(1)} ms`);
}

/** The things of a class, by name. */
function thingsOf(types) {
  return state.home.things.filter((thing) => types.some((type) => thing.classes.includes(type))).map((thing) => thing.name).sort();
}

function options(values, isOptional) {
  return [isOptional ? make("option", { value: "" }, "–") : null, ...values.map((value) => make("option", { value: JSON.stringify(value) }, String(value)))];
}

/** A field for a parameter, and what reads it: undefined where it is left away. */
function field(parameter, id) {
  const { types, one_of: choices, optional } = parameter;
  const things = thingsOf(types);
  if (choices.length > 0 || types.includes("boolean") || things.length > 0) {
    const values = choices.length > 0 ? choices : types.includes("boolean") ? [true, false] : things;
    const select = make("select", { id }, options(values, optional));
    return [select, () => (select.value === "" ? undefined : JSON.parse(select.value))];
  }
  const isNumber = types.length > 0 && types.every((type) => NUMBERS.has(type));
  const isPose = types.includes("Pose");
  const input = make("input", {
    id, type: isNumber ? "number" : "text", step: isNumber ? "any" : null, required: !optional, spellcheck: "false",
    placeholder: isPose ? "x y z, in metres" : null,
  });
  return [input, () => {
    const text = input.value.trim();
    if (text === "") {
      return undefined;
    }
    if (isPose) {
      return text.split(/[\s,]+/).map(Number);
    }
    return isNumber ? Number(text) : text;
  }];
}

async function call(member, feature, parameters, told) {
  told.className = "";
  told.textContent = "…";
  try {
    let made = await ask.call(member, feature, parameters);
    const { id } = made;
    while (made.state === "under-way") {
      if (told.dataset.call !== id) {
        told.dataset.call = id;
        told.replaceChildren(`${id} is under way … `, make("button", { type: "button", ...acting(), onclick: () => ask.endCall(id).catch(() => {}) }, "End it"));
      }
      await new Promise((resolve) => { setTimeout(resolve, OFTEN_MILLIS / 2); });
      if (!told.isConnected) {
        return;
      }
      made = await ask.made(made.id);
    }
    told.className = made.state === "done" ? "" : "problem";
    told.textContent = made.state === "done" ? `✓ ${made.id}: ${made.outcome}` : `${made.id}: ${made.outcome}`;
  } catch (failure) {
    told.className = "problem";
    told.textContent = failure.message;
  }
}

function form(member, feature, number) {
  const fields = feature.parameters.map((parameter) => [parameter, ...field(parameter, `call-${number}-${parameter.name}`)]);
  const told = make("p", { role: "status" });
  const why = feature.why_not;
  const submit = (event) => {
    event.preventDefault();
    const parameters = {};
    fields.forEach(([parameter, , read]) => {
      const value = read();
      if (value !== undefined) {
        parameters[parameter.name] = value;
      }
    });
    call(member, feature.feature, parameters, told);
  };
  const name = make("h3", { class: why ? "quiet" : null }, feature.feature,
    feature.continuous ? make("small", { class: "quiet" }, " goes on until its time is over") : null);
  return make("form", { class: `feature${why ? " off" : ""}`, "data-feature": feature.feature, autocomplete: "off", onsubmit: submit },
    name,
    make("div", { class: "more" },
      fields.map(([parameter, input]) => [
        make("label", { for: input.id }, `${parameter.name}${parameter.optional ? " (or not)" : ""}`), input]).flat(),
      make("button", { type: "submit", ...(why ? { disabled: true, title: why } : acting()) }, "Call")),
    why ? make("p", { class: "quiet why" }, why) : null,
    told);
}

/**
 * Draws the forms into a part of their own, and again only when the member can do something else:
 * what somebody has typed stays.
 */
export function drawMember(container, name) {
  if (shown.name !== name) {
    shown = { name, told: null, problem: null };
    asked = 0;
  }
  if (!isAsking && performance.now() - asked > OFTEN_MILLIS) {
    inquire(name);
  }
  const shows = JSON.stringify([name, shown.told?.features ?? null, acting().disabled]);
  if (container.dataset.features !== shows) {
    container.dataset.features = shows;
    const features = shown.told?.features ?? [];
    redraw(container, features.map((feature, number) => form(name, feature, number)));
  }
}
