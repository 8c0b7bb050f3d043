// The controls of every comparison on the page, see comparison.html.j2.
"use strict";

(() => {
  const TURN_MS = 600; // less than two changes a second: three are too many for some people

  function prepare(figure) {
    const controls = figure.querySelector(".controls");
    const panes = figure.querySelector(".panes");
    const layered = figure.querySelector(".layered");
    const zoom = figure.querySelector(".zoom");
    const views = [...figure.querySelectorAll("[data-view]")];
    let view = "side";
    let timer = 0;

    const pictures = () => [...figure.querySelectorAll("img")].filter((picture) => picture.naturalWidth);

    // All pictures of a comparison get one scale, so that those of different sizes look it.
    function resize() {
      const rooms = [...figure.querySelectorAll(".window")].map((window) => window.parentElement.clientWidth);
      const room = Math.min(...rooms.filter((width) => width > 0)); // 0: hidden
      if (!Number.isFinite(room)) return; // the comparison itself is hidden, in a closed <details>
      const widest = Math.max(...pictures().map((picture) => picture.naturalWidth), 1);
      const scale = zoom.value === "fit" ? fitting(room / widest) : Number(zoom.value);
      for (const picture of pictures()) {
        picture.style.width = `${picture.naturalWidth * scale}px`;
        picture.style.height = `${picture.naturalHeight * scale}px`;
      }
      if (layered) figure.querySelector(".split").style.width = `${Math.min(widest * scale, room)}px`;
    }

    function choose(chosen) {
      view = chosen;
      for (const button of views) button.setAttribute("aria-pressed", String(button.dataset.view === view));
      panes.hidden = view !== "side";
      if (layered) {
        layered.hidden = view === "side";
        for (const part of layered.querySelectorAll("[data-control]")) part.hidden = part.dataset.control !== view;
        show(view === "flicker" ? "submitted" : "");
        pause(view !== "flicker" || matchMedia("(prefers-reduced-motion: reduce)").matches);
      }
      resize();
    }

    function show(which) {
      layered.dataset.showing = which;
      layered.querySelector(".showing").textContent = which === "expected" ? "expected" : "drawn";
    }

    const swap = () => show(layered.dataset.showing === "expected" ? "submitted" : "expected");

    function pause(isPaused) {
      clearInterval(timer);
      timer = isPaused ? 0 : setInterval(swap, TURN_MS);
      layered.querySelector(".pause").setAttribute("aria-pressed", String(isPaused));
    }

    for (const button of views) button.addEventListener("click", () => choose(button.dataset.view));
    zoom.addEventListener("change", resize);
    scrollTogether([...panes.querySelectorAll(".window")]);
    if (layered) {
      // The script copies the addresses: a picture may be in its address, and then counts twice.
      for (const copy of layered.querySelectorAll("img")) {
        copy.src = panes.querySelector(`img[alt="${copy.alt}"]`).src;
      }
      const split = layered.querySelector(".split");
      const stack = layered.querySelector(".stack");
      const follow = () => stack.style.setProperty("--split", `${split.value}%`);
      split.addEventListener("input", follow);
      layered.querySelector(".pause").addEventListener("click", () => pause(timer !== 0));
      layered.querySelector(".swap").addEventListener("click", () => {
        pause(true);
        swap();
      });
      follow();
    }
    for (const picture of figure.querySelectorAll("img")) picture.addEventListener("load", resize);
    new ResizeObserver(resize).observe(controls.parentElement);
    controls.hidden = false;
    figure.dataset.ready = "";
    choose("side");
  }

  // Small pictures grow by whole numbers, so that all of their pixels are of one size.
  function fitting(scale) {
    return scale >= 1 ? Math.min(Math.floor(scale), 2) : scale;
  }

  function scrollTogether(windows) {
    for (const source of windows) {
      source.addEventListener("scroll", () => {
        for (const other of windows) {
          if (other === source) continue;
          if (other.scrollLeft !== source.scrollLeft) other.scrollLeft = source.scrollLeft;
          if (other.scrollTop !== source.scrollTop) other.scrollTop = source.scrollTop;
        }
      });
    }
  }

  for (const figure of document.querySelectorAll(".comparison")) prepare(figure);
})();
