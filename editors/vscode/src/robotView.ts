/** Views of robots beside their files: one of each file, drawn anew when it is saved or the theme changes. */

import { robotPage, type Theme } from "./robotPage";

/** Part of a panel of VS Code that a view needs. */
export interface Panel {
  readonly webview: { html: string };
  reveal(viewColumn: undefined, preserveFocus: boolean): void;
  onDidDispose(listener: () => void): unknown;
}

/** File with the name that people know it by. */
export interface File {
  readonly uri: string;
  readonly name: string;
}

/** View of one robot. */
interface View {
  readonly file: File;
  readonly panel: Panel;
  drawn: number;
}

export class RobotViews {
  private readonly views = new Map<string, View>();

  /** `ask` requests the page of a file from the server, `create` makes an empty panel. */
  constructor(
    private readonly ask: (uri: string, theme: Theme) => Promise<string | null | undefined>,
    private readonly create: (name: string) => Panel,
    private readonly theme: () => Theme,
  ) {}

  /** Show the robot in `file`; in the view that there is, if it is shown already. */
  async show(file: File): Promise<void> {
    const known = this.views.get(file.uri);
    if (known !== undefined) {
      known.panel.reveal(undefined, true);
      return this.draw(known);
    }
    const view: View = { file, panel: this.create(file.name), drawn: 0 };
    this.views.set(file.uri, view);
    view.panel.onDidDispose(() => this.views.delete(file.uri));
    return this.draw(view);
  }

  /** Draw all views anew: what a file says may concern the robots of others. */
  async drawAll(): Promise<void> {
    await Promise.all([...this.views.values()].map((view) => this.draw(view)));
  }

  /** Draw `view`, unless it is closed or asked for again before the server answers. */
  private async draw(view: View): Promise<void> {
    const turn = ++view.drawn;
    let page: string;
    try {
      page = robotPage(view.file.name, await this.ask(view.file.uri, this.theme()));
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      page = robotPage(view.file.name, null, reason);
    }
    if (turn === view.drawn && this.views.get(view.file.uri) === view && view.panel.webview.html !== page) {
      view.panel.webview.html = page;
    }
  }
}
