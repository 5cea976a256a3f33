"use strict";

// A cell's value to sort by: its number, else its text. Empty cells are last
// whichever way.
function value(row, column) {
    const cell = row.cells[column];
    const text = cell.dataset.value ?? cell.textContent;
    if (text === "") {
        return null;
    }
    return isNaN(text) ? text : Number(text);
}

function compare(a, b) {
    if (typeof a === "number" && typeof b === "number") {
        return a - b;
    }
    return String(a).localeCompare(String(b), "en", { numeric: true });
}

function sortBy(table, header) {
    const column = header.cellIndex;
    const up = header.getAttribute("aria-sort") !== "ascending";
    for (const other of table.tHead.rows[0].cells) {
        other.removeAttribute("aria-sort");
    }
    header.setAttribute("aria-sort", up ? "ascending" : "descending");
    const body = table.tBodies[0];
    const rows = Array.from(body.rows, (row) => {
        return { row, key: value(row, column) };
    });
    rows.sort((a, b) => {
        if (a.key === null || b.key === null) {
            return (a.key === null) - (b.key === null);
        }
        return up ? compare(a.key, b.key) : compare(b.key, a.key);
    });
    body.append(...rows.map(({ row }) => row));
}

function filter(table) {
    const scene = document.getElementById("scene").value;
    const technique = document.getElementById("technique").value.toLowerCase();
    let shown = 0;
    for (const row of table.tBodies[0].rows) {
        const name = row.cells[1].textContent.toLowerCase();
        row.hidden = (scene !== "" && row.cells[0].textContent !== scene)
            || !name.includes(technique);
        shown += row.hidden ? 0 : 1;
    }
    document.getElementById("shown").textContent = `${shown} points`;
}

const points = document.getElementById("points");
for (const header of points.tHead.rows[0].cells) {
    const button = header.querySelector("button");
    button.addEventListener("click", () => sortBy(points, header));
}
for (const id of ["scene", "technique"]) {
    document.getElementById(id).addEventListener("input", () => filter(points));
}
document.querySelector(".filters").addEventListener("submit", (event) => {
    event.preventDefault();
});
filter(points);

for (const slider of document.querySelectorAll(".card input")) {
    const pair = slider.closest(".card").querySelector(".compare");
    const cut = () => pair.style.setProperty("--cut", `${slider.value}%`);
    slider.addEventListener("input", cut);
    cut();
}
