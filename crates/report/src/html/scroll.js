"use strict";
// what is wider than its place scrolls; then, and only then, keys reach it
{
  const look = (entries) => {
    for (const { target } of entries) {
      const scrolls = target.scrollWidth > target.clientWidth;
      if (!scrolls) target.removeAttribute("tabindex");
      else target.tabIndex = 0;
      if (target.localName === "math") continue;
      target.role = scrolls ? "group" : null;
      target.ariaLabel = scrolls ? "Wider than the page: it scrolls" : null;
    }
  };
  const sizes = new ResizeObserver(look);
  const boxes = ".formula, .link, .shown, .findings math, .cell > div, .told pre, .words pre";
  for (const box of document.querySelectorAll(boxes)) sizes.observe(box);
}
