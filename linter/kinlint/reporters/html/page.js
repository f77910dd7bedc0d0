
"use strict";
(() => {
  const all = (query, from = document) => [...from.querySelectorAll(query)];
  const findings = all("article.finding");
  const form = document.querySelector("form.filter");
  if (form) {
    const box = form.querySelector("#filter");
    const kinds = all('input[type="checkbox"]', form);
    const shown = form.querySelector("#shown");
    const unfold = form.querySelector("#unfold");
    const texts = new Map();
    const said = (each) => {
      if (!texts.has(each)) {
        const file = each.closest("section.file").querySelector("h3").textContent;
        texts.set(each, (file + " " + each.textContent).toLowerCase());
      }
      return texts.get(each);
    };
    const apply = () => {
      const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
      const wanted = kinds.filter((each) => each.checked).map((each) => each.value);
      let count = 0;
      for (const each of findings) {
        const kept = wanted.some((kind) => each.classList.contains(kind)) &&
          words.every((word) => said(each).includes(word));
        each.hidden = !kept;
        count += kept;
      }
      for (const file of all("section.file"))
        file.hidden = !file.querySelector("article:not([hidden])");
      shown.textContent = `${count} of ${findings.length} shown`;
    };
    form.hidden = false;
    form.addEventListener("submit", (event) => event.preventDefault());
    form.addEventListener("input", apply);
    const folded = () => findings.some((each) => !each.firstElementChild.open);
    const name = () => { unfold.textContent = folded() ? "Unfold all" : "Fold all"; };
    unfold.addEventListener("click", () => {
      const open = folded();
      for (const each of findings) each.firstElementChild.open = open;
      name();
    });
    name();
    apply();
  }
  for (const button of all("button.copy")) {
    button.hidden = false;
    button.addEventListener("click", async () => {
      const text = button.nextElementSibling.textContent;
      try {
        await navigator.clipboard.writeText(text);
        button.textContent = "Copied";
      } catch {
        getSelection().selectAllChildren(button.nextElementSibling);
        button.textContent = "Selected";
      }
      setTimeout(() => { button.textContent = "Copy"; }, 2000);
    });
  }
  const reveal = (address) => {
    const target = address.length > 1 && document.getElementById(decodeURIComponent(address.slice(1)));
    if (!target) return;
    for (const each of all(".aimed")) each.classList.remove("aimed");
    target.classList.add("aimed");
    target.hidden = false;
    if (target.closest("section.file")) target.closest("section.file").hidden = false;
    const fold = target.matches("details") ? target : target.querySelector("details");
    if (fold && !target.matches("section")) fold.open = true;
    if (target.closest("details")) target.closest("details").open = true;
    (target.closest("figure") ?? target).scrollIntoView();
  };
  addEventListener("hashchange", () => reveal(location.hash));
  document.addEventListener("click", (event) => {
    const link = event.target.closest('a[href^="#"]');
    if (!link) return;
    if (location.protocol === "vscode-webview:") {
      // Pages in this editor have no address of their own, and it takes links of SVG for foreign ones.
      event.preventDefault();
      event.stopPropagation();
    }
    setTimeout(reveal, 0, link.getAttribute("href"));
  }, true);
  reveal(location.hash);
})();
