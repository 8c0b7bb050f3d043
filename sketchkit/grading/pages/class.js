// Order and filter of a class, see class.html.j2. Cards and rows of the table move together.
"use strict";

(() => {
  const ordering = document.querySelector("#ordering");
  const direction = document.querySelector("#direction");
  const filter = document.querySelector("#filter");
  const said = document.querySelector("#said");
  const headings = [...document.querySelectorAll("th[data-key]")];
  const rows = [...document.querySelectorAll("tbody tr")];
  const cards = [...document.querySelectorAll(".cards > li")];
  const collator = new Intl.Collator(undefined, { numeric: true, sensitivity: "base" });
  let isReversed = false;

  // Rows are in the order of what stands out when the page is opened.
  function compare(a, b, column, kind) {
    if (column < 0) return a - b;
    const [left, right] = [a, b].map((row) => rows[row].children[column].dataset.value);
    const order = kind === "number" ? Number(left) - Number(right) : collator.compare(left, right);
    return order || a - b;
  }

  function sort() {
    const column = headings.findIndex((heading) => heading.dataset.key === ordering.value);
    const kind = column < 0 ? "" : headings[column].dataset.kind;
    const sign = isReversed ? -1 : 1;
    const order = rows.map((_, row) => row).sort((a, b) => sign * compare(a, b, column, kind));
    for (const parts of [rows, cards]) parts[0]?.parentElement.append(...order.map((row) => parts[row]));
    headings.forEach((heading, at) => {
      if (at === column) heading.setAttribute("aria-sort", isReversed ? "descending" : "ascending");
      else heading.removeAttribute("aria-sort");
    });
    direction.setAttribute("aria-pressed", String(isReversed));
  }

  function choose(key) {
    isReversed = ordering.value === key && !isReversed;
    ordering.value = key;
    sort();
  }

  function sift() {
    const words = filter.value.toLocaleLowerCase().split(/\s+/).filter(Boolean);
    let left = 0;
    rows.forEach((row, at) => {
      const text = `${row.textContent} ${cards[at].textContent}`.toLocaleLowerCase();
      const isShown = words.every((word) => text.includes(word));
      row.hidden = cards[at].hidden = !isShown;
      left += Number(isShown);
    });
    said.textContent = words.length ? `${left} of ${rows.length}` : "";
  }

  for (const heading of headings) {
    const button = heading.querySelector("button");
    button.disabled = false;
    button.addEventListener("click", () => choose(heading.dataset.key));
  }
  ordering.addEventListener("change", () => {
    isReversed = false;
    sort();
  });
  direction.addEventListener("click", () => {
    isReversed = !isReversed;
    sort();
  });
  filter.addEventListener("input", sift);
  for (const tool of document.querySelectorAll(".tools [hidden]")) tool.hidden = false;
  // What a browser has kept of the form when it comes back to the page.
  sort();
  sift();
})();
