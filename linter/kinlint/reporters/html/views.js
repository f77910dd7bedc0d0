(() => {
  const AZIMUTH = -50, ELEVATION = 24, FAR = 12, HIGH = 17, TAKEN = 150;
  const SIDES = [[1, -1], [-1, -1], [1, 1], [-1, 1], [0, -1.6], [0, 1.6], [1.6, 0], [-1.6, 0]];
  const WAYS = [1, 2.2, 3.6, 5.2].flatMap((ring) => SIDES.map(([x, y]) => [x, y, ring]));
  const all = (query, from) => [...from.querySelectorAll(query)];
  const numbers = (text) => text.split(" ").map(Number);
  const round = (value) => Math.round(value * 10) / 10;

  // Turns what hands do to `svg` into calls of `view`: turn, move, zoom and reset.
  const handle = (svg, view) => {
    svg.setAttribute("tabindex", "0");
    const pointers = new Map();
    const spread = () => {
      const [one, other] = [...pointers.values()];
      return other ? Math.hypot(one.x - other.x, one.y - other.y) : 0;
    };
    svg.addEventListener("contextmenu", (event) => event.preventDefault());
    svg.addEventListener("pointerdown", (event) => {
      if (event.target.closest("a")) return;
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      svg.setPointerCapture(event.pointerId);
      svg.classList.add("turning");
    });
    svg.addEventListener("pointermove", (event) => {
      const last = pointers.get(event.pointerId);
      if (!last) return;
      const before = spread();
      const by = [event.clientX - last.x, event.clientY - last.y];
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      const scale = view.unit();
      if (before && spread()) view.zoom(spread() / before);
      if (before || event.shiftKey || event.buttons > 1) view.move(by[0] * scale, by[1] * scale);
      else view.turn(by[0] * scale, by[1] * scale);
    });
    for (const end of ["pointerup", "pointercancel"])
      svg.addEventListener(end, (event) => {
        pointers.delete(event.pointerId);
        if (!pointers.size) svg.classList.remove("turning");
      });
    svg.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !event.metaKey && document.activeElement !== svg) return;
      event.preventDefault();
      view.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), event);
    }, { passive: false });
    svg.addEventListener("keydown", (event) => {
      const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
      const by = arrows[event.key];
      if (event.target !== svg || event.ctrlKey || event.metaKey || event.altKey) return;
      if (by && event.shiftKey) view.move(-by[0] * 24, -by[1] * 24);
      else if (by) view.turn(by[0] * 24, by[1] * 24);
      else if (event.key === "+" || event.key === "=") view.zoom(1.25);
      else if (event.key === "-") view.zoom(0.8);
      else if (event.key === "0") view.reset();
      else return;
      event.preventDefault();
    });
  };

  const tools = (svg, name, buttons) => {
    const bar = document.createElement("div");
    bar.className = "tools";
    bar.setAttribute("role", "toolbar");
    bar.setAttribute("aria-label", name);
    for (const [label, title, act] of buttons) {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = label;
      button.title = title;
      button.setAttribute("aria-label", title);
      button.addEventListener("click", act);
      bar.append(button);
    }
    svg.closest("figure").append(bar);
  };

  const figure = (svg) => {
    const box = svg.viewBox.baseVal;
    const paths = all("[data-p]", svg).map((path) => [path, numbers(path.dataset.p), path.getAttribute("d").endsWith("z")]);
    const spots = all("[data-at]:not(.flag)", svg).map((spot) => [spot, numbers(spot.dataset.at)]);
    const tags = all(".flag", svg).map((tag) => ({ tag, at: numbers(tag.dataset.at), width: Number(tag.dataset.w),
      leader: tag.querySelector(".leader"), pill: tag.querySelector(".pill"), marked: Boolean(tag.querySelector("a")) }));
    const parts = all("[data-z]", svg).map((part) => [part, numbers(part.dataset.z)]);
    const room = parts.length ? parts[0][0].parentNode : null;
    let azimuth, elevation, zoom, x0, y0, waiting = false;

    const draw = () => {
      waiting = false;
      const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
      const [ca, sa, ce, se] = [Math.cos(a), Math.sin(a), Math.cos(e), Math.sin(e)];
      const seen = (p, i = 0) => {
        const near = ca * p[i] + sa * p[i + 1];
        return [x0 + zoom * (ca * p[i + 1] - sa * p[i]), y0 + zoom * (se * near - ce * p[i + 2])];
      };
      const depth = (p) => {
        let sum = 0;
        for (let i = 0; i < p.length; i += 3) sum += ce * (ca * p[i] + sa * p[i + 1]) + se * p[i + 2];
        return sum * 3 / p.length;
      };
      for (const [path, p, closed] of paths) {
        const way = [];
        for (let i = 0; i < p.length; i += 3) way.push(seen(p, i).map(round).join(" "));
        path.setAttribute("d", `M${way.join("L")}${closed ? "z" : ""}`);
      }
      for (const [spot, p] of spots) spot.setAttribute("transform", `translate(${seen(p).map(round).join(" ")})`);
      if (room) room.append(...parts.map(([part, p]) => [depth(p), part]).sort((one, other) => one[0] - other[0]).map(([, part]) => part));
      place(seen);
    };
    const place = (seen) => {
      const taken = [];
      const edge = (x, y, width) => [x - width / 2 - 1, y - HIGH / 2 - 1, x + width / 2 + 1, y + HIGH / 2 + 1];
      const over = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
      for (const { tag, at, width, leader, pill, marked } of tags) {
        const [x, y] = seen(at);
        let spot = null;
        if (width && taken.length < TAKEN)
          for (const [across, down, ring] of WAYS) {
            const middle = [x + across * (FAR * ring + (across ? width / 2 : 0)), y + down * FAR * ring];
            const inside = Math.abs(middle[0] - box.x - box.width / 2) < (box.width - width) / 2 &&
              Math.abs(middle[1] - box.y - box.height / 2) < (box.height - HIGH) / 2;
            const edges = edge(...middle, width);
            if (inside && !taken.some((other) => over(edges, other))) { spot = middle; taken.push(edges); break; }
          }
        tag.classList.toggle("crowded", !spot && !marked);
        spot ??= [x, y];
        pill.setAttribute("transform", `translate(${spot.map(round).join(" ")})`);
        leader.setAttribute("d", `M${round(x)} ${round(y)}L${spot.map(round).join(" ")}`);
      }
    };
    const later = () => { if (!waiting) { waiting = true; requestAnimationFrame(draw); } };
    const look = (from, above) => { [azimuth, elevation, zoom, x0, y0] = [from, above, 1, 0, 0]; later(); };
    const view = {
      unit: () => box.width / Math.max(1, svg.getBoundingClientRect().width),
      turn(x, y) { azimuth -= x * 0.4; elevation = Math.max(-90, Math.min(90, elevation + y * 0.4)); later(); },
      move(x, y) { x0 += x; y0 += y; later(); },
      zoom(by) { const next = Math.max(0.2, Math.min(60, zoom * by)); x0 *= next / zoom; y0 *= next / zoom; zoom = next; later(); },
      reset: () => look(AZIMUTH, ELEVATION),
    };
    [azimuth, elevation, zoom, x0, y0] = [AZIMUTH, ELEVATION, 1, 0, 0];
    handle(svg, view);
    tools(svg, "View of the figure", [
      ["+", "Zoom in", () => view.zoom(1.25)], ["−", "Zoom out", () => view.zoom(0.8)],
      ["Front", "Look from the front, along x", () => look(0, 0)], ["Side", "Look from the side, along y", () => look(-90, 0)],
      ["Top", "Look from above", () => look(-90, 90)], ["Reset", "Reset the view", view.reset],
    ]);
  };

  const tree = (svg) => {
    const [width, height] = [svg.width.baseVal.value, svg.height.baseVal.value];
    const canvas = svg.closest(".canvas");
    const root = svg.querySelector("g.link > rect, g.absent > rect")?.getBBox() ?? { x: 0, y: 0, width, height };
    canvas.classList.add("live");
    if (!svg.closest(".views").querySelector("svg.stick")) canvas.style.height = `${Math.min(440, height * 1.2)}px`;
    let x, y, scale;
    const size = () => [Math.max(1, canvas.clientWidth), Math.max(1, canvas.clientHeight)];
    const show = () => {
      const [w, h] = size();
      svg.setAttribute("width", w);
      svg.setAttribute("height", h);
      svg.setAttribute("viewBox", [x, y, w * scale, h * scale].map(round).join(" "));
    };
    // Puts all of the tree into the middle, or else its root as near to it as there is tree around.
    const begin = (seen, whole, middle) =>
      seen >= whole ? (whole - seen) / 2 : Math.max(0, Math.min(whole - seen, middle - seen / 2));
    const look = (wanted) => {
      const [w, h] = size();
      scale = wanted;
      x = begin(w * scale, width, root.x + root.width / 2);
      y = begin(h * scale, height, root.y + root.height / 2);
      show();
    };
    const fitting = () => { const [w, h] = size(); return Math.max(width / w, height / h, 0.75); };
    const fit = () => look(fitting());
    const view = {
      unit: () => scale,
      turn(dx, dy) { view.move(dx, dy); },
      move(dx, dy) { x -= dx; y -= dy; show(); },
      zoom(by, event) {
        const next = Math.max(0.15, Math.min(40, scale / by));
        const [w, h] = size();
        const here = event ? svg.getBoundingClientRect() : null;
        const at = here ? [event.clientX - here.left, event.clientY - here.top] : [w / 2, h / 2];
        x += at[0] * (scale - next);
        y += at[1] * (scale - next);
        scale = next;
        show();
      },
      reset: fit,
    };
    look(Math.min(fitting(), 1.5));
    handle(svg, view);
    tools(svg, "View of the tree", [
      ["+", "Zoom in", () => view.zoom(1.25)], ["−", "Zoom out", () => view.zoom(0.8)],
      ["1:1", "Show the tree in its own size", () => look(1)], ["Fit", "Show all of the tree", fit],
    ]);
    addEventListener("resize", show);
  };

  for (const svg of all("svg.stick", document)) figure(svg);
  const started = new WeakSet();
  const start = (from) => {
    for (const svg of all(".canvas svg.robot", from)) {
      if (started.has(svg) || !svg.getClientRects().length) continue;
      started.add(svg);
      tree(svg);
    }
  };
  start(document);
  for (const card of all("details.robot-card", document)) card.addEventListener("toggle", () => start(card));
  for (const button of all("button.unfold", document)) {
    button.hidden = false;
    button.addEventListener("click", () => {
      const open = button.dataset.open === "1";
      for (const each of all("details", button.closest(".outline"))) each.open = open;
      button.dataset.open = open ? "0" : "1";
      button.textContent = open ? "Fold all" : "Unfold all";
    });
  }
})();
