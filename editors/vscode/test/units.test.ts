import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { robotPage, themeOf, type Theme } from "../src/robotPage";
import { RobotViews, type Panel } from "../src/robotView";
import { RULE_SCHEME, ruleOfAddress, rulePageAddress, rulePages } from "../src/rulePages";
import { SERVER_SETTINGS, serverCommand, serverSettings } from "../src/settings";

const manifest = JSON.parse(readFileSync(join(__dirname, "..", "..", "..", "package.json"), "utf-8"));
const properties: Record<string, { default: unknown }> = manifest.contributes.configuration.properties;

test("only settings of the server are sent, and none that is not set", () => {
  const all = { command: ["kinlint"], trace: { server: "off" }, run: "onSave", select: null, ignore: ["LIM"] };
  assert.deepEqual(serverSettings(all), { run: "onSave", ignore: ["LIM"] });
});

test("every setting of the server is one of the extension", () => {
  for (const name of SERVER_SETTINGS) {
    assert.ok(`kinlint.${name}` in properties, name);
  }
});

test("the command of the server", () => {
  const standard = serverCommand(properties["kinlint.command"]?.default);
  assert.deepEqual(standard, { command: "kinlint", args: ["server"] });
  assert.throws(() => serverCommand([]), /kinlint.command/);
  assert.throws(() => serverCommand("kinlint server"), /kinlint.command/);
  assert.throws(() => serverCommand(["kinlint", 1]), /kinlint.command/);
});

test("a page of the server is shown as it is, and its lack is explained", () => {
  const page = "<!DOCTYPE html><html></html>";
  assert.equal(robotPage("a.urdf", page), page);
  const nothing = robotPage("a<b>.srdf", null);
  assert.match(nothing, /default-src 'none'/);
  assert.match(nothing, /<title>a&lt;b&gt;\.srdf<\/title>/);
  assert.match(nothing, /a&lt;b&gt;\.srdf describes no robot/);
  assert.match(robotPage("a.urdf", null, "<b>"), /cannot be shown: &lt;b&gt;/);
});

test("a page has the theme of the window", () => {
  assert.deepEqual([1, 2, 3, 4].map(themeOf), ["light", "dark", "dark", "light"]);
});

/** Panel that counts how often it is drawn. */
class FakePanel implements Panel {
  readonly pages: string[] = [];
  revealed = 0;
  close: () => void = () => undefined;
  readonly webview: { html: string };

  constructor(readonly name: string) {
    const pages = this.pages;
    this.webview = {
      get html() {
        return pages.at(-1) ?? "";
      },
      set html(page: string) {
        pages.push(page);
      },
    };
  }

  reveal(): void {
    this.revealed++;
  }

  onDidDispose(listener: () => void): void {
    this.close = listener;
  }
}

function views(answer: (uri: string, theme: Theme) => Promise<string | null>) {
  const panels: FakePanel[] = [];
  let theme: Theme = "light";
  const made = new RobotViews(
    answer,
    (name) => {
      panels.push(new FakePanel(name));
      return panels.at(-1)!;
    },
    () => theme,
  );
  return { made, panels, become: (next: Theme) => (theme = next) };
}

const ARM = { uri: "file:///arm.urdf", name: "arm.urdf" };

test("a robot has one view, which is drawn anew when something changes", async () => {
  let version = 1;
  const { made, panels, become } = views(async (uri, theme) => `${uri} ${theme} ${version}`);
  await made.show(ARM);
  await made.show(ARM);
  version = 2;
  await made.drawAll();
  become("dark");
  await made.drawAll();
  assert.equal(panels.length, 1);
  assert.equal(panels[0]?.revealed, 1);
  assert.deepEqual(panels[0]?.pages, [
    "file:///arm.urdf light 1",
    "file:///arm.urdf light 2",
    "file:///arm.urdf dark 2",
  ]);
});

test("a view that is closed is not drawn, and opened again is a new one", async () => {
  let arrive: (page: string) => void = () => undefined;
  const { made, panels } = views(() => new Promise((resolve) => (arrive = resolve)));
  const shown = made.show(ARM);
  panels[0]?.close();
  arrive("late");
  await shown;
  await made.drawAll();
  assert.deepEqual(panels[0]?.pages, []);
  const again = made.show(ARM);
  arrive("now");
  await again;
  assert.equal(panels.length, 2);
  assert.deepEqual(panels[1]?.pages, ["now"]);
});

test("an answer that a later one overtook is not shown", async () => {
  const waiting: ((page: string) => void)[] = [];
  const { made, panels } = views(() => new Promise((resolve) => waiting.push(resolve)));
  const first = made.show(ARM);
  const second = made.drawAll();
  waiting[1]?.("new");
  await second;
  waiting[0]?.("old");
  await first;
  assert.deepEqual(panels[0]?.pages, ["new"]);
});

test("a server that fails is told in the view", async () => {
  const { made, panels } = views(() => Promise.reject(new Error("it <died>")));
  await made.show(ARM);
  assert.match(panels[0]?.pages[0] ?? "", /arm\.urdf cannot be shown: it &lt;died&gt;/);
});

test("the rules of what was found, each once", () => {
  const finding = (code: string, source = "kinlint") => ({ source, message: `about ${code}`, code: { value: code } });
  const found = rulePages([finding("LIM001"), finding("FRM007"), finding("LIM001"), finding("X", "other")]);
  assert.deepEqual(
    found.map((each) => each.code),
    ["FRM007", "LIM001"],
  );
  assert.equal(found[0]?.message, "about FRM007");
});

test("the address of a page leads back to its rule and file", () => {
  const address = rulePageAddress("LIM001", "file:///a%20b.urdf");
  assert.equal(address.scheme, RULE_SCHEME);
  assert.deepEqual(ruleOfAddress(address), { code: "LIM001", file: "file:///a%20b.urdf" });
});

test("every command is registered", () => {
  const source = readFileSync(join(__dirname, "..", "..", "..", "src", "extension.ts"), "utf-8");
  for (const { command } of manifest.contributes.commands) {
    assert.ok(source.includes(`registerCommand("${command}"`), command);
  }
});
