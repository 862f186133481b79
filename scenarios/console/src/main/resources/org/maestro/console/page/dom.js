/** Elements, made of data alone: no text is ever read as markup. */
const SVG = "http://www.w3.org/2000/svg";

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) {
      element.addEventListener(name.slice(2), value);
    } else if (value !== null && value !== undefined && value !== false) {
      element.setAttribute(name, value === true ? "" : value);
    }
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

export function make(name, attributes = {}, ...children) {
  return fill(document.createElement(name), attributes, children);
}

export function draw(name, attributes = {}, ...children) {
  return fill(document.createElementNS(SVG, name), attributes, children);
}

export function byId(id) {
  return document.getElementById(id);
}

/** Draws a part anew; what had the focus in it has it afterwards, so that keys go on. */
export function redraw(container, ...children) {
  const path = [];
  for (let at = document.activeElement; at && at !== container; at = at.parentElement) {
    path.unshift(at.parentElement ? [...at.parentElement.children].indexOf(at) : -1);
    if (at === document.body) {
      path.length = 0;
    }
  }
  const had = container.contains(document.activeElement) && document.activeElement !== container;
  container.replaceChildren(...children.flat().filter(Boolean));
  if (had) {
    path.reduce((at, index) => at?.children[index], container)?.focus({ preventScroll: true });
  }
}

/**
 * One element for each name, made anew only when it is to show something else, so that a thousand of
 * them cost no more than those that change. Returns what draws: it takes the names in their order,
 * each with what it shows and how it is made, and if wished how one that is there becomes so.
 */
export function keyed(container) {
  let kept = new Map();
  return (wanted) => {
    const next = new Map();
    for (const [name, shows, made, become] of wanted) {
      const before = kept.get(name);
      if (before?.shows === shows) {
        next.set(name, before);
        continue;
      }
      const element = before && become ? become(before.element) : made();
      if (before && element !== before.element) {
        const had = before.element === document.activeElement;
        before.element.replaceWith(element);
        if (had) {
          element.focus({ preventScroll: true });
        }
      }
      next.set(name, { shows, element });
    }
    kept.forEach(({ element }, name) => { if (!next.has(name)) { element.remove(); } });
    let at = container.firstChild;
    for (const { element } of next.values()) {
      if (element === at) {
        at = at.nextSibling;
      } else {
        container.insertBefore(element, at);
      }
    }
    kept = next;
  };
}

export function heading(columns) {
  return make("thead", {}, make("tr", {}, columns.map((column) =>
    make("th", { scope: "col", class: column.className, "aria-sort": column.sorted }, column.head ?? column.name))));
}

/** A table for people; rows are chosen by a click, or by the key of their first cell. */
export function table(columns, rows, { isChosen = () => false, choose } = {}) {
  return make("table", {},
    heading(columns),
    make("tbody", {}, rows.map((row) => make("tr",
      { class: isChosen(row) ? "chosen" : null, onclick: () => choose?.(row) },
      columns.map((column) => make("td", { class: column.className }, (column.cell ?? column.text)(row)))))));
}

/** The choices of a list; what is chosen stays so, and nothing moves while it is open. */
export function choices(select, values) {
  const wanted = values.map(({ value, text }) => `${value} ${text}`).join("\n");
  if (select.dataset.choices !== wanted) {
    const chosen = select.value;
    select.replaceChildren(...values.map(({ value, text }) => make("option", { value }, text)));
    if (values.some((one) => one.value === chosen)) {
      select.value = chosen;
    }
    select.dataset.choices = wanted;
  }
}

/** Where there are many ages, tenths would have all of them drawn anew all the time. */
export function wholeSeconds(value) {
  return value >= 0 && value < 10 ? `${Math.floor(value)} s` : seconds(value);
}

export function seconds(value) {
  if (value === null || value === undefined) {
    return "–";
  }
  if (value < 60) {
    return `${value < 10 ? value.toFixed(1) : Math.round(value)} s`;
  }
  return value < 3600
    ? `${Math.floor(value / 60)} min ${Math.round(value % 60)} s`
    : `${Math.floor(value / 3600)} h ${Math.floor((value % 3600) / 60)} min`;
}
