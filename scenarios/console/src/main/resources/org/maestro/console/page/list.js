/** Long tables: filtered, sorted, a page at a time, and to be had as a file. */
import { heading, make, redraw } from "./dom.js";

const ROWS = 50;

function order(a, b) {
  return typeof a === "number" && typeof b === "number" ? a - b : String(a).localeCompare(String(b), "en", { numeric: true });
}

const FORMULA = /^\s*[=+\-@\uff1d\uff0b\uff0d\uff20]|^[\t\r\n]/;
const NUMBER = /^-?\d+(\.\d+)?(e-?\d+)?$/i;

/** A cell of a file for spreadsheets: what these would calculate stands after an apostrophe. */
export function quoted(value) {
  const text = String(value ?? "");
  const harmless = FORMULA.test(text) && !NUMBER.test(text) ? `'${text}` : text;
  return `"${harmless.replaceAll('"', '""')}"`;
}

function save(name, columns, rows) {
  const lines = [columns.map((column) => column.name), ...rows.map((row) => columns.map((column) => column.value?.(row) ?? column.text(row)))];
  const file = new Blob([lines.map((line) => line.map(quoted).join(",")).join("\r\n") + "\r\n"], { type: "text/csv" });
  const address = URL.createObjectURL(file);
  make("a", { href: address, download: `${name}.csv` }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

/** The body of a table. As most of its rows stay as they are, a cell is made anew only when it is to show something else. */
function rowsOf(columns, { isChosen = () => false, choose }) {
  const body = make("tbody");
  const places = [];
  const place = () => {
    const cells = columns.map((column) => make("td", { class: column.className }));
    const made = { row: null, shown: [], cells, element: make("tr", { onclick: () => choose?.(made.row) }, cells) };
    body.append(made.element);
    return made;
  };
  const drawRows = (rows) => {
    while (places.length > rows.length) {
      places.pop().element.remove();
    }
    rows.forEach((row, i) => {
      const at = places[i] ??= place();
      at.row = row;
      at.element.classList.toggle("chosen", isChosen(row));
      columns.forEach((column, c) => {
        const shown = (column.shown ?? column.text)(row);
        if (at.shown[c] !== shown) {
          at.shown[c] = shown;
          if (column.cell) {
            redraw(at.cells[c], column.cell(row));
          } else {
            at.cells[c].textContent = column.text(row);
          }
        }
      });
    });
  };
  return { body, drawRows };
}

/**
 * Returns what draws rows into the container. Of a column: its name, the text of a row, what it is sorted by when that is not the text,
 * the cell when it is more than text, and all that it shows when that is more than its text. Choosing works as for any table.
 */
export function longTable(container, name, columns, choosing = {}) {
  const asked = { filter: "", column: null, descending: false, page: 0 };
  let all = [];
  const filter = make("input", {
    type: "search", placeholder: "filter", "aria-label": `Filter ${name}`,
    oninput: () => { asked.filter = filter.value; asked.page = 0; show(); },
  });
  const where = make("span", { class: "quiet", role: "status" });
  const turn = (by, text, title) => make("button", { type: "button", title, onclick: () => { asked.page += by; show(); } }, text);
  const [back, on] = [turn(-1, "‹", "Earlier rows"), turn(1, "›", "Later rows")];
  const file = make("button", { type: "button", title: "All rows that are listed, as a file", onclick: () => save(name, columns, wanted()) }, "CSV");
  const tools = make("div", { class: "tools" }, filter, where, back, on, file);
  const rows = make("div", {});
  const sortedBy = (column) => (asked.column === column ? (asked.descending ? "descending" : "ascending") : null);
  const heads = columns.map((column) => ({
    ...column,
    get sorted() { return sortedBy(column); },
    get head() {
      const sign = { ascending: " ▲", descending: " ▼" }[sortedBy(column)] ?? "";
      return make("button", {
        class: "sort", type: "button", title: `Sort by ${column.name}`,
        onclick: () => {
          asked.descending = asked.column === column && !asked.descending;
          asked.column = column;
          show();
        },
      }, column.name + sign);
    },
  }));

  const { body, drawRows } = rowsOf(columns, choosing);
  const list = make("table", {}, body);
  const none = make("p", { class: "empty" });
  let headed = null;

  function drawHead() {
    const sorted = `${columns.indexOf(asked.column)} ${asked.descending}`;
    if (headed !== sorted) {
      headed = sorted;
      const had = list.contains(document.activeElement);
      list.tHead?.remove();
      list.prepend(heading(heads));
      if (had) {
        list.tHead.querySelectorAll("button")[columns.indexOf(asked.column)]?.focus();
      }
    }
  }

  function wanted() {
    const text = asked.filter.trim().toLowerCase();
    const found = text === "" ? [...all]
      : all.filter((row) => columns.some((column) => String(column.text(row)).toLowerCase().includes(text)));
    if (asked.column) {
      const key = asked.column.value ?? asked.column.text;
      found.sort((a, b) => (asked.descending ? -1 : 1) * order(key(a), key(b)));
    }
    return found;
  }

  function show() {
    const found = wanted();
    asked.page = Math.max(0, Math.min(asked.page, Math.ceil(found.length / ROWS) - 1));
    const first = asked.page * ROWS;
    const last = Math.min(found.length, first + ROWS);
    const told = found.length === 0 ? `none of ${all.length}` : `${first + 1}–${last} of ${found.length}`;
    if (where.textContent !== told) {
      where.textContent = told;
    }
    back.disabled = first === 0;
    on.disabled = last === found.length;
    if (found.length === 0) {
      none.textContent = `No row has "${asked.filter}" in it; change the filter.`;
    } else {
      drawHead();
      drawRows(found.slice(first, last));
    }
    const shown = found.length === 0 ? none : list;
    if (shown.parentElement !== rows) {
      rows.replaceChildren(shown);
    }
  }

  return (given) => {
    all = given;
    if (tools.parentElement !== container) {
      container.replaceChildren(tools, rows);
    }
    show();
  };
}
