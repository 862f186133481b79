/** Copies of what is shown, to be put in elsewhere. */
import { make } from "./dom.js";

const TOLD_MILLIS = 2000;

export function copyButton(name, text) {
  const button = make("button", { type: "button", class: "copy", onclick: async () => {
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = "Copied";
    } catch {
      button.textContent = "The browser lets nothing be copied";
    }
    setTimeout(() => { button.textContent = name; }, TOLD_MILLIS);
  } }, name);
  return button;
}
