
"use strict";
(() => {
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];

  // filter by finding
  const form = document.querySelector(".filter");
  const boxes = all("input", form);
  const told = form.querySelector("output");
  const cells = all("td");
  const apply = () => {
    const on = new Set(boxes.filter((box) => box.checked).map((box) => box.value));
    for (const cell of all("[data-v]")) cell.classList.toggle("off", !on.has(cell.dataset.v));
    for (const cell of cells) cell.classList.toggle("faint", !on.has(cell.className.split(" ")[0]));
    told.textContent = `${cells.filter((cell) => !cell.classList.contains("faint")).length} of ${cells.length} cells`;
  };
  form.addEventListener("change", apply);
  form.addEventListener("submit", (event) => event.preventDefault());
  form.hidden = false;
  apply();

  // who follows a link to a cell sees it
  const reveal = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const cell = target && target.closest("details");
    if (!cell) return;
    const box = boxes.find((box) => box.value === cell.dataset.v);
    box.checked = true;
    apply();
    cell.open = true;
    target.scrollIntoView();
  };
  addEventListener("hashchange", reveal);
  reveal();
})();
