/** Extension for VS Code: starts the server, and shows robots and rule pages. */

import * as vscode from "vscode";
import { LanguageClient, type LanguageClientOptions } from "vscode-languageclient/node";

import { themeOf, type Theme } from "./robotPage";
import { RobotViews } from "./robotView";
import { RULE_SCHEME, ruleOfAddress, rulePageAddress, rulePages } from "./rulePages";
import { SECTION, serverCommand, serverSettings } from "./settings";

const FILES = "**/*.{urdf,xacro,srdf,sdf,world,jsonld,json,ttl,nq,yaml,yml,rviz,dae,usda,launch,launch.py,launch.xml}";
const CONFIGURATION = "**/{kinlint.toml,.kinlint.toml,pyproject.toml,package.xml}";

let client: LanguageClient | undefined;
let watchers: vscode.FileSystemWatcher[] = [];
const robots = new RobotViews(askForRobot, robotPanel, () => themeOf(vscode.window.activeColorTheme.kind));

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  context.subscriptions.push(
    vscode.commands.registerCommand("kinlint.openRobot", openRobot),
    vscode.commands.registerCommand("kinlint.openRulePage", openRulePage),
    vscode.commands.registerCommand("kinlint.restart", restart),
    vscode.workspace.registerTextDocumentContentProvider(RULE_SCHEME, { provideTextDocumentContent: askForRulePage }),
    vscode.workspace.onDidSaveTextDocument(() => robots.drawAll()),
    vscode.window.onDidChangeActiveColorTheme(() => robots.drawAll()),
    vscode.workspace.onDidChangeConfiguration(async (event) => {
      if (event.affectsConfiguration(`${SECTION}.command`)) {
        await restart();
      }
    }),
  );
  await start();
}

export async function deactivate(): Promise<void> {
  await stop();
}

async function start(): Promise<void> {
  try {
    client = newClient();
    await client.start();
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    void vscode.window.showErrorMessage(
      `kinlint does not start: ${reason}. "pip install kinlint" installs it; the setting kinlint.command says how it is called.`,
    );
  }
}

/** Stop the server; one that never started cannot be stopped, which is no fault. */
async function stop(): Promise<void> {
  const running = client;
  client = undefined;
  await running?.stop().catch(() => undefined);
  watchers.forEach((each) => each.dispose());
  watchers = [];
}

async function restart(): Promise<void> {
  await stop();
  await start();
}

function newClient(): LanguageClient {
  const { command, args } = serverCommand(vscode.workspace.getConfiguration(SECTION).get("command"));
  watchers = [FILES, CONFIGURATION].map((each) => vscode.workspace.createFileSystemWatcher(each));
  const options: LanguageClientOptions = {
    documentSelector: [
      { language: "xml" },
      { language: "json" },
      { language: "jsonld" },
      { language: "turtle" },
      { pattern: FILES },
    ],
    initializationOptions: settings(),
    synchronize: {
      configurationSection: SECTION,
      fileEvents: watchers,
    },
    middleware: {
      workspace: {
        configuration: async (params, token, next) => {
          const found = await next(params, token);
          return Array.isArray(found) ? found.map((each) => (isRecord(each) ? serverSettings(each) : each)) : found;
        },
        didChangeConfiguration: async () => {
          await client?.sendNotification("workspace/didChangeConfiguration", { settings: { kinlint: settings() } });
        },
      },
    },
  };
  const run = { command, args: [...args] };
  return new LanguageClient(SECTION, "kinlint", { run, debug: run }, options);
}

function settings(): Record<string, unknown> {
  const section = vscode.workspace.getConfiguration().get(SECTION);
  return serverSettings(isRecord(section) ? section : {});
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** Show the robot of the active file beside it. */
async function openRobot(): Promise<void> {
  const document = vscode.window.activeTextEditor?.document;
  if (document === undefined) {
    void vscode.window.showInformationMessage("Open the file of a robot to show it.");
    return;
  }
  await robots.show({ uri: document.uri.toString(), name: vscode.workspace.asRelativePath(document.uri) });
}

function robotPanel(name: string): vscode.WebviewPanel {
  return vscode.window.createWebviewPanel(
    "kinlint.robot",
    name,
    { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
    { enableScripts: true, enableFindWidget: true, localResourceRoots: [] },
  );
}

async function askForRobot(uri: string, theme: Theme): Promise<string | null> {
  if (client === undefined) {
    throw new Error("the server of kinlint does not run");
  }
  return client.sendRequest<string | null>("workspace/executeCommand", {
    command: "kinlint.showRobotPage",
    arguments: [uri, theme],
  });
}

/** Show the page of a rule of which something was found in the active file, as its server has it. */
async function openRulePage(): Promise<void> {
  const document = vscode.window.activeTextEditor?.document;
  if (document === undefined) {
    void vscode.window.showInformationMessage("Open a file with findings to read about their rules.");
    return;
  }
  const found = rulePages(vscode.languages.getDiagnostics(document.uri));
  const items = found.map((each) => ({ label: each.code, description: each.message }));
  const chosen = await vscode.window.showQuickPick(items, { placeHolder: "Rule" });
  if (chosen !== undefined) {
    const address = vscode.Uri.from(rulePageAddress(chosen.label, document.uri.toString()));
    await vscode.commands.executeCommand("markdown.showPreviewToSide", address);
  }
}

async function askForRulePage(address: vscode.Uri): Promise<string> {
  const { code, file } = ruleOfAddress(address);
  const page = await client?.sendRequest<string | null>("workspace/executeCommand", {
    command: "kinlint.showRulePage",
    arguments: [file, code],
  });
  return page ?? `The server of kinlint has no rule ${code}.`;
}
