// T.I.P. in VS Code: everything about the language comes from the command `tip`.
import * as vscode from 'vscode';
import * as debug from './debug.js';
import * as encoding from './encoding.js';
import { Server } from './server.js';
import * as tasks from './tasks.js';

let server;

export async function activate(context) {
  server = new Server();
  context.subscriptions.push(
    vscode.commands.registerCommand('tip.restart', () => server.restart()),
    vscode.workspace.onDidChangeConfiguration((event) => {
      if (event.affectsConfiguration('tip.path')) server.restart();
    }),
  );
  debug.register(context);
  tasks.register(context);
  const started = server.start();
  encoding.register(context, (uri) => started.then(() => server.encodingOf(uri)));
  await started;
}

export async function deactivate() {
  await server?.stop();
}
