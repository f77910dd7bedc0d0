// Handles the first figure of a page as people do, and writes what comes of it into the title.
// A browser without a screen draws frames when it likes.
globalThis.requestAnimationFrame = (draw) => setTimeout(draw, 0);
const frame = () => new Promise((done) => setTimeout(done, 5));
const svg = document.querySelector("svg.stick");
const ways = () => [...svg.querySelectorAll("[data-p]")].map((each) => each.getAttribute("d"));
const press = (key, more = {}) => svg.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, ...more }));
const pointer = (type, x, y) => svg.dispatchEvent(new PointerEvent(type,
  { pointerId: 1, clientX: x, clientY: y, buttons: 1, bubbles: true }));
const crossing = () => {
  const boxes = [...svg.querySelectorAll(".flag:not(.crowded) rect")].map((each) => each.getBoundingClientRect());
  const whole = svg.getBoundingClientRect();
  return boxes.some((a, i) => a.left < whole.left || a.right > whole.right || a.top < whole.top || a.bottom > whole.bottom
    || boxes.slice(0, i).some((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom));
};
(async () => {
  svg.setPointerCapture = () => {};
  const said = { drawn: ways(), crossed: crossing() };
  svg.focus();
  for (let turn = 0; turn < 24; turn++) { press("ArrowRight"); await frame(); said.crossed ||= crossing(); }
  said.turned = ways();
  press("0"); await frame();
  said.reset = ways();
  press("ArrowUp", { shiftKey: true }); await frame();
  said.moved = ways();
  press("0"); press("+"); await frame();
  said.zoomed = ways();
  press("0"); await frame();
  pointer("pointerdown", 100, 100); pointer("pointermove", 160, 100); pointer("pointerup", 160, 100); await frame();
  said.dragged = ways();
  press("0"); await frame();
  svg.dispatchEvent(new WheelEvent("wheel", { deltaY: -200, ctrlKey: true, bubbles: true, cancelable: true })); await frame();
  said.wheeled = ways();
  const tree = document.querySelector(".canvas svg");
  const before = tree.getAttribute("viewBox");
  tree.closest("figure").querySelector(".tools button").click();
  said.tree = [before, tree.getAttribute("viewBox")];
  document.querySelector('.more a[href^="#robot0-figure"]').click(); await frame();
  said.aimed = document.querySelector(".flag.aimed")?.id;
  document.title = JSON.stringify(said);
})().catch((error) => { document.title = String(error.stack); });
