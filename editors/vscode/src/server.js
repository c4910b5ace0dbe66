// The client of `tip lsp`.
import * as vscode from 'vscode';
import { LanguageClient } from 'vscode-languageclient/node';
import { tip } from './tip.js';

export class Server {
  async start() {
    const command = await tip();
    if (command === undefined) return;
    const options = {
      documentSelector: ['file', 'untitled'].map((scheme) => ({ scheme, language: 'tip' })),
      initializationOptions: { robot: vscode.workspace.getConfiguration('tip').get('robot') },
      synchronize: { configurationSection: 'tip' },
    };
    this.client = new LanguageClient('tip', 'T.I.P.', { command, args: ['lsp'] }, options);
    await this.client.start();
  }

  async stop() {
    await this.client?.dispose();
    this.client = undefined;
  }

  async restart() {
    await this.stop();
    await this.start();
  }

  /** What tip.toml says of a file's encoding. */
  async encodingOf(uri) {
    if (!this.client?.isRunning()) return undefined;
    // An older tip has no answer.
    const answer = await this.client.sendRequest('tip/encoding', { uri: uri.toString() }).catch(() => undefined);
    return answer ?? undefined;
  }
}
