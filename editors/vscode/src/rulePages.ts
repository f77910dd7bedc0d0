/** Pages of rules that findings lead to. */

/** Scheme of the addresses of pages that the server writes. */
export const RULE_SCHEME = "kinlint-rule";

/** Part of a diagnostic that names the rule. */
export interface Coded {
  readonly source?: string;
  readonly message: string;
  readonly code?: string | number | { readonly value: string | number };
}

/** Rule, with what was found first by it. */
export interface RulePage {
  readonly code: string;
  readonly message: string;
}

/** Return the rules that `diagnostics` of kinlint are about, each once, in order of the codes. */
export function rulePages(diagnostics: readonly Coded[]): RulePage[] {
  const found = new Map<string, RulePage>();
  for (const { source, code, message } of diagnostics) {
    if (source === "kinlint" && typeof code === "object") {
      const value = String(code.value);
      if (!found.has(value)) {
        found.set(value, { code: value, message });
      }
    }
  }
  return [...found.values()].sort((one, other) => (one.code < other.code ? -1 : 1));
}

/** Return the parts of the address of the page of the rule `code` in the project of `file`. */
export function rulePageAddress(code: string, file: string) {
  return { scheme: RULE_SCHEME, path: `${code}.md`, query: file };
}

/** Return the rule and the file that the address of a page names. */
export function ruleOfAddress(address: { readonly path: string; readonly query: string }) {
  return { code: address.path.replace(/\.md$/, ""), file: address.query };
}
