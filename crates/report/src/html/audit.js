
"use strict";
(() => {
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];

  // filter by verdict and by origin
  const form = document.querySelector(".filter");
  const boxes = all("input", form);
  const chosen = (name) => new Set(boxes.filter((box) => box.name === name && box.checked).map((box) => box.value));
  const statements = all("article[data-v]");
  const told = form.querySelector("output");
  // headings, each with what stands under it, for a heading over nothing is hidden
  const parts = all("main > :is(h2, h3, h4, h5), main [data-v]").filter((part) => !part.parentElement.closest("[data-v]"));
  const isHeading = (part) => part.dataset.v === undefined;
  const under = parts.map((heading, at) => {
    const rest = isHeading(heading) ? parts.slice(at + 1) : [];
    const end = rest.findIndex((part) => isHeading(part) && part.tagName <= heading.tagName);
    return rest.slice(0, end < 0 ? rest.length : end).filter((part) => !isHeading(part));
  });
  const apply = () => {
    const [on, from] = [chosen("v"), chosen("o")];
    for (const part of all("[data-v]")) {
      const { v, o } = part.dataset;
      part.classList.toggle("off", !on.has(v) || (o !== undefined && !from.has(o)));
    }
    under.forEach((below, at) => {
      const isOff = (part) => part.classList.contains("off");
      if (below.length > 0) parts[at].classList.toggle("off", below.every(isOff));
    });
    const seen = statements.filter((s) => !s.classList.contains("off"));
    told.textContent = `${seen.length} of ${statements.length} statements`;
    const names = new Set(seen.map((s) => "#" + s.id));
    for (const node of all("a.n")) node.classList.toggle("faint", !names.has(node.getAttribute("href")));
  };
  form.addEventListener("change", apply);
  form.addEventListener("submit", (event) => event.preventDefault());
  form.hidden = false;
  apply();

  // who follows a link to a statement sees it
  const reveal = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const off = target ? boxes.filter((box) => box.value === target.dataset[box.name] && !box.checked) : [];
    if (off.length === 0) return;
    for (const box of off) box.checked = true;
    apply();
    target.scrollIntoView();
  };
  addEventListener("hashchange", reveal);
  reveal();

  const button = form.querySelector("button");
  const proofs = all("article details:not(.more)");
  button.addEventListener("click", () => {
    const open = proofs.some((proof) => !proof.open);
    for (const proof of proofs) proof.open = open;
    button.textContent = open ? "Close all proofs" : "Open all proofs";
  });

  // what a node of the graph rests on, and what rests on it
  const picture = document.querySelector(".scroll svg");
  picture.classList.add("live");
  const zoom = document.querySelector(".zoom");
  const [natural, tall] = [picture.width.baseVal.value, picture.height.baseVal.value];
  let scale = 1;
  zoom.hidden = false;
  zoom.addEventListener("click", (event) => {
    const by = event.target.dataset.zoom;
    if (by === undefined) return;
    const box = picture.parentElement;
    scale = Number(by) ? scale * Number(by) : Math.min(box.clientWidth / natural, 1);
    picture.setAttribute("width", Math.round(natural * scale));
    picture.setAttribute("height", Math.round(tall * scale));
  });
  const nodes = all("a.n", picture);
  const edges = all("path.e", picture).map((line) => {
    const [from, to] = line.dataset.e.split(" ").map(Number);
    return { line, from, to };
  });
  const reach = (start, here, there) => {
    const found = new Set([start]);
    for (const node of found) for (const edge of edges) if (edge[here] === node) found.add(edge[there]);
    return found;
  };
  const pick = (node) => {
    const start = nodes.indexOf(node);
    const up = reach(start, "to", "from");
    const down = reach(start, "from", "to");
    picture.classList.add("picked");
    nodes.forEach((other, i) => other.classList.toggle("on", up.has(i) || down.has(i)));
    for (const { line, from, to } of edges) {
      line.classList.toggle("up", up.has(from) && up.has(to));
      line.classList.toggle("down", down.has(from) && down.has(to));
    }
  };
  for (const node of nodes) {
    node.addEventListener("pointerenter", () => pick(node));
    node.addEventListener("focus", () => pick(node));
    for (const end of ["pointerleave", "blur"])
      node.addEventListener(end, () => picture.classList.remove("picked"));
  }
})();
