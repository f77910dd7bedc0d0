import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { robotPage } from "../src/robotPage";
import { rulePages } from "../src/rulePages";
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

test("the page of a robot has its picture and runs nothing", () => {
  const page = robotPage("a<b>.urdf", '<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg"/>');
  assert.match(page, /default-src 'none'/);
  assert.match(page, /<title>a&lt;b&gt;\.urdf<\/title>/);
  assert.match(page, /<svg xmlns/);
  assert.doesNotMatch(page, /<\?xml/);
  assert.match(robotPage("a.srdf", null), /describes no robot/);
});

test("the rules of what was found, each once", () => {
  const finding = (code: string, source = "kinlint") => ({
    source,
    message: `about ${code}`,
    code: { value: code, target: `https://${code}` },
  });
  const found = rulePages([finding("LIM001"), finding("FRM007"), finding("LIM001"), finding("X", "other")]);
  assert.deepEqual(
    found.map((each) => each.code),
    ["FRM007", "LIM001"],
  );
  assert.equal(found[0]?.address, "https://FRM007");
});

test("every command is registered", () => {
  const source = readFileSync(join(__dirname, "..", "..", "..", "src", "extension.ts"), "utf-8");
  for (const { command } of manifest.contributes.commands) {
    assert.ok(source.includes(`registerCommand("${command}"`), command);
  }
});
