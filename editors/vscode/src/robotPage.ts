/** Pages of the view of a robot. */

/** Theme of a page of the server. */
export type Theme = "dark" | "light";

/** Number of each kind of theme of VS Code, as `vscode.ColorThemeKind` has it. */
const DARK = 2;
const HIGH_CONTRAST = 3;

/** Return the theme that a page has in a window of the colour theme `kind`. */
export function themeOf(kind: number): Theme {
  return kind === DARK || kind === HIGH_CONTRAST ? "dark" : "light";
}

/** Return `page` of the server as it is, which brings a policy of its own, or one that says why there is none. */
export function robotPage(name: string, page: string | null | undefined, error?: string): string {
  const reason = error === undefined ? `${name} describes no robot.` : `${name} cannot be shown: ${error}`;
  return page
    ? page
    : `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'">
<title>${escaped(name)}</title>
</head>
<body>
<p>${escaped(reason)}</p>
</body>
</html>
`;
}

/** Return `text` with the characters replaced that mean something in HTML. */
export function escaped(text: string): string {
  const entities: Record<string, string> = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };
  return text.replace(/[&<>"]/g, (character) => entities[character] ?? character);
}
