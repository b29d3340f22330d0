"use strict";
(() => {
const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);

// An element with attributes, listeners (functions) and children.
function make(name, attributes = {}, ...children) {
  const svg = ["svg", "line", "text", "circle", "rect", "g", "title"].includes(name);
  const node = svg ? document.createElementNS("http://www.w3.org/2000/svg", name)
                   : document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (typeof value === "function") node.addEventListener(key, value);
    else if (value !== false && value !== undefined) node.setAttribute(key, value === true ? "" : value);
  node.append(...children.filter((child) => child !== undefined && child !== ""));
  return node;
}

const text = (value) => value === null || value === undefined ? ""
  : typeof value === "number" ? String(Number(value.toPrecision(3))) : value;
const plain = (word) => word.replaceAll("_", " ");
const unitOf = (criterion) => criterion.unit ? ", " + criterion.unit : "";
const title = (row) => Object.entries(row.values).filter(([, value]) => value !== "")
  .map(([key, value]) => plain(key) + " " + value).join(", ");
const ending = (row) => row.ending === "solved"
  ? plain(row.status) + (row.in_range === false ? ", out of the model's range"
    : row.mark === "judge" ? ", with warnings" : "")
  : row.ending === "not_built" ? "cannot be built" : plain(row.ending);
const drawn = data.rows.filter((row) => row.option in data.pictures);
const compared = new Set(drawn.slice(0, 4).map((row) => row.option));
let here = "";  // the option that was chosen in the scatter or the table

// One column: heading, value to sort by, cell.
const columns = [
  {head: "Rank", value: (row) => row.rank || null},
  {head: "State", words: true, value: ending},
  ...data.keys.map((key) => ({head: plain(key), value: (row) => {
    const value = row.values[key];
    return value === undefined || value === "" || isNaN(value) ? value : Number(value);
  }})),
  {head: "Score", value: (row) => row.score},
  ...data.criteria.map((criterion) => ({
    head: criterion.title + unitOf(criterion), value: (row) => row.criteria[criterion.name],
    past: (row) => row.past.includes(criterion.name)})),
  {head: "Fidelity", words: true, value: (row) => row.fidelity},
  {head: "Result", words: true, value: (row) => row.folder, cell: (row) => row.link
    ? make("a", {href: row.link, "aria-label": "Result of option " + row.rank}, "open") : ""},
  {head: "What to check", words: true, reason: true, value: (row) => row.sentences.join(" "),
   cell: (row) => row.sentences.length ? make("details", {}, make("summary", {},
     row.ending === "solved" ? row.sentences.length + (row.sentences.length > 1 ? " warnings" : " warning")
                             : "Why"), row.sentences.join(" ")) : ""},
];
let order = {column: 0, down: false};
const most = 200;
let shown = most;

function sorted() {
  const {value} = columns[order.column];
  const missing = (one) => one === null || one === undefined || one === "";
  return [...data.rows].sort((a, b) => {
    const [x, y] = [value(a), value(b)];
    if (missing(x) || missing(y)) return missing(x) - missing(y);  // at the end, whatever the order
    const sign = typeof x === "number" && typeof y === "number" ? x - y
      : String(x).localeCompare(String(y));
    return order.down ? -sign : sign;
  });
}

function sortBy(k) {
  order = {column: k, down: order.column === k && !order.down};
  showTable();
  byId("sort-" + k).focus();
}

function rowOf(row) {
  const tick = row.option in data.pictures ? make("input", {
    type: "checkbox", "aria-label": "Show the picture of option " + row.rank + ", " + title(row),
    ...(compared.has(row.option) ? {checked: true} : {}),
    change: (event) => {
      if (event.target.checked) compared.add(row.option); else compared.delete(row.option);
      showPictures();
    }}) : "";
  const cells = columns.map((column) => make("td", {
    class: [column.words ? "words" : "", column.reason ? "reason" : "",
            column.past && column.past(row) ? "past" : ""].join(" ").trim() || undefined},
    column.cell ? column.cell(row) : text(column.value(row))));
  const line = make("tr", {class: "is-" + row.mark + (row.option === here ? " here" : ""), id: "row-" + row.option},
    make("td", {}, tick), cells[1], cells[0], ...cells.slice(2));
  return line;
}

function showTable() {
  const heads = columns.map((column, k) => make("th", {
    scope: "col", class: column.words ? "words" : undefined,
    "aria-sort": order.column === k ? (order.down ? "descending" : "ascending") : undefined},
    make("button", {type: "button", id: "sort-" + k, click: () => sortBy(k)}, column.head)));
  const rows = sorted();
  const table = byId("options");
  table.replaceChildren(
    make("thead", {}, make("tr", {}, make("th", {scope: "col"}, "Picture"), heads[1], heads[0],
                           ...heads.slice(2))),
    make("tbody", {}, ...rows.slice(0, shown).map(rowOf)));
  byId("more")?.remove();
  if (rows.length > shown)
    table.parentElement.after(make("p", {id: "more"}, make("button", {type: "button", click: () => {
      shown = rows.length;
      showTable();
    }}, "Show all " + rows.length + " options")));
}

// A choice with its label; `changed` gets the chosen value.
function choice(label, values, chosen, changed) {
  const select = make("select", {change: (event) => changed(event.target.value)},
    ...values.map((one) => make("option", {value: one.name, ...(one.name === chosen ? {selected: true} : {})},
                                one.title)));
  return make("label", {}, label, select);
}

let colour = "vessel";
function showPictures() {
  byId("pictures").replaceChildren(...drawn.filter((row) => compared.has(row.option)).map((row) => {
    const caption = "Option " + row.rank + ": " + title(row);
    return make("figure", {}, make("img", {
      width: 480, height: 400, alt: caption + ", " + colour,
      src: "data:image/png;base64," + data.pictures[row.option][colour]}),
      make("figcaption", {}, make("strong", {}, "Option " + row.rank), " " + title(row) + ". " +
        ending(row) + ", score " + text(row.score)));
  }));
}

const axes = [
  {name: "score", title: "Score", of: (row) => row.score},
  ...data.criteria.map((one) => ({name: one.name, title: one.title + unitOf(one), criterion: one,
                                  of: (row) => row.criteria[one.name]})),
  ...data.keys.filter((key) => data.rows.some((row) => row.values[key] !== "" && !isNaN(row.values[key])))
    .map((key) => ({name: "value " + key, title: plain(key),
                    of: (row) => row.values[key] === "" || isNaN(row.values[key]) ? null : Number(row.values[key])})),
];
const axisOf = (name) => axes.find((axis) => axis.name === name);
const has = (axis) => new Set(data.rows.map(axis.of).filter((one) => typeof one === "number")).size;
const first = axes.filter((axis) => axis.criterion && has(axis) > 1);
let across = (first[0] ?? axes[0]).name, upwards = (first.find((one) => one.name === "mouth") ??
  first.find((one) => one.name === "stretch") ?? first[1] ?? axes[0]).name;
if (across === upwards && first.length > 1) across = first.find((one) => one.name !== upwards).name;

// Round values with as many decimals as tell them apart.
function ticks(low, high) {
  const raw = (high - low) / 5, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((one) => one * power).find((one) => one >= raw);
  const marks = [], decimals = Math.min(20, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
  for (let k = Math.ceil(low / step); k * step <= high * (1 + 1e-9); ++k)
    marks.push({at: k * step, label: (k * step).toFixed(decimals)});
  return marks;
}

function choose(row) {
  here = row.option;
  byId("chosen").textContent = "Option " + row.rank + ": " + title(row) + "; " + ending(row) +
    " (" + row.fidelity + "), score " + text(row.score) + (row.past.length
      ? "; past the threshold of " + row.past.map(plain).join(", ") : "") + ".";
  for (const node of document.querySelectorAll(".here")) node.classList.remove("here");
  for (const node of [byId("row-" + here), byId("point-" + here)]) node?.classList.add("here");
}

function showScatter() {
  const [x, y] = [axisOf(across), axisOf(upwards)];
  const points = data.rows.filter((row) => [x, y].every((axis) => typeof axis.of(row) === "number"));
  const box = byId("scatter");
  if (points.length === 0) {
    box.replaceChildren(make("p", {class: "soft"}, "No option has both."));
    return;
  }
  const [width, height, left, bottom, top, right] = [900, 420, 70, 50, 16, 16];
  const range = (axis) => {
    const values = points.map(axis.of);
    let [low, high] = [Math.min(...values), Math.max(...values)];
    const threshold = axis.criterion && !axis.criterion.distance ? axis.criterion.threshold : null;
    const room = high - low || Math.abs(high) || 1;
    if (threshold !== null && threshold > low - room && threshold < high + room)
      [low, high] = [Math.min(low, threshold), Math.max(high, threshold)];
    const margin = 0.05 * (high - low || Math.abs(high) || 1);
    return {low: low - margin, high: high + margin, threshold};
  };
  const [rx, ry] = [range(x), range(y)];
  const px = (value) => left + (value - rx.low) / (rx.high - rx.low) * (width - left - right);
  const py = (value) => height - bottom - (value - ry.low) / (ry.high - ry.low) * (height - bottom - top);
  const parts = [];
  for (const mark of ticks(rx.low, rx.high))
    parts.push(make("line", {x1: px(mark.at), x2: px(mark.at), y1: top, y2: height - bottom}),
               make("text", {x: px(mark.at), y: height - bottom + 18, "text-anchor": "middle"}, mark.label));
  for (const mark of ticks(ry.low, ry.high))
    parts.push(make("line", {y1: py(mark.at), y2: py(mark.at), x1: left, x2: width - right}),
               make("text", {x: left - 8, y: py(mark.at) + 4, "text-anchor": "end"}, mark.label));
  for (const [range_, at] of [[rx, px], [ry, py]]) {
    const value = range_.threshold;
    if (value === null || value < range_.low || value > range_.high) continue;
    const place = at(value);
    parts.push(at === px ? make("line", {class: "threshold", x1: place, x2: place, y1: top, y2: height - bottom})
                         : make("line", {class: "threshold", y1: place, y2: place, x1: left, x2: width - right}));
  }
  parts.push(make("text", {x: (left + width - right) / 2, y: height - 8, "text-anchor": "middle"}, x.title),
             make("text", {x: 14, y: (top + height - bottom) / 2, "text-anchor": "middle",
                           transform: `rotate(-90 14 ${(top + height - bottom) / 2})`}, y.title));
  // Ranks read in order; the best is drawn last.
  const dots = points.map((row) => {
    const label = "Option " + row.rank + ", " + title(row) + ": " + x.title + " " + text(x.of(row)) +
      ", " + y.title + " " + text(y.of(row)) + ", " + ending(row);
    const pick = (event) => {
      if (event.type === "keydown" && event.key !== "Enter" && event.key !== " ") return;
      if (event.type === "keydown") event.preventDefault();
      choose(row);
    };
    return make("circle", {class: "point " + row.mark + (row.option === here ? " here" : ""),
      id: "point-" + row.option, cx: px(x.of(row)), cy: py(y.of(row)), r: 6, tabindex: 0, role: "button",
      "aria-label": label, click: pick, keydown: pick}, make("title", {}, label));
  });
  box.replaceChildren(make("svg", {viewBox: `0 0 ${width} ${height}`, role: "group",
    "aria-label": "Scatter of " + y.title + " over " + x.title}, ...parts, ...dots));
}

byId("criteria").replaceChildren(
  make("thead", {}, make("tr", {}, ...["Criterion", "Weight", "Threshold", "Source of the threshold"]
    .map((head, k) => make("th", {scope: "col", class: k % 3 === 0 ? "words" : undefined}, head)))),
  make("tbody", {}, ...data.criteria.map((one) => make("tr", {},
    make("td", {class: "words"}, one.title), make("td", {}, text(one.weight)),
    make("td", {}, (one.distance ? "1 \u00b1 " : "") + text(one.threshold) + (one.unit ? " " + one.unit : "")),
    make("td", {class: "words"}, one.source)))));
showTable();
if (drawn.length) {
  byId("picture-controls").append(choice("Coloured by", data.colours, colour, (value) => {
    colour = value;
    showPictures();
  }));
  showPictures();
} else {
  byId("pictures-part").remove();
}
byId("scatter-controls").append(
  choice("Across", axes, across, (value) => { across = value; showScatter(); }),
  choice("Upwards", axes, upwards, (value) => { upwards = value; showScatter(); }));
showScatter();
})();
