/** Pages of rules that findings lead to. */

/** Part of a diagnostic that names the rule. */
export interface Coded {
  readonly source?: string;
  readonly message: string;
  readonly code?: string | number | { readonly value: string | number; readonly target: unknown };
}

/** Rule with the address of its page. */
export interface RulePage<Address> {
  readonly code: string;
  readonly message: string;
  readonly address: Address;
}

/** Return the rules that `diagnostics` of kinlint are about, each once, in order of the codes. */
export function rulePages<Address>(diagnostics: readonly Coded[]): RulePage<Address>[] {
  const found = new Map<string, RulePage<Address>>();
  for (const { source, code, message } of diagnostics) {
    if (source === "kinlint" && typeof code === "object") {
      const value = String(code.value);
      if (!found.has(value)) {
        found.set(value, { code: value, message, address: code.target as Address });
      }
    }
  }
  return [...found.values()].sort((one, other) => (one.code < other.code ? -1 : 1));
}
