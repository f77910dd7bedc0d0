/** Settings of the extension: those for the server, and the command that starts it. */

/** Names of the settings that the server knows, without their section. */
export const SERVER_SETTINGS = [
  "configuration",
  "extendSelect",
  "ignore",
  "run",
  "select",
  "target",
  "trust",
  "unsafeFixes",
] as const;

export const SECTION = "kinlint";

/** Return the settings in `all` that the server knows; null stands for what is not set. */
export function serverSettings(all: Readonly<Record<string, unknown>>): Record<string, unknown> {
  const found: Record<string, unknown> = {};
  for (const name of SERVER_SETTINGS) {
    const value = all[name];
    if (value !== undefined && value !== null) {
      found[name] = value;
    }
  }
  return found;
}

/** Program with its arguments. */
export interface Command {
  readonly command: string;
  readonly args: readonly string[];
}

/** Return the program and arguments that the setting `command` has; throws if it has none. */
export function serverCommand(setting: unknown): Command {
  const words = Array.isArray(setting) ? setting : [];
  const [command, ...args] = words.filter((each): each is string => typeof each === "string");
  if (!command || words.length !== args.length + 1) {
    throw new Error('the setting kinlint.command must be a list of words, such as ["kinlint", "server"]');
  }
  return { command, args };
}
