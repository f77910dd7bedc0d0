/** Page that shows the picture of a robot. */

/** Return the page of the robot in `name`, whose picture is the text of an SVG, or undefined. */
export function robotPage(name: string, svg: string | null | undefined): string {
  const shown = svg ? withoutProlog(svg) : `<p>${escaped(name)} describes no robot.</p>`;
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>${escaped(name)}</title>
<style>body { background: white; color: black } svg { max-width: 100%; height: auto }</style>
</head>
<body>
${shown}
</body>
</html>
`;
}

function withoutProlog(svg: string): string {
  const start = svg.indexOf("<svg");
  return start < 0 ? svg : svg.slice(start);
}

/** Return `text` with the characters replaced that mean something in HTML. */
export function escaped(text: string): string {
  const entities: Record<string, string> = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };
  return text.replace(/[&<>"]/g, (character) => entities[character] ?? character);
}
